package enlightenment.scene.json;

import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;

/** The JSON Schema of the scene format, for editors and other programs. */
final class SceneSchema {
    /** Placeholder of the resource for the words of the methods. */
    private static final String WORDS = "\"@methods\"";

    private static final String USUAL = "\"@method\"";
    private static final String SETTINGS = "\"@settings\": {}";

    private SceneSchema() {}

    /** The schema's text (JSON Schema 2020-12), with all methods, those of extensions included. */
    static String text() {
        return text(Method.all());
    }

    /** The schema's text with the given methods. */
    static String text(List<Method> methods) {
        String words =
                Method.selectable(methods).stream().map(m -> quoted(m.word())).collect(Collectors.joining(", "));
        String settings =
                Method.settings(methods).stream().map(SceneSchema::property).collect(Collectors.joining(",\n"));
        return resource()
                .replace(WORDS, words)
                .replace(USUAL, quoted(RenderSettings.Defaults.DEFAULT.method().word()))
                .replace("        " + SETTINGS, settings);
    }

    private static String resource() {
        try (InputStream in = SceneSchema.class.getResourceAsStream("scene.schema.json")) {
            if (in == null) {
                throw new IllegalStateException("the schema is missing from the program");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String property(Method.Setting setting) {
        String description = setting.description();
        String sentence = Character.toUpperCase(description.charAt(0)) + description.substring(1) + ".";
        String values = setting instanceof Method.Setting.Whole w
                ? "\"type\": \"integer\",\n          \"minimum\": " + w.min() + ",\n          \"maximum\": " + w.max()
                        + ",\n          \"default\": " + w.usualValue()
                : "\"enum\": ["
                        + ((Method.Setting.Word) setting)
                                .words().stream().map(SceneSchema::quoted).collect(Collectors.joining(", "))
                        + "],\n          \"default\": " + quoted((String) setting.usual());
        return "        " + quoted(setting.key()) + ": {\n          \"description\": " + quoted(sentence)
                + ",\n          " + values + "\n        }";
    }

    /** A JSON string; words and descriptions of methods need no escapes but those of quotes and backslashes. */
    private static String quoted(String text) {
        return "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }
}
