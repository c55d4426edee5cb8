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

    /** The largest cost of finding the level of another number, in rays per rendered pixel. */
    default double planningRays() {
        return 0;
    }
}
