package enlightenment.cli.scene;

import enlightenment.json.JsonText;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.List;

/**
 * The text of a starter scene, made of a template. In a template {@code "@name"} stands for the scene's name, and the lines between
 * {@code //@main} and {@code //@end} are the main object, which a model replaces; the marks themselves go.
 */
final class StarterScene {
    private static final String NAME = "\"@name\"";
    private static final String MAIN = "//@main";
    private static final String END = "//@end";
    private static final int LONGEST_NAME = 200;

    private StarterScene() {}

    /** The scene with its own main object. */
    static String text(StarterKind kind, String name) {
        List<String> lines = new ArrayList<>();
        for (String line : kind.template().lines().toList()) {
            if (!isMark(line)) {
                lines.add(line);
            }
        }
        return named(lines, name);
    }

    /**
     * The scene with a model in place of its main object.
     *
     * @param file the model's file as the scene names it
     */
    static String text(StarterKind kind, String name, StarterModel model, String file) {
        List<String> lines = new ArrayList<>();
        String end = "";
        boolean isMain = false;
        for (String line : kind.template().lines().toList()) {
            if (line.strip().equals(MAIN)) {
                isMain = true;
            } else if (line.strip().equals(END)) {
                String indent = line.substring(0, line.indexOf(END));
                lines.add(model.object(kind.place(), JsonText.quoted(file), indent) + end);
                isMain = false;
            } else if (isMain) {
                // Whether more objects come after the main one.
                end = line.endsWith(",") ? "," : "";
            } else {
                lines.add(line);
            }
        }
        return named(lines, name);
    }

    private static boolean isMark(String line) {
        return line.strip().equals(MAIN) || line.strip().equals(END);
    }

    private static String named(List<String> lines, String name) {
        return (String.join("\n", lines) + "\n").replace(NAME, JsonText.quoted(Plain.line(name, LONGEST_NAME)));
    }
}
