package enlightenment.emitter;

/** How a flat light is sampled from a receiver: a function of the two alone, so that samples and densities agree on it. */
enum SamplingChoice {
    UNDECIDED,

    /** The light is seen edge-on, or from behind. */
    ABSENT,

    /** Evenly over its area: where it is far. */
    AREA,

    /** Evenly over the solid angle that it covers. */
    SOLID_ANGLE
}
