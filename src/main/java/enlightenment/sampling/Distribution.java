package enlightenment.sampling;

import enlightenment.math.InvalidValueException;
import java.util.List;

/**
 * A family of symmetric densities of one real variable z, standardised to mean 0 and standard deviation 1. These are the
 * paper's proposals; {@code docs/notes/distributions.md} has formulas, sources and the relation to the original. Immutable.
 *
 * <p>Only correctly rounded operations and {@link StrictMath} are used: the same bits on every machine.
 */
public sealed interface Distribution permits NormalDistribution, ZetaDistribution, LinearDistribution {
    /** The names that {@link #of} accepts, the default first. */
    List<String> NAMES = List.of("normal", "zeta", "linear");

    /**
     * The family of this name.
     *
     * @throws InvalidValueException (key {@code proposal}) if it is not one of {@link #NAMES}
     */
    static Distribution of(String name) {
        if ("normal".equals(name)) {
            return NormalDistribution.INSTANCE;
        }
        if ("zeta".equals(name)) {
            return ZetaDistribution.INSTANCE;
        }
        if ("linear".equals(name)) {
            return LinearDistribution.INSTANCE;
        }
        throw new InvalidValueException("proposal", "must be one of " + NAMES + ", not " + name);
    }

    /** One of {@link #NAMES}. */
    String name();

    /** The density at z, at least 0; its integral over the line is 1. Relative error below 1e-12 unless it underflows. */
    double density(double z);

    /**
     * The integral of the density from −∞ to z, in 0..1. Below 0 its relative error is under 1e-13 unless it underflows,
     * so small tails are accurate; above 0 its absolute error is under 3e-16: for an upper tail, use −z.
     */
    double cumulative(double z);

    /**
     * The z at which {@link #cumulative} is p; 0 gives the lower end of the support and 1 the upper one, which may be infinite. The
     * error is that of p being off by a few units in the last place.
     *
     * @throws IllegalArgumentException if p is not in 0..1
     */
    double quantile(double p);
}
