package enlightenment.cli;

import enlightenment.file.ContentHash;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Tells a scene from all others. */
final class SceneFingerprint {
    private SceneFingerprint() {}

    /** The SHA-256, in hexadecimal digits, of all that the scene holds, with the contents of its image files. */
    static String of(Scene scene) throws IOException {
        try {
            String json = SceneWriter.toJson(scene.withoutAnimation(), SceneFingerprint::hashOf);
            return ContentHash.of(json.getBytes(StandardCharsets.UTF_8)).toString();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private static String hashOf(Path image) {
        try {
            return ContentHash.of(Files.readAllBytes(image)).toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
