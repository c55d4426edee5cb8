package enlightenment.cli.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The options for files of other programs, as commands have them. */
class ForeignOptionsTest {
    @TempDir
    Path folder;

    private Path obj() throws IOException {
        return Files.writeString(
                folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\n");
    }

    @Test
    void eachCommandTakesThem() throws IOException {
        Path json = folder.resolve("a.json");
        Object[] choice = {"--up", "-z", "--view", "-30,45.5", "--background", "#ff8000"};
        CliRun converted = run(List.of("convert", obj(), json), choice);
        assertEquals(0, converted.code(), converted.err());
        String text = Files.readString(json);
        assertTrue(text.replaceAll("\\s", "").contains("\"up\":[0,0,-1]"), text);
        assertEquals(0, run(List.of("validate", obj()), choice).code());
        assertEquals(0, run(List.of("inspect", obj()), choice).code());
        Object[] small = {"--size", "8x6", "--samples", "1"};
        Path direct = folder.resolve("direct.png");
        Path byFile = folder.resolve("file.png");
        Object[] both = {
            "--size", "8x6", "--samples", "1", "--up", "-z", "--view", "-30,45.5", "--background", "#ff8000"
        };
        assertEquals(0, run(List.of("render", obj(), "-o", direct), both).code());
        assertEquals(0, run(List.of("render", json, "-o", byFile), small).code());
        assertEquals(-1, Files.mismatch(direct, byFile), "the options are in the scene that is converted");
    }

    private static CliRun run(List<Object> words, Object... more) {
        Object[] all = new Object[words.size() + more.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = i < words.size() ? words.get(i) : more[i - words.size()];
        }
        return CliRun.of(all);
    }

    @Test
    void aSceneFileRefusesThemInOneLine() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        String line = " for files of other programs: " + scene + " says by itself what it shows";
        for (String command : List.of("inspect", "validate")) {
            CliRun run = CliRun.of(command, scene, "--up", "z");
            assertEquals(2, run.code());
            assertEquals(List.of("enlightenment: --up is" + line), run.errLines());
        }
        for (String command : List.of("render", "server", "animate")) {
            CliRun run =
                    CliRun.of(command, scene, "-o", folder.resolve("p-%d.png"), "--background", "sky", "--camera", "0");
            assertEquals(2, run.code());
            assertEquals(List.of("enlightenment: --camera, --background are" + line), run.errLines());
        }
    }

    @Test
    void whatHasNoMeaningIsToldInOneLine() throws IOException {
        refused("--up must be one of x, y, z, -x, -y, -z, not \"w\"", "--up", "w");
        String view = "--view must be AZIMUTH,ELEVATION in degrees, -360..360 and -90..90, such as 30,20, not ";
        for (String bad : List.of("30", "30,91", "NaN,0", "1,2,3", ",", "361,0")) {
            refused(view + "\"" + bad + "\"", "--view", bad);
        }
        String background = "--background must be studio, sky, white, black or #rrggbb, not ";
        for (String bad : List.of("pink", "#12345", "#1234567", "#00000g")) {
            refused(background + "\"" + bad + "\"", "--background", bad);
        }
        refused("--camera and --view choose the view each: one of them is needed", "--view", "1,2", "--camera", "0");
    }

    private void refused(String message, Object... options) throws IOException {
        CliRun run = run(List.of("render", obj(), "-o", folder.resolve("p.png")), options);
        assertEquals(2, run.code());
        assertEquals(List.of("enlightenment: " + message), run.errLines());
    }
}
