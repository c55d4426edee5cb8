package enlightenment.cli.setting;

import enlightenment.camera.Camera;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;

/**
 * The hint for pictures whose aspect ratio is not that of the camera's window. The other cameras have no aspect ratio of their own:
 * with another size they show more or less at the sides.
 */
public final class StretchHint {
    /** A smaller stretch is invisible, and the shipped windows are no more exact. */
    private static final double INVISIBLE = 0.01;

    private StretchHint() {}

    /** The hint, if the picture is stretched by more than whole pixels make inevitable. */
    public static Optional<String> of(Scene scene, RenderSettings settings) {
        if (!(scene.camera() instanceof Camera.Window window)) {
            return Optional.empty();
        }
        double width = window.lowerRight().minus(window.lowerLeft()).length();
        double height = window.upperLeft().minus(window.lowerLeft()).length();
        double wide = width / height * settings.height();
        double high = height / width * settings.width();
        double stretch = settings.width() / wide;
        if (Math.abs(settings.width() - wide) <= 1
                || Math.abs(settings.height() - high) <= 1
                || Math.abs(stretch - 1) <= INVISIBLE) {
            return Optional.empty();
        }
        String fitting =
                high >= 1 && high <= Scene.MAX_SIDE ? "; " + settings.width() + "x" + Math.round(high) + " is not" : "";
        return Optional.of(String.format(
                Locale.ROOT,
                "the camera's window is %s times as wide as high, the picture of %dx%d pixels %s times: it is stretched%s",
                shortened(width / height),
                settings.width(),
                settings.height(),
                shortened((double) settings.width() / settings.height()),
                fitting));
    }

    private static String shortened(double ratio) {
        return new BigDecimal(ratio)
                .round(new MathContext(4))
                .stripTrailingZeros()
                .toPlainString();
    }
}
