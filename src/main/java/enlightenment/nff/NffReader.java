package enlightenment.nff;

import enlightenment.file.InputFile;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Reads scenes in Eric Haines' Neutral File Format.
 *
 * <p>Every entity of the format is read. What a {@link Scene} cannot say (the normals of patches,
 * one-sided surfaces, Kd, Ks and Shine of surfaces that are not what they describe) is noted in the result. Decimals are
 * kept exactly as written, and so are coordinates: the file's right-handed axes are served by a window camera whose
 * corners say what is left and right.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class NffReader {
    private static final int MAX_PROBLEMS = 50;

    private NffReader() {}

    /**
     * What was read.
     *
     * @param scene the scene
     * @param notes what the file says but the scene does not, in plain words that begin with the lines, such as
     *     {@code "lines 9, 11, 14 and 2 more: ..."}; ordered by line
     */
    public record Result(Scene scene, List<String> notes) {
        public Result {
            Objects.requireNonNull(scene, "scene");
            notes = List.copyOf(notes);
        }
    }

    /**
     * Reads a file; the scene is named after it.
     *
     * @throws SceneException if it is not in the format; lists the problems with their lines
     * @throws IOException if it cannot be read
     */
    public static Result read(Path file) throws IOException {
        // The format is ASCII; comments may hold anything.
        String text = new String(InputFile.bytes(file), StandardCharsets.ISO_8859_1);
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return parse(text, file.toString(), dot > 0 ? name.substring(0, dot) : name);
    }

    /**
     * Reads a text.
     *
     * @param file what messages call it
     * @param sceneName the name of the scene
     * @throws SceneException as {@link #read}
     */
    public static Result parse(String text, String file, String sceneName) {
        Tokens tokens = new Tokens(text);
        NffSceneBuilder scene = new NffSceneBuilder(sceneName);
        NffEntities entities = new NffEntities(tokens, scene);
        List<SceneException.Problem> problems = new ArrayList<>();
        while (!tokens.peek().isEnd() && problems.size() < MAX_PROBLEMS) {
            try {
                entities.readNext();
            } catch (NffSyntaxException e) {
                problems.add(new SceneException.Problem(file, e.line(), e.column(), "", e.getMessage()));
                entities.skipToNext();
            }
        }
        if (!scene.hasView() && problems.isEmpty()) {
            problems.add(new SceneException.Problem(
                    file, 0, 0, "", "expected a view: v, then from, at, up, angle, hither and resolution"));
        }
        if (!problems.isEmpty()) {
            throw new SceneException(problems);
        }
        return scene.build();
    }
}
