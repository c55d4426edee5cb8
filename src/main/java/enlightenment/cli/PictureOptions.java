package enlightenment.cli;

import enlightenment.scene.Scene;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** What commands that write pictures check alike. */
final class PictureOptions {
    private PictureOptions() {}

    /** Fails unless the file's kind is known and may have that depth, which may be null. */
    static void check(Path output, String depth) {
        String extension = Target.extension(output);
        if (!extension.equals(".png") && !extension.equals(".pfm")) {
            throw CliException.wrongUsage("-o must name a file that ends in .png or .pfm, not \"" + output + "\"");
        }
        if (depth != null) {
            OptionValues.word("--depth", depth, "8", "16");
            if (extension.equals(".pfm")) {
                throw CliException.wrongUsage("--depth must not be given for a .pfm file, which holds floats");
            }
        }
    }

    /** What a picture's file says of itself: nothing that differs from run to run. */
    static Map<String, String> text(Scene scene, String settings) {
        Map<String, String> text = new LinkedHashMap<>();
        if (!scene.name().isEmpty()) {
            // PNG ends a text at a NUL.
            text.put("Title", scene.name().replace('\0', ' '));
        }
        text.put("Software", "Enlightenment " + Version.number());
        text.put("Settings", settings);
        return text;
    }
}
