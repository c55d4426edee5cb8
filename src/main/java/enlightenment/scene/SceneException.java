package enlightenment.scene;

import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.text.Plain;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Thrown for a scene that cannot be used, with the place of each problem. Every problem that was found is listed, not just the first. */
public final class SceneException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * One problem. What its parts quote may come from anywhere; {@link #toString} shows them as plain text.
     *
     * @param file the file it is in, or "" where there is none
     * @param line its line, counted from 1, or 0 where unknown
     * @param column its column, counted from 1, or 0 where unknown
     * @param pointer the JSON pointer of the value, "" for the whole scene
     * @param message what is wrong and what was expected
     */
    public record Problem(String file, int line, int column, String pointer, String message)
            implements java.io.Serializable {
        private static final long serialVersionUID = 1L;
        private static final int LONGEST = 2_000;

        /** For people: one line of plain text without control characters, whatever it quotes. */
        @Override
        public String toString() {
            StringBuilder s = new StringBuilder();
            if (!file.isEmpty()) {
                s.append(file);
                if (line > 0) {
                    s.append(':').append(line).append(':').append(column);
                }
                s.append(": ");
            }
            if (!pointer.isEmpty()) {
                s.append(pointer).append(": ");
            }
            return Plain.line(s.append(message).toString(), LONGEST);
        }
    }

    private final transient List<Problem> problems;

    /** @param problems what is wrong, in the order of their places; the message has a line for each */
    public SceneException(List<Problem> problems) {
        super(String.join("\n", problems.stream().map(Problem::toString).toList()));
        this.problems = List.copyOf(problems);
    }

    /** A single problem without a place in a file: the JSON pointer of the value, or "", and what is wrong. */
    public static SceneException of(String pointer, String message) {
        return new SceneException(List.of(new Problem("", 0, 0, pointer, message)));
    }

    /** A value that cannot be used, at the place that its key names. */
    public static SceneException of(InvalidValueException e) {
        return of(e.key().isEmpty() ? "" : "/" + e.key(), e.problem());
    }

    /** A texture's file that cannot be used, for this reason: at the first texture of the scene that names it. */
    public static SceneException ofTexture(Scene scene, Path file, String reason) {
        for (Map.Entry<String, Texture> named : scene.textures().entrySet()) {
            if (named.getValue() instanceof Texture.File texture
                    && texture.file().equals(file)) {
                return of("/textures/" + escaped(named.getKey()) + "/file", reason);
            }
        }
        // Scenes made by programs have textures without names.
        return of("", "a texture cannot be used: " + reason);
    }

    /** A key as a part of a JSON pointer (RFC 6901). */
    public static String escaped(String key) {
        return key.replace("~", "~0").replace("/", "~1");
    }

    /** All the problems, in the order of their places. */
    public List<Problem> problems() {
        return problems;
    }
}
