package enlightenment.plan;

/** The level of a method ({@link RenderPlan#level}) that leads to a number of samples. */
interface Levels {
    /** The number of samples itself. */
    Levels SAMPLES = samples -> Math.max(samples, 1);

    /**
     * The level for this number of samples per pixel in the mean.
     *
     * @throws java.util.concurrent.CancellationException if it is cancelled before that is known
     */
    double of(double samples);

    /** Works out now what all levels have in common. */
    default void prepare() {}

    /** What it costs to know the level of another number, at most, in rays per pixel of what is rendered. */
    default double planningRays() {
        return 0;
    }
}
