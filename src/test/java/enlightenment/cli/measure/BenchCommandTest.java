package enlightenment.cli.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.measure.Bench;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchCommandTest {
    @TempDir
    Path folder;

    @Test
    void itMeasuresThePapersBenchmarkAndEveryScene() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        Files.move(scene, folder.resolve("fire-and-ice.json"));
        Path json = Files.createDirectory(folder.resolve("out")).resolve("bench.json");
        CliRun run =
                CliRun.of("bench", "--scenes", folder, "--repeat", "1", "--json", json, "--methods", "light,cluster");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("processor:"), run.out());
        assertTrue(run.out().contains("paper's benchmark              raytrace 400x200 aa 2 sh 5 th 12 "), run.out());
        assertTrue(run.out().contains("\nfire-and-ice                   cluster 8x8 aa "), run.out());
        // Classic shading is nothing that paths from lights could render.
        assertFalse(run.out().contains("light 8x8"), run.out());
        String text = Files.readString(json);
        // 2 × 2 positions for each of 400 × 200 pixels.
        assertTrue(text.contains("\"name\": \"paper's benchmark\"") && text.contains("\"rays\": "), text);
    }

    @Test
    void thePapersSettingsAreThoseOfItsSource() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        RenderSettings s = Bench.paperSettings(SceneReader.read(scene));
        assertEquals(
                "raytrace 400x200 2 5 12",
                s.method() + " " + s.width() + "x" + s.height() + " " + s.antialias() + " "
                        + BuiltInMethod.RayTraceSettings.of(s).shadowSamples() + " " + s.threads());
    }

    @Test
    void aFolderWithoutTheSceneIsRefused() {
        CliRun run = CliRun.of("bench", "--scenes", folder);
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("enlightenment: --scenes must name the folder"), run.err());
        assertEquals(2, CliRun.of("bench", "--repeat", "0").code());
    }
}
