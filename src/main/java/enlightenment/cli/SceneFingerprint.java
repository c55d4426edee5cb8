package enlightenment.cli;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** Tells a scene from all others. */
final class SceneFingerprint {
    private SceneFingerprint() {}

    /** The SHA-256, in hexadecimal digits, of all that the scene holds, with the contents of its image files. */
    static String of(Scene scene) throws IOException {
        try {
            String json = SceneWriter.toJson(scene.withoutAnimation(), SceneFingerprint::hashOf);
            return hash(json.getBytes(StandardCharsets.UTF_8));
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private static String hashOf(Path image) {
        try {
            return hash(Files.readAllBytes(image));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String hash(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
