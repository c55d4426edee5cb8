package enlightenment.render;

import enlightenment.engine.PictureFilm;
import enlightenment.image.Image;
import enlightenment.picture.Neighbourhood;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;

/** Statistics of the samples of each pixel, as images of raw numbers. */
final class PixelStatistics {
    private final PictureFilm film;
    private final RenderSettings.Crop region;

    PixelStatistics(PictureFilm film, RenderSettings.Crop region) {
        this.film = film;
        this.region = region;
    }

    Image of(RenderResult.Auxiliary kind) {
        return kind == RenderResult.Auxiliary.ERROR ? deviations() : counts();
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
        int width = region.width();
        for (int i = 0; i < variances.length; i++) {
            if (film.samples(region.x() + i % width, region.y() + i / width) == 0) {
                variances[i] = Float.NaN;
            }
        }
        float[] rgb = new float[3 * variances.length];
        for (int i = 0; i < variances.length; i++) {
            double around = Neighbourhood.mean(variances, width, region.height(), i % width, i / width);
            Arrays.fill(rgb, 3 * i, 3 * i + 3, (float) Math.sqrt(around));
        }
        return new Image(width, region.height(), rgb);
    }
}
