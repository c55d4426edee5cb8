package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.color.DisplayRgb;
import java.util.Objects;

/**
 * The paper's cosine shading: with c the surface colour, cosθ the cosine between normal and direction to a light point
 * and k = {@code shadow}, colour = c · light · (ambient + (1 − ambient) · mean of (visible ? 1 : k) · cosθ).
 *
 * @param ambient the share of light that comes from everywhere, 0..1
 * @param shadow how much of the direct light an occluded point keeps, 0..1; 0.5 in the paper
 * @param background what is seen where nothing is
 * @param maxBounces how often a path may be reflected or refracted, 0..1,000,000; beyond that it sees black
 */
public record ClassicShading(double ambient, double shadow, DisplayRgb background, int maxBounces) implements Shading {
    /** The greatest limit on mirrors and glass surfaces that a path may follow. */
    public static final int MAX_BOUNCES = 1_000_000;

    /** The paper's settings: ambient 0.5, shadow 0.5, black background. */
    public static final ClassicShading DEFAULT = new ClassicShading(0.5, 0.5, DisplayRgb.BLACK, 100);

    public ClassicShading {
        Check.range("ambient", ambient, 0, 1);
        Check.range("shadow", shadow, 0, 1);
        Objects.requireNonNull(background, "background");
        Check.that(
                maxBounces >= 0 && maxBounces <= MAX_BOUNCES,
                "maxBounces",
                "must be a whole number in 0.." + MAX_BOUNCES + ", not " + maxBounces);
    }

    @Override
    public Model model() {
        return Model.CLASSIC;
    }
}
