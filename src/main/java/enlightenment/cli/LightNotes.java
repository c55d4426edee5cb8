package enlightenment.cli;

import enlightenment.color.Encoding;
import enlightenment.image.Image;
import enlightenment.picture.Exposure;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/** What is to be said of a picture of linear light beside its figures. */
final class LightNotes {
    /** For pictures whose errors sit in few places. */
    static final String HEAVY_TAIL = "few bright samples carry the error; it may be underestimated";

    /** A picture that is darker than this in the mean, as shown, is hardly as it was meant. */
    private static final double DARK = 0.02;

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
        double mean = shown.encoding() == Encoding.LINEAR ? Exposure.meanDisplayed(shown) : 1;
        if (mean < DARK) {
            String help = ": --exposure auto shows more of it";
            say.accept(
                    "hint: the picture is dark" + help,
                    String.format(Locale.ROOT, "hint: the picture is dark, %.4f in the mean", mean) + help);
        }
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
        long beyond = shown.encoding() == Encoding.LINEAR ? infinite(shown) : 0;
        if (beyond > 0) {
            throw CliException.failed(String.format(
                    Locale.ROOT,
                    "%,d numbers of the picture are beyond the range of floats, 3.4e38, and were taken for infinite:"
                            + " give the lights less",
                    beyond));
        }
    }

    private static long infinite(Image image) {
        long found = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    found += Float.isInfinite(image.component(x, y, c)) ? 1 : 0;
                }
            }
        }
        return found;
    }
}
