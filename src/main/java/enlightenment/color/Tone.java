package enlightenment.color;

/** How linear light, after exposure, becomes what the transfer curve takes: 0..1. */
public enum Tone {
    /** As it is, cut to 1: what is measured is what is seen. */
    CLIP,

    /**
     * Bent so that highlights fade slowly: x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14) in each channel, cut to 1 (Narkowicz, "ACES
     * filmic tone mapping curve", 2015).
     */
    FILMIC
}
