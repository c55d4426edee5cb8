package enlightenment.transport.state;

import enlightenment.bsdf.Reradiation;
import enlightenment.world.PhysicalScene;
import java.util.Arrays;

/**
 * The matrix by which light of each band, emitted or incident at the current vertex, contributes to each displayed band at the eye, for
 * paths scattered by fluorescent surfaces, which re-emit light in other bands. No wavelength is sampled, so that fluorescence adds no
 * spectral noise. One per thread.
 *
 * <p>Weights of all other events are those of the path's throughput; ultraviolet takes those of blue.
 */
public final class BandMixing {
    private static final int BANDS = Reradiation.BANDS;
    private static final int SHOWN = 3;

    /** The matrix in row-major order: a row for each displayed band, a column for each band of light. */
    private final double[] worth = new double[SHOWN * BANDS];

    /** By band, roughly the amount of light in the scene, relative; weighs the columns in {@link #most}. */
    private final double[] light;

    /** Returns the matrix of one thread; null if the scene has no fluorescent surfaces. */
    public static BandMixing of(PhysicalScene scene) {
        return scene.lightOfBands == null ? null : new BandMixing(scene.lightOfBands);
    }

    /**
     * @param light by band, roughly the amount of light in the scene, relative; not negative, not all 0
     */
    BandMixing(double[] light) {
        this.light = light;
    }

    /** Begins a path: the identity matrix, in which each displayed band shows light of itself alone. */
    public void clear() {
        Arrays.fill(worth, 0);
        for (int band = 0; band < SHOWN; band++) {
            worth[BANDS * band + band] = 1;
        }
    }

    /** The contribution of light of these bands at the current vertex to one displayed band at the eye, without the path's throughput. */
    public double of(int band, double r, double g, double b, double ultraviolet) {
        int k = BANDS * band;
        return Math.fma(
                worth[k],
                r,
                Math.fma(worth[k + 1], g, Math.fma(worth[k + 2], b, worth[k + Reradiation.ULTRAVIOLET] * ultraviolet)));
    }

    /** Multiplies by the weight of an event that leaves each band in itself; ultraviolet takes the weight of blue. */
    public void filter(double r, double g, double b) {
        for (int k = 0; k < worth.length; k += BANDS) {
            worth[k] *= r;
            worth[k + 1] *= g;
            worth[k + 2] *= b;
            worth[k + Reradiation.ULTRAVIOLET] *= b;
        }
    }

    /**
     * Multiplies by the reradiation of a fluorescent surface of this colour; the path's throughput goes on as at a white surface. Weights
     * of the events before must have been applied by {@link #filter}.
     */
    public void scatter(Reradiation by, double[] color) {
        by.adjoin(color, worth);
    }

    /** The largest contribution that any displayed band receives of the scene's light. */
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
     * As {@link #scatter}, but the path's throughput goes on as at a grey surface, whose reflectance is the factor by which {@link #most}
     * falls, at most 1: Russian roulette goes by it.
     *
     * @return that reflectance, 0..1; 0 if no light is left
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
