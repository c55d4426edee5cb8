package enlightenment.emitter;

/**
 * The technique by which a flat light is sampled from a receiver: a function of the two alone, so that samples and densities agree on it.
 */
enum SamplingChoice {
    UNDECIDED,

    /** The light is seen edge-on, or from behind. */
    ABSENT,

    /** Uniformly over its area, where it is far. */
    AREA,

    /** Uniformly over its solid angle. */
    SOLID_ANGLE
}
