package enlightenment.render;

import enlightenment.film.Film;
import enlightenment.image.Image;
import java.util.Arrays;

/** What the samples of a film tell of each pixel, as images of raw numbers. */
final class PixelStatistics {
    private final Film film;

    PixelStatistics(Film film) {
        this.film = film;
    }

    Image of(Auxiliary kind) {
        return kind == Auxiliary.ERROR ? deviations() : counts();
    }

    private Image counts() {
        float[] rgb = new float[3 * film.width * film.height];
        for (int i = 0; i < film.width * film.height; i++) {
            int count = film.count(film.x + i % film.width, film.y + i / film.width);
            Arrays.fill(rgb, 3 * i, 3 * i + 3, count);
        }
        return new Image(film.width, film.height, rgb);
    }

    private Image deviations() {
        float[] variances = film.error().variances();
        float[] rgb = new float[3 * variances.length];
        for (int y = 0; y < film.height; y++) {
            for (int x = 0; x < film.width; x++) {
                int k = 3 * (y * film.width + x);
                Arrays.fill(rgb, k, k + 3, (float) Math.sqrt(meanAround(x, y, variances)));
            }
        }
        return new Image(film.width, film.height, rgb);
    }

    /** The mean variance of the finished pixels among 3×3; infinite where there is none. */
    private double meanAround(int x, int y, float[] variances) {
        double sum = 0;
        int n = 0;
        for (int row = Math.max(y - 1, 0); row <= Math.min(y + 1, film.height - 1); row++) {
            for (int column = Math.max(x - 1, 0); column <= Math.min(x + 1, film.width - 1); column++) {
                if (film.count(film.x + column, film.y + row) > 0) {
                    sum += variances[row * film.width + column];
                    n++;
                }
            }
        }
        return n == 0 ? Double.POSITIVE_INFINITY : sum / n;
    }
}
