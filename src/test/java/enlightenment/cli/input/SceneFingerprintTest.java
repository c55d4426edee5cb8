package enlightenment.cli.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneFingerprintTest {
    @TempDir
    Path folder;

    private String fingerprint(Path scene) throws IOException {
        return SceneFingerprint.of(SceneReader.read(scene));
    }

    @Test
    void whatTheSceneHoldsCountsAndItsLayoutDoesNot() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        String first = fingerprint(scene);
        assertTrue(first.matches("[0-9a-f]{64}"), first);
        String text = Files.readString(scene);
        Files.writeString(scene, text.replace("  ", " ").replace("\"radius\": 1,", "\"radius\": 1.0,"));
        assertEquals(first, fingerprint(scene));
        Files.writeString(scene, text.replace("\"radius\": 1,", "\"radius\": 0.9,"));
        assertNotEquals(first, fingerprint(scene));
    }

    @Test
    void thePictureInATextureCountsAndItsPlaceDoesNot() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        Path texture = Files.copy(Path.of("textures/fire.png"), folder.resolve("floor.png"));
        String text = Files.readString(scene)
                .replace("\"materials\"", "\"textures\": { \"t\": { \"file\": \"floor.png\" } }, \"materials\"")
                .replaceFirst("\"color\": \"#ffffff\"", "\"color\": { \"texture\": \"t\" }");
        Files.writeString(scene, text);
        String fire = fingerprint(scene);
        Files.copy(texture, folder.resolve("moved.png"));
        Files.writeString(scene, text.replace("floor.png", "moved.png"));
        assertEquals(fire, fingerprint(scene));
        Files.copy(Path.of("textures/ice.png"), folder.resolve("moved.png"), StandardCopyOption.REPLACE_EXISTING);
        assertNotEquals(fire, fingerprint(scene));
    }
}
