package enlightenment.transport.state;

import enlightenment.bsdf.Reradiation;
import enlightenment.world.PhysicalScene;
import java.util.Arrays;

/**
 * What light of each band that comes to where a path is brings to the eye in each displayed band, for paths that fluorescent surfaces have
 * scattered: light that they turn into another band. So no wavelength is chosen, and none is noisier than without. One per thread.
 *
 * <p>The weights of all other events are those of the path's throughput, and of ultraviolet those of blue.
 */
public final class BandMixing {
    private static final int BANDS = Reradiation.BANDS;
    private static final int SHOWN = 3;

    /** By displayed band, then by band. */
    private final double[] worth = new double[SHOWN * BANDS];

    /** About how much light there is of each band. */
    private final double[] light;

    /** For a thread; null if the scene has no fluorescent surfaces. */
    public static BandMixing of(PhysicalScene scene) {
        return scene.lightOfBands == null ? null : new BandMixing(scene.lightOfBands);
    }

    /** @param light about how much there is of each band, not negative, not all 0 */
    BandMixing(double[] light) {
        this.light = light;
    }

    /** Each displayed band shows light of itself. */
    public void clear() {
        Arrays.fill(worth, 0);
        for (int band = 0; band < SHOWN; band++) {
            worth[BANDS * band + band] = 1;
        }
    }

    /** What light brings to a displayed band. */
    public double of(int band, double r, double g, double b, double ultraviolet) {
        int k = BANDS * band;
        return Math.fma(
                worth[k],
                r,
                Math.fma(worth[k + 1], g, Math.fma(worth[k + 2], b, worth[k + Reradiation.ULTRAVIOLET] * ultraviolet)));
    }

    /** Multiplies what light is worth. */
    public void filter(double r, double g, double b) {
        for (int k = 0; k < worth.length; k += BANDS) {
            worth[k] *= r;
            worth[k + 1] *= g;
            worth[k + 2] *= b;
            worth[k + Reradiation.ULTRAVIOLET] *= b;
        }
    }

    /**
     * The path is scattered by a fluorescent surface of this colour, and goes on as from a white one. What was in its way must have been
     * filtered.
     */
    public void scatter(Reradiation by, double[] color) {
        by.adjoin(color, worth);
    }

    /** The most that a displayed band may get of the light that there is. */
    double most() {
        double most = 0;
        for (int k = 0; k < worth.length; k += BANDS) {
            double sum = 0;
            for (int from = 0; from < BANDS; from++) {
                sum = Math.fma(worth[k + from], light[from], sum);
            }
            most = Math.max(most, sum);
        }
        return most;
    }

    /**
     * As {@link #scatter}, but the path goes on as from a grey surface, whose reflectance says how much less is to be expected of it from
     * here on, so that roulette may go by it.
     *
     * @return that reflectance, 0..1; 0 if nothing is
     */
    double scatterAsGrey(Reradiation by, double[] color) {
        double before = most();
        scatter(by, color);
        double after = most();
        if (!(after > 0)) {
            return 0;
        }
        double scale = after < before ? before / after : 1;
        if (!(scale < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        filter(scale, scale, scale);
        return 1 / scale;
    }
}
