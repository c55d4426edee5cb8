package enlightenment.cli;

import enlightenment.color.DisplayCurve;
import enlightenment.color.Encoding;
import enlightenment.image.Image;
import enlightenment.picture.Exposure;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.DoublePredicate;

/** What is to be said of a picture of linear light beside its figures. */
final class LightNotes {
    /** For pictures whose errors sit in few places. */
    static final String HEAVY_TAIL = "few bright samples carry the error; it may be underestimated";

    /** For pictures with light that is {@link RenderReport.Light#undersampled}, which follows. */
    static final String UNDERESTIMATED = "the error may be underestimated: ";

    /** A picture that is darker than this in the mean, as shown, is hardly as it was meant. */
    private static final double DARK = 0.02;

    /** Between two colours of a screen of 8 bits. */
    private static final double STEP = 1 / 255.0;

    private LightNotes() {}

    /**
     * Says what there is to say.
     *
     * @param shown the picture as it was written
     */
    static void tell(RenderResult result, Image shown, Consumer<String> say) {
        tell(result, shown, (kind, text) -> say.accept(text));
    }

    /**
     * Says what there is to say of one of several pictures.
     *
     * @param say hears what may be the same of many, and what is to be said of this one
     */
    static void tell(RenderResult result, Image shown, BiConsumer<String, String> say) {
        RenderReport report = result.report();
        if (report.sampling().light().map(RenderReport.Light::heavyTail).orElse(false)) {
            say.accept("warning: " + HEAVY_TAIL, "warning: " + HEAVY_TAIL);
        }
        String undersampled =
                report.sampling().light().map(RenderReport.Light::undersampled).orElse("");
        if (!undersampled.isEmpty()) {
            say.accept("warning: " + UNDERESTIMATED + undersampled, "warning: " + UNDERESTIMATED + undersampled);
        }
        double mean = shown.encoding() == Encoding.LINEAR ? Exposure.meanDisplayed(shown) : 1;
        // What is lost is told as a failure, which says more.
        if (mean < DARK && lost(shown) == 0 && count(shown, v -> !Double.isFinite(v)) == 0) {
            tellDark(shown, mean, say);
        }
    }

    private static void tellDark(Image shown, double mean, BiConsumer<String, String> say) {
        if (count(shown, v -> v > 0) == 0) {
            String black = "hint: the picture is black: no light was found";
            say.accept(black, black);
            return;
        }
        Image exposed = shown.withCurve(shown.curve().withExposure(Exposure.automatic(shown)));
        String help = lost(exposed) == 0
                ? ": --exposure auto shows more of it"
                : ": its light is at the end of the range of floats; give the lights more";
        say.accept(
                "hint: the picture is dark" + help,
                String.format(Locale.ROOT, "hint: the picture is dark, %.4f in the mean", mean) + help);
    }

    /**
     * Fails if the picture cannot be trusted.
     *
     * @param shown the picture as it was written
     */
    static void require(RenderResult result, Image shown) {
        long lost = result.report().lostSamples();
        if (lost > 0) {
            throw CliException.failed(String.format(
                    Locale.ROOT,
                    "%,d samples were infinite or no numbers and were taken for black: the picture is not to be trusted."
                            + " This is a fault of Enlightenment; please report it with the scene and the command line",
                    lost));
        }
        requireNumbers(shown);
        if (shown.encoding() == Encoding.LINEAR) {
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

    /** How many numbers light may have lost so much of, when it became floats, that a screen of 8 bits shows it. */
    private static long lost(Image shown) {
        DisplayCurve curve = shown.curve();
        return count(shown, v -> v > 0 && v < Float.MIN_NORMAL && curve.of(most(v)) - curve.of(least(v)) > STEP);
    }

    /** What was rounded to a number near 0 lies within half the distance of floats of it; the least float stands for less, too. */
    private static double least(double v) {
        return v == Float.MIN_VALUE ? 0 : v - Float.MIN_VALUE / 2.0;
    }

    private static double most(double v) {
        return v + Float.MIN_VALUE / 2.0;
    }

    private static long count(Image image, DoublePredicate which) {
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
