package enlightenment.cli.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is said of a picture that is not as exact as it should be. */
class RequestedErrorTest {
    @TempDir
    Path folder;

    /** One sample of twenty sees a glow that 8 bits show as 13: its mean lies between 0 and 1. A single sample does not tell. */
    @Test
    void whatAFilesRoundingAloneMakesIsSaid() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("dark.json"),
                """
                { "image": { "width": 24, "height": 16 }, "shading": { "model": "physical" },
                  "camera": { "type": "orthographic", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "height": 2 },
                  "objects": [
                    { "type": "rectangle", "corners": [[-4, -4, 0], [-4, 4, 0], [4, 4, 0], [4, -4, 0]],
                      "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1, "transparency": 0.05 } },
                    { "type": "rectangle", "corners": [[-4, -4, 1], [-4, 4, 1], [4, 4, 1], [4, -4, 1]],
                      "material": { "type": "matte", "color": "#000000", "radiance": 0.004 } }
                  ] }
                """);
        CliRun coarse = CliRun.of("render", scene, "-o", folder.resolve("a.png"), "--error", "0.001");
        assertEquals(1, coarse.code(), coarse.err());
        assertTrue(coarse.err().contains("the file's rounding alone makes 0.001"), coarse.err());
        assertTrue(coarse.err().contains("whatever the samples: --depth 16"), coarse.err());
        CliRun fine = CliRun.of("render", scene, "-o", folder.resolve("b.png"), "--error", "0.001", "--depth", "16");
        assertEquals(0, fine.code(), fine.err());
    }
}
