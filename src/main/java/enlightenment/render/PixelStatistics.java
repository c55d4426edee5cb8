package enlightenment.render;

import enlightenment.engine.PictureFilm;
import enlightenment.image.Image;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;

/** What the samples of a film tell of each pixel, as images of raw numbers. */
final class PixelStatistics {
    private final PictureFilm film;
    private final RenderSettings.Crop region;

    PixelStatistics(PictureFilm film, RenderSettings.Crop region) {
        this.film = film;
        this.region = region;
    }

    Image of(Auxiliary kind) {
        return kind == Auxiliary.ERROR ? deviations() : counts();
    }

    private Image counts() {
        float[] rgb = new float[3 * region.width() * region.height()];
        for (int i = 0; i < region.width() * region.height(); i++) {
            int count = film.samples(region.x() + i % region.width(), region.y() + i / region.width());
            Arrays.fill(rgb, 3 * i, 3 * i + 3, count);
        }
        return new Image(region.width(), region.height(), rgb);
    }

    private Image deviations() {
        float[] variances = film.error().variances();
        float[] rgb = new float[3 * variances.length];
        for (int y = 0; y < region.height(); y++) {
            for (int x = 0; x < region.width(); x++) {
                int k = 3 * (y * region.width() + x);
                Arrays.fill(rgb, k, k + 3, (float) Math.sqrt(meanAround(x, y, variances)));
            }
        }
        return new Image(region.width(), region.height(), rgb);
    }

    /** The mean variance of the finished pixels among 3×3; infinite where there is none. */
    private double meanAround(int x, int y, float[] variances) {
        double sum = 0;
        int n = 0;
        for (int row = Math.max(y - 1, 0); row <= Math.min(y + 1, region.height() - 1); row++) {
            for (int column = Math.max(x - 1, 0); column <= Math.min(x + 1, region.width() - 1); column++) {
                if (film.samples(region.x() + column, region.y() + row) > 0) {
                    sum += variances[row * region.width() + column];
                    n++;
                }
            }
        }
        return n == 0 ? Double.POSITIVE_INFINITY : sum / n;
    }
}
