package enlightenment.cli.film;

import enlightenment.cli.input.SceneFingerprint;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.terminal.Version;
import enlightenment.file.ContentHash;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.function.DoubleFunction;

/**
 * A hash that identifies the picture of a frame. It covers its scene in that frame, the contents of image files, the settings, the output's
 * format, and the version of the program.
 */
final class FrameDigest {
    /** The keyword of the comment of a PNG file that holds it. */
    static final String KEYWORD = "Frame digest";

    private final SceneFingerprint fingerprints = new SceneFingerprint();
    private final FrameOutput output;
    private final ViewOption view;

    FrameDigest(FrameOutput output, ViewOption view) {
        this.output = output;
        this.view = view;
    }

    /** 64 hexadecimal digits. */
    String of(Scene scene, RenderSettings settings) throws IOException {
        DoubleFunction<String> plain = DecimalNumber::plain;
        RenderSettings.Budget budget = settings.budget();
        String all = String.join(
                "\n",
                "version " + Version.number(),
                "scene " + fingerprints.hash(scene),
                "settings " + SettingsLine.of(settings, null),
                "time "
                        + (budget.seconds().isPresent()
                                ? plain.apply(budget.seconds().getAsDouble())
                                : "any"),
                "depth " + output.depth(),
                "exposure " + view.typed());
        return ContentHash.of(all.getBytes(StandardCharsets.UTF_8)).toString();
    }
}
