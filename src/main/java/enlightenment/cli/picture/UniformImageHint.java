package enlightenment.cli.picture;

import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Locale;

/** Hints for a picture of one colour, which is hardly what was meant. */
public final class UniformImageHint {
    private UniformImageHint() {}

    /**
     * Reports the reason if the whole picture has one colour and a reason is known.
     *
     * @return whether it was reported
     */
    public static boolean tell(Scene scene, RenderSettings settings, RenderResult result, Terminal terminal) {
        Image image = result.image();
        if (image.width() * image.height() == 1 || !isUniform(image)) {
            return false;
        }
        List<String> hints = Renderer.inspect(scene, settings).hints();
        boolean nothing = settings.crop().isEmpty()
                && result.report().hitsByPrimitive().values().stream().allMatch(n -> n == 0);
        if (hints.isEmpty() && !nothing) {
            return false;
        }
        terminal.say(String.format(
                Locale.ROOT,
                "the picture is one colour, #%02x%02x%02x%s",
                of255(image, 0),
                of255(image, 1),
                of255(image, 2),
                nothing ? ": the camera sees none of the objects" : ""));
        hints.forEach(hint -> terminal.say("hint: " + hint));
        return true;
    }

    private static boolean isUniform(Image image) {
        float[] first = {image.component(0, 0, 0), image.component(0, 0, 1), image.component(0, 0, 2)};
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    if (image.component(x, y, c) != first[c]) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private static int of255(Image image, int c) {
        return (int) Math.rint(255 * Math.min(Math.max(image.component(0, 0, c), 0), 1));
    }
}
