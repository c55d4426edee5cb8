package enlightenment.view.frame;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.picture.Neighbourhood;
import java.util.Arrays;

/**
 * The noise of the mean of several passes, estimated from their spread. For a component with mean m, standard error s and display curve d, the
 * displayed standard error is (d(m + s) − d(m − s)) / 2.
 */
public final class PictureNoise {
    private static final int ENOUGH = 1 << 17;

    private final Image mean;

    /** Estimated variance of each component of the mean. */
    private final float[] variances;

    /**
     * @param mean the mean of all passes
     * @param variances estimated variance of each component of the mean; owned by this object from now on, not copied
     */
    public PictureNoise(Image mean, float[] variances) {
        this.mean = mean;
        this.variances = variances;
    }

    public int width() {
        return mean.width();
    }

    public int height() {
        return mean.height();
    }

    /** The standard error of a component in the picture's units: root of the mean variance over 3×3 pixels. */
    public double deviation(int x, int y, int c) {
        double sum = 0;
        int n = 0;
        for (int row = Math.max(y - 1, 0); row <= Math.min(y + 1, height() - 1); row++) {
            for (int column = Math.max(x - 1, 0); column <= Math.min(x + 1, width() - 1); column++) {
                sum += variances[3 * (row * width() + column) + c];
                n++;
            }
        }
        return Math.sqrt(sum / n);
    }

    /**
     * The estimated root mean square error over all pixels and components, in displayed units 0..1. For large pictures it is taken over a regular
     * grid of about {@value #ENOUGH} pixels, since it is computed after each pass.
     */
    public double rmse(DisplayCurve curve) {
        int step = (int) Math.max(Math.ceil(Math.sqrt((double) width() * height() / ENOUGH)), 1);
        double sum = 0;
        long pixels = 0;
        for (int y = Math.min((step - 1) / 2, height() - 1); y < height(); y += step) {
            double row = 0;
            for (int x = Math.min((step - 1) / 2, width() - 1); x < width(); x += step) {
                row += displayedVariance(x, y, curve);
                pixels++;
            }
            sum += row;
        }
        return Math.sqrt(sum / pixels);
    }

    /**
     * The standard error of each pixel in displayed units, defined as {@link enlightenment.render.RenderResult.Auxiliary#ERROR}. It is the root of
     * the mean variance over the components of the 3×3 pixels around the pixel.
     */
    public Image map(DisplayCurve curve) {
        int n = width() * height();
        float[] displayed = new float[n];
        for (int i = 0; i < n; i++) {
            displayed[i] = (float) displayedVariance(i % width(), i / width(), curve);
        }
        float[] rgb = new float[3 * n];
        for (int i = 0; i < n; i++) {
            double around = Neighbourhood.mean(displayed, width(), height(), i % width(), i / width());
            Arrays.fill(rgb, 3 * i, 3 * i + 3, (float) Math.sqrt(around));
        }
        return new Image(width(), height(), rgb);
    }

    /** The variance in displayed units, averaged over the components of a pixel. */
    private double displayedVariance(int x, int y, DisplayCurve curve) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            double m = mean.component(x, y, c);
            double s = Math.sqrt(variances[3 * (y * width() + x) + c]);
            if (s > 0) {
                double shown = (curve.nearly(m + s) - curve.nearly(m - s)) / 2;
                sum += shown * shown;
            }
        }
        return sum / 3;
    }
}
