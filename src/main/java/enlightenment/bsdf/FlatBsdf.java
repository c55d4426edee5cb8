package enlightenment.bsdf;

/**
 * A Bsdf as plain numbers, for code on another device that computes what the Bsdf does, operation by operation. Which number is what stands
 * beside that code.
 *
 * @param numbers those of its kind; not to be changed
 */
public record FlatBsdf(Kind kind, double... numbers) {
    /** What such code knows. */
    public enum Kind {
        MATTE,
        MIRROR,
        GLASS
    }
}
