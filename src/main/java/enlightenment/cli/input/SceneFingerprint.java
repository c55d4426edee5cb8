package enlightenment.cli.input;

import enlightenment.file.ContentHash;
import enlightenment.file.InputFile;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A hash that identifies a scene. */
public final class SceneFingerprint {
    /** The hashes of image files, each read once. */
    private final Map<Path, String> images = new HashMap<>();

    /** The SHA-256, in hexadecimal digits, of all that the scene holds, with the contents of its image files. */
    public static String of(Scene scene) throws IOException {
        return new SceneFingerprint().hash(scene);
    }

    /** {@link #of} for several scenes, which share image files. */
    public String hash(Scene scene) throws IOException {
        try {
            String json = json(scene);
            return ContentHash.of(json.getBytes(StandardCharsets.UTF_8)).toString();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** The scene's text, and those of its instants. */
    private String json(Scene scene) {
        StringBuilder all = new StringBuilder(
                SceneWriter.toJson(scene.withoutAnimation().withInstants(List.of()), new SceneWriter.FileNames() {
                    @Override
                    public String of(Path file) {
                        return images.computeIfAbsent(file, SceneFingerprint::hashOf);
                    }

                    @Override
                    public Optional<String> of(TriangleMesh mesh) {
                        return Optional.of(mesh.digest());
                    }
                }));
        scene.instants().forEach(instant -> all.append(json(instant)));
        return all.toString();
    }

    private static String hashOf(Path image) {
        try {
            return ContentHash.of(InputFile.bytes(image)).toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
