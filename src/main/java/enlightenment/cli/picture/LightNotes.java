package enlightenment.cli.picture;

import enlightenment.cli.terminal.CliException;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.DoublePredicate;

/** Messages about a picture of linear light beside its figures. */
public final class LightNotes {
    /** For pictures whose errors sit in few places. */
    static final String HEAVY_TAIL = "few bright samples carry the error; it may be underestimated";

    /** For pictures with light that is {@link RenderReport.Light#undersampled}, which follows. */
    static final String UNDERESTIMATED = "the error may be underestimated: ";

    /** Between two colours of a screen of 8 bits. */
    private static final double STEP = 1 / 255.0;

    private LightNotes() {}

    /** Reports where the error estimate may be too low. */
    public static void tell(RenderResult result, Consumer<String> say) {
        result.report().sampling().light().ifPresent(light -> {
            if (light.heavyTail()) {
                say.accept("warning: " + HEAVY_TAIL);
            }
            if (!light.undersampled().isEmpty()) {
                say.accept("warning: " + UNDERESTIMATED + String.join("; ", light.undersampled()));
            }
        });
    }

    /**
     * Fails if the picture cannot be trusted.
     *
     * @param shown the picture as it was written
     */
    public static void require(RenderResult result, Image shown) {
        long lost = result.report().lostSamples();
        if (lost > 0) {
            throw CliException.failed(String.format(
                    Locale.ROOT,
                    "%,d samples were infinite or no numbers and were taken for black: the picture is not to be trusted."
                            + " This is a fault of Enlightenment; please report it with the scene and the command line",
                    lost));
        }
        requireNumbers(shown);
        if (shown.encoding() == Color.Encoding.LINEAR) {
            requireRange(shown);
        }
    }

    private static void requireNumbers(Image shown) {
        // Finite sums, each of which passes for one, may add up to anything.
        refuse(
                count(shown, Double::isNaN),
                "are no numbers, being made from sums beyond the range of numbers: the picture is not to be trusted. No light"
                        + " does that: what a worker sent, or a file of results holds, is wrong");
    }

    private static void requireRange(Image shown) {
        refuse(
                count(shown, Double::isInfinite),
                "are beyond the range of floats, 3.4e38, and were taken for infinite: give the lights less");
        String stops = String.format(Locale.ROOT, "%.0f", shown.curve().exposure());
        refuse(
                lost(shown),
                "are below the range of floats, where they are 1.4e-45 apart, and the exposure shows it: give all lights 2^"
                        + stops + " times as much, and the exposure " + stops + " less");
    }

    /** Fails if there are numbers of the picture of which that has to be said. */
    private static void refuse(long numbers, String what) {
        if (numbers > 0) {
            throw CliException.failed(String.format(Locale.ROOT, "%,d numbers of the picture %s", numbers, what));
        }
    }

    /** The number of components whose rounding to denormal floats would show on a screen of 8 bits. */
    static long lost(Image shown) {
        DisplayCurve curve = shown.curve();
        return count(shown, v -> v > 0 && v < Float.MIN_NORMAL && curve.of(most(v)) - curve.of(least(v)) > STEP);
    }

    /** The least value that rounds to a denormal float: half a spacing below it, or 0 for the smallest float. */
    private static double least(double v) {
        return v == Float.MIN_VALUE ? 0 : v - Float.MIN_VALUE / 2.0;
    }

    private static double most(double v) {
        return v + Float.MIN_VALUE / 2.0;
    }

    /** The number of components of a picture that fulfil a condition. */
    static long count(Image image, DoublePredicate which) {
        long found = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    found += which.test(image.component(x, y, c)) ? 1 : 0;
                }
            }
        }
        return found;
    }
}
