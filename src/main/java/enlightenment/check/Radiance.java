package enlightenment.check;

/** How much light there may be. All methods may be called by several threads at once. */
public final class Radiance {
    /**
     * The most that a surface or the surroundings may emit, in any band, in the unit of lights: squares and sums of it stay far within the
     * range of doubles, so that errors can be estimated.
     */
    public static final double LARGEST = 1e100;

    private Radiance() {}

    /** Fails if less than 0 or more than {@link #LARGEST} is emitted in a band; the key is that of the scene format. */
    public static void check(String key, double radiance) {
        Check.notNegative(key, radiance);
        Check.that(radiance <= LARGEST, key, "must be at most 1e100");
    }
}
