package enlightenment.cli.picture;

import enlightenment.cli.terminal.Version;
import enlightenment.scene.Scene;
import java.util.LinkedHashMap;
import java.util.Map;

/** The texts in a picture's file: nothing that differs from run to run. */
public final class PictureText {
    private PictureText() {}

    /**
     * Keywords and texts of a PNG file.
     *
     * @param settings a line of {@code SettingsLine}
     */
    public static Map<String, String> of(Scene scene, String settings) {
        return of(scene.name(), settings);
    }

    /**
     * Keywords and texts of a PNG file for a scene of this name.
     *
     * @param title empty for none
     * @param settings a line of {@code SettingsLine}
     */
    public static Map<String, String> of(String title, String settings) {
        Map<String, String> text = new LinkedHashMap<>();
        if (!title.isEmpty()) {
            // PNG ends a text at a NUL.
            text.put("Title", title.replace('\0', ' '));
        }
        text.put("Software", "Enlightenment " + Version.number());
        text.put("Settings", settings);
        return text;
    }
}
