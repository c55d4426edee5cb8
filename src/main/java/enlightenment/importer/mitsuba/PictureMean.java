package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;

/** The mean of a picture. */
final class PictureMean {
    private PictureMean() {}

    /** @param isEncoded whether components are sRGB, else they are linear */
    static Rgb of(Image image, boolean isEncoded) {
        double[] sums = new double[3];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < sums.length; c++) {
                    double v = image.component(x, y, c);
                    sums[c] += isEncoded ? TransferCurve.decode(v) : v;
                }
            }
        }
        double n = (double) image.width() * image.height();
        return new Rgb(positive(sums[0] / n), positive(sums[1] / n), positive(sums[2] / n));
    }

    private static double positive(double v) {
        return v > 0 ? StrictMath.min(v, Float.MAX_VALUE) : 0;
    }
}
