package enlightenment.denoise;

import enlightenment.work.Workers;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * Takes the grain out of a picture of linear light.
 *
 * <p>Each pixel becomes a weighted mean of its window ({@link WindowFilter}), for three widths; per pixel the width is chosen of which
 * the two halves of the samples say that its squared error is least. What noise is left then is nearly the same in all of a window: the
 * result is filtered once more, by windows as many times as wide as their pixels are apart.
 *
 * <p>A pure function of the picture: the same bits on any number of threads and any machine.
 */
public final class Denoiser {
    /** Over squares of this radius estimates of errors are averaged. */
    private static final int SMOOTHING = 3;

    /** Over these the choice. */
    private static final int BLENDING = 1;

    private Denoiser() {}

    /**
     * The picture without grain: red, green and blue of each pixel. Pixels that are no finite numbers stay as they are.
     *
     * @param threads at least 1; of no influence on the result
     * @param cancelled asked by all threads
     * @throws CancellationException if it was cancelled
     */
    public static float[] denoise(NoisyPicture picture, int threads, BooleanSupplier cancelled) {
        Guide guide = new Guide(picture, WindowFilter.MARGIN);
        Guide once = new Guide(guide, once(guide, threads, cancelled));
        FilteredLight[] again = filter(once, WindowFilter.STEP, WindowFilter.WIDTH_AGAIN, threads, cancelled);
        return output(picture, guide, again[0]);
    }

    private static FilteredLight once(Guide guide, int threads, BooleanSupplier cancelled) {
        FilteredLight[] filtered = filter(guide, 1, WindowFilter.WIDTHS, threads, cancelled);
        return FilteredLight.blend(guide.grid, filtered, shares(guide, filtered));
    }

    /** Filters light by windows of some widths. */
    private static FilteredLight[] filter(
            Guide guide, int step, float[] widths, int threads, BooleanSupplier cancelled) {
        FilteredLight[] filtered = new FilteredLight[widths.length];
        Arrays.setAll(filtered, k -> new FilteredLight(guide.grid));
        Workers.run(
                threads,
                WindowFilter.strips(guide.grid),
                cancelled,
                () -> new WindowFilter(guide, step, widths, filtered)::filter);
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("stopped while grain was removed");
        }
        return filtered;
    }

    /** How much each width has of each pixel; they add up to 1. */
    private static float[][] shares(Guide guide, FilteredLight[] filtered) {
        Grid grid = guide.grid;
        float[][] errors = new float[filtered.length][];
        for (int k = 0; k < errors.length; k++) {
            errors[k] = errors(guide, filtered[k]);
            grid.blur(errors[k], SMOOTHING);
        }
        float[][] shares = new float[errors.length][grid.size()];
        for (int i = 0; i < grid.size(); i++) {
            int best = 0;
            for (int k = 1; k < errors.length; k++) {
                best = errors[k][i] < errors[best][i] ? k : best;
            }
            shares[best][i] = 1;
        }
        for (float[] share : shares) {
            grid.blur(share, BLENDING);
        }
        return shares;
    }

    /**
     * The estimated squared error of each pixel in units of its variance, but for what all widths have in common.
     *
     * <p>With M the mean, D half of the difference of the halves, M' and D' what the filter makes of them, (M' − M)² + 2 D'·D − v is the
     * squared error of M' in the mean, since the errors of M and D have the same variance v and D·D' tells how far M' follows M.
     */
    private static float[] errors(Guide guide, FilteredLight filtered) {
        float[] errors = new float[guide.grid.size()];
        for (int i = 0; i < errors.length; i++) {
            float sum = 0;
            for (int c = 0; c < 3; c++) {
                float off = filtered.light[c][i] - guide.light[c][i];
                float both = 2 * filtered.difference[c][i] * guide.difference[c][i];
                sum += (off * off + both) / guide.deviation[c][i];
            }
            errors[i] = sum * guide.mask[i];
        }
        return errors;
    }

    private static float[] output(NoisyPicture picture, Guide guide, FilteredLight filtered) {
        float[] rgb = picture.light().clone();
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                int i = guide.grid.index(x, y);
                int to = 3 * (y * picture.width() + x);
                for (int c = 0; c < 3 && guide.mask[i] > 0; c++) {
                    rgb[to + c] = (float) (filtered.light[c][i] * guide.scale(c, i));
                }
            }
        }
        return rgb;
    }
}
