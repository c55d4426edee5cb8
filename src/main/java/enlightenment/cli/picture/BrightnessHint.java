package enlightenment.cli.picture;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.picture.Exposure;
import enlightenment.render.RenderResult;
import java.util.Locale;
import java.util.function.BiConsumer;

/** A hint for a finished picture that is nearly black or nearly white as shown. */
public final class BrightnessHint {
    /**
     * The mean of lit pixels, in display units, below which a picture is nearly black: five steps of 255. It is 1/646 of white's light,
     * about as much as a screen reflects of a lit room. Black surroundings of a bright thing have no say. A picture whose mean over all
     * pixels is above 1 − NEAR is nearly white.
     */
    private static final double NEAR = 0.02;

    /** An exposure that differs by less would change little. */
    private static final double LEAST_STOPS = 1;

    private BrightnessHint() {}

    /**
     * Reports a picture that is nearly black or nearly white.
     *
     * @param result the result of the render
     * @param shown the picture as it was written
     * @param holdsFloats whether the file holds floats, to which linear light is written without exposure
     * @param say receives the part of the message that many pictures may share, and the whole message
     */
    public static void tell(RenderResult result, Image shown, boolean holdsFloats, BiConsumer<String, String> say) {
        // A part of a picture may be dark, and so may a single pixel, which is a measurement.
        if (result.report().settings().crop().isEmpty() && shown.width() * shown.height() > 1) {
            tell(shown, holdsFloats, say);
        }
    }

    /** As {@link #tell(RenderResult, Image, boolean, BiConsumer)}, of a whole picture of several pixels. */
    static void tell(Image shown, boolean holdsFloats, BiConsumer<String, String> say) {
        // What is lost is a failure, which says more.
        if (LightNotes.lost(shown) > 0 || LightNotes.count(shown, v -> !Double.isFinite(v)) > 0) {
            return;
        }
        long lit = litPixels(shown);
        if (lit == 0) {
            String black = "hint: the picture is black: no light was found";
            say.accept(black, black);
            return;
        }
        double mean = Exposure.meanDisplayed(shown);
        double litMean = mean * shown.width() * shown.height() / lit;
        if (shown.encoding() == Color.Encoding.LINEAR && holdsFloats) {
            return;
        }
        if (litMean < NEAR && stops(shown) >= LEAST_STOPS) {
            tell(shown, true, String.format(Locale.ROOT, ", %.4f in the mean of its lit pixels", litMean), say);
        } else if (mean > 1 - NEAR && stops(shown) <= -LEAST_STOPS) {
            tell(shown, false, String.format(Locale.ROOT, ", %.4f in the mean", mean), say);
        }
    }

    private static void tell(Image shown, boolean isDark, String mean, BiConsumer<String, String> say) {
        String what = "hint: the picture is nearly " + (isDark ? "black" : "white");
        String help = shown.encoding() == Color.Encoding.LINEAR ? exposureHelp(shown) : classicHelp(isDark);
        say.accept(what + help, what + mean + help);
    }

    /** The stops by which an automatic exposure would brighten the picture. */
    private static double stops(Image shown) {
        return shown.encoding() == Color.Encoding.LINEAR
                ? Exposure.automatic(shown) - shown.curve().exposure()
                : Exposure.automatic(light(shown));
    }

    private static long litPixels(Image image) {
        long lit = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                lit += image.component(x, y, 0) > 0 || image.component(x, y, 1) > 0 || image.component(x, y, 2) > 0
                        ? 1
                        : 0;
            }
        }
        return lit;
    }

    private static String exposureHelp(Image shown) {
        Image exposed = shown.withCurve(shown.curve().withExposure(Exposure.automatic(shown)));
        return LightNotes.lost(exposed) == 0
                ? ": --exposure auto shows more of it"
                : ": its light is at the end of the range of floats; give the lights more";
    }

    private static String classicHelp(boolean isDark) {
        return ": make lights and surfaces " + (isDark ? "brighter" : "darker")
                + "; --exposure auto is for physical shading only";
    }

    /** The light that a screen makes of a display-referred picture, between black and white. */
    private static Image light(Image shown) {
        Image.Rows light = (y, components) -> {
            for (int i = 0; i < components.length; i++) {
                double value = shown.component(i / 3, y, i % 3);
                components[i] = (float) TransferCurve.decode(Math.min(Math.max(value, 0), 1));
            }
        };
        return Image.of(shown.width(), shown.height(), light, DisplayCurve.SRGB);
    }
}
