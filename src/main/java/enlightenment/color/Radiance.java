package enlightenment.color;

import enlightenment.check.Check;
import java.util.Objects;

/** How much light there may be. All methods may be called by several threads at once. */
public final class Radiance {
    /**
     * The most that a surface or the surroundings may emit, in any band, in the unit of lights: squares and sums of it stay far within the
     * range of doubles, so that errors can be estimated.
     */
    public static final double LARGEST = 1e100;

    private static final String TOO_MUCH = "must be at most 1e100";

    private Radiance() {}

    /** Fails if more than {@link #LARGEST} is emitted in a band; the key is that of the scene format. */
    public static void check(String key, Rgb radiance) {
        Objects.requireNonNull(radiance, key);
        Check.that(radiance.max() <= LARGEST, key, TOO_MUCH);
    }

    /** The same for a single band, which is at least 0. */
    public static void check(String key, double radiance) {
        Check.notNegative(key, radiance);
        Check.that(radiance <= LARGEST, key, TOO_MUCH);
    }
}
