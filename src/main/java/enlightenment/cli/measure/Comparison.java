package enlightenment.cli.measure;

import enlightenment.image.ImageError;
import enlightenment.image.flip.Flip;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The result of {@code enlightenment compare}.
 *
 * @param light the difference of linear light, or null for display-referred pictures
 * @param maxRmse the largest RMSE that passes, or null if any does
 */
record Comparison(
        Path test,
        Path reference,
        ImageError error,
        ImageError.OfLight light,
        Flip flip,
        double pixelsPerDegree,
        Double maxRmse) {

    /** Whether the RMSE is small enough; NaN is not. */
    boolean passed() {
        return maxRmse == null || error.rmse() <= maxRmse;
    }

    /** Lines of a label and a value, for people; {@link ComparisonJson} has all digits, for programs. */
    String toTable() {
        ImageError.Largest largest = error.largest();
        StringBuilder text = new StringBuilder();
        line(text, "size", "%dx%d", flip.width(), flip.height());
        line(text, "RMSE", "%s", figure(error.rmse()));
        line(text, "relative MSE", "%s", figure(error.relativeMeanSquaredError()));
        line(text, "mean absolute error", "%s", figure(error.meanAbsoluteError()));
        if (Double.isInfinite(error.psnr())) {
            line(text, "PSNR", "%s", "infinite");
        } else {
            line(text, "PSNR", "%.2f dB", error.psnr());
        }
        if (light != null) {
            line(text, "relative, of light", "%s", figure(light.relative()));
            line(text, "RMSE of light", "%s", figure(light.rmse()));
            line(
                    text,
                    "ratio of means",
                    "%s red, %s green, %s blue",
                    ratio(light.red()),
                    ratio(light.green()),
                    ratio(light.blue()));
        }
        line(
                text,
                "FLIP",
                "%s (largest %s, %.2f pixels per degree)",
                figure(flip.mean()),
                figure(flip.largest()),
                pixelsPerDegree);
        if (largest.difference() > 0) {
            line(
                    text,
                    "largest difference",
                    "%s at column %d, row %d, %s",
                    figure(largest.difference()),
                    largest.column(),
                    largest.row(),
                    largest.channelName());
        } else {
            line(text, "largest difference", "0: the pictures are equal");
        }
        return text.toString();
    }

    private static void line(StringBuilder text, String label, String format, Object... values) {
        text.append(String.format(Locale.ROOT, "%-21s", label + ":"));
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    /** None where one of the two is black. */
    private static String ratio(double value) {
        return Double.isFinite(value) ? String.format(Locale.ROOT, "%.5f", value) : "none";
    }

    /** Six decimals, or an exponent where they would show too little of a small number. */
    private static String figure(double value) {
        boolean small = value != 0 && value < 1e-3;
        return value == 0 ? "0" : String.format(Locale.ROOT, small ? "%.4e" : "%.6f", value);
    }
}
