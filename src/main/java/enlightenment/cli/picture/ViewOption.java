package enlightenment.cli.picture;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.picture.Exposure;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Locale;
import java.util.OptionalDouble;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** The option that says how bright a written picture of linear light shows it. */
public final class ViewOption {
    @Option(
            names = "--exposure",
            paramLabel = "N|auto",
            converter = Converter.class,
            description = "physical shading: show the picture 2^N times as bright, in place of the scene's exposure;"
                    + " auto: middle grey in the middle")
    private Choice exposure;

    public ViewOption() {}

    /** The chosen exposure: a number of stops, or none for automatic. */
    record Choice(OptionalDouble stops) {}

    private boolean isGiven() {
        return exposure != null;
    }

    /** As it was given; empty if it was not. */
    public String typed() {
        return !isGiven()
                ? ""
                : exposure.stops().isPresent()
                        ? DecimalNumber.plain(exposure.stops().getAsDouble())
                        : "auto";
    }

    /** Fails where the option can have no meaning. */
    public void check(PictureOutput output) {
        if (isGiven() && output.writtenDepth() == 0) {
            throw CliException.wrongUsage("--exposure must not be given for a float map, which holds light as it is");
        }
    }

    /** Fails if the option was given for a scene whose pictures are display-referred. */
    public void check(Scene scene) {
        check(scene.shading() instanceof Shading.Physical);
    }

    private void check(boolean isLinear) {
        if (isGiven() && !isLinear) {
            throw CliException.wrongUsage(
                    "--exposure is for physical shading: this picture is of classic shading, whose colours are those of a screen");
        }
    }

    /** The picture as it is to be shown. */
    public Image view(Image image) {
        if (!isGiven()) {
            return image;
        }
        check(image.encoding() == Color.Encoding.LINEAR);
        double stops = exposure.stops().orElseGet(() -> Exposure.automatic(image));
        return image.withCurve(image.curve().withExposure(limited(stops)));
    }

    /** {@link #view(Image)}, which also prints the automatic exposure. */
    public Image view(Image image, Terminal terminal) {
        Image shown = view(image);
        if (isGiven() && exposure.stops().isEmpty()) {
            terminal.say("exposure: " + DecimalNumber.plain(shown.curve().exposure()));
        }
        return shown;
    }

    private static double limited(double stops) {
        return Math.min(Math.max(stops, -DisplayCurve.MOST_EXPOSURE), DisplayCurve.MOST_EXPOSURE);
    }

    static final class Converter implements ITypeConverter<Choice> {
        private final Stops stops = new Stops();

        @Override
        public Choice convert(String text) {
            if (text.equals("auto")) {
                return new Choice(OptionalDouble.empty());
            }
            try {
                return new Choice(OptionalDouble.of(stops.convert(text)));
            } catch (BadValue e) {
                throw BadValue.expected(
                        String.format(
                                Locale.ROOT,
                                "auto or a number in %.0f..%.0f",
                                -DisplayCurve.MOST_EXPOSURE,
                                DisplayCurve.MOST_EXPOSURE),
                        text);
            }
        }
    }

    public static final class Stops extends DecimalNumber {
        Stops() {
            super(-DisplayCurve.MOST_EXPOSURE, DisplayCurve.MOST_EXPOSURE);
        }
    }
}
