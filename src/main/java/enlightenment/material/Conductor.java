package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Rgb;
import java.util.Objects;

/**
 * The complex index of refraction eta + i k of a metal, relative to what surrounds it, in each band.
 *
 * @param eta the real part, greater than 0
 * @param k the imaginary part, which absorbs
 */
public record Conductor(Rgb eta, Rgb k) {
    /** Validates the components, as {@link Material} states. */
    public Conductor {
        Check.positive("eta", eta.r());
        Check.positive("eta", eta.g());
        Check.positive("eta", eta.b());
        Objects.requireNonNull(k, "k");
    }
}
