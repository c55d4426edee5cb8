package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes and files of strangers: what they quote does nothing to the terminal, and begins no line of its own. */
class HarmlessTextTest {
    /** As JSON: clears the screen, sets the title, begins a line that looks like ours, turns the direction of reading. */
    private static final String NASTY =
            "\\u001b[2J\\u001b]0;x\\u0007\\u009b31m\\nenlightenment: all is well\\r\\u202egnp.\\u2066";

    @TempDir
    Path folder;

    private static void assertHarmless(CliRun run) {
        for (String text : new String[] {run.out(), run.err()}) {
            assertEquals(Plain.lines(text), text);
            assertFalse(text.lines().anyMatch(line -> line.startsWith("enlightenment: all is well")), text);
        }
    }

    private Path scene(String texture, String name) throws IOException {
        String text = Files.readString(CliRun.scene(folder, "\"width\": 8, \"height\": 8"))
                .replace("\"name\": \"Two balls\"", "\"name\": \"" + name + "\"")
                .replace(
                        "\"color\": \"#ffffff\" } }",
                        "\"color\": { \"texture\": \"" + name + "\" } } }," + " \"textures\": { \"" + name
                                + "\": { \"file\": \"" + texture + "\" } }");
        assertTrue(text.contains("\"file\""), text);
        return Files.writeString(folder.resolve("nasty.json"), text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"validate", "inspect", "render", "server"})
    void aTexturePathIsQuotedWithoutItsControlCharacters(String command) throws IOException {
        Path scene = scene(NASTY + ".png", "board");
        boolean makes = command.equals("render") || command.equals("server");
        CliRun run = makes
                ? CliRun.of(command, scene, "-o", folder.resolve("x.png"), "--progress", "none")
                : CliRun.of(command, scene);
        assertHarmless(run);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains("?[2J"), run.err());
    }

    @Test
    void soAreNamesAndKeys() throws IOException {
        Path texture = folder.resolve("t.png");
        CliRun made = CliRun.of(
                "render", CliRun.scene(folder, "\"width\": 8, \"height\": 8"), "-o", texture, "--progress", "none");
        assertEquals(0, made.code(), made.err());
        Path scene = scene("t.png", NASTY);
        assertHarmless(CliRun.of("validate", scene));
        assertHarmless(CliRun.of("inspect", scene));
        assertHarmless(CliRun.of("render", scene, "-o", folder.resolve("x.png"), "--progress", "none", "--stats"));
        String broken = Files.readString(scene).replace("\"radius\": 0.5", "\"" + NASTY + "\": \"" + NASTY + "\"");
        assertHarmless(CliRun.of("validate", Files.writeString(scene, broken)));
    }

    @Test
    void soAreTheNamesOfOutputs() throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        String nasty = "x\nenlightenment: all is well";
        for (Object[] args : List.of(
                new Object[] {"render", scene, "-o", nasty + ".gif"},
                new Object[] {"render", scene, "-o", folder.resolve(nasty).resolve("o.png")},
                new Object[] {
                    "render",
                    scene,
                    "-o",
                    folder.resolve("o.png"),
                    "--report",
                    folder.resolve(nasty).resolve("r.json")
                },
                new Object[] {"animate", scene, "-o", nasty + ".png"},
                new Object[] {"server", scene, "-o", nasty + ".gif"},
                new Object[] {"compare", nasty + ".png", nasty + ".png"},
                new Object[] {"store-info", folder.resolve(nasty)},
                new Object[] {nasty})) {
            CliRun run = CliRun.of(args);
            assertHarmless(run);
            assertTrue(run.code() != 0 && run.err().contains("x?enlightenment: all is well"), run.err());
        }
    }

    @Test
    void soIsWhatAPartOrAnNffFileSays() throws IOException {
        Path part = folder.resolve("part.film");
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", part, "--part", "1/1", "--progress", "none")
                        .code());
        Files.write(folder.resolve("bad.film"), "\u001b[2JENLPART1\u001b[2J\n".getBytes(StandardCharsets.UTF_8));
        assertHarmless(CliRun.of("merge", part, folder.resolve("bad.film"), "-o", folder.resolve("y.png")));
        Path nff = Files.writeString(folder.resolve("x.nff"), "v\nfrom 0 0 \u001b[2J\u202e\n\u001b]0;x\u0007 1 2\n");
        assertHarmless(CliRun.of("convert", nff, folder.resolve("x.json")));
    }
}
