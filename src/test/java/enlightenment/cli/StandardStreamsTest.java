package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The name {@code -} for standard input and standard output. */
class StandardStreamsTest {
    @TempDir
    Path folder;

    private Path scene;
    private Path picture;

    private record Run(int code, byte[] out, String err) {
        String text() {
            return new String(out, StandardCharsets.UTF_8);
        }
    }

    private static Run run(byte[] in, Object... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Terminal terminal = new Terminal(
                new ByteArrayInputStream(in),
                new PrintStream(out, true),
                new PrintStream(err, true),
                new ShutdownSignal());
        String[] texts = CliRun.quiet(Stream.of(args).map(Object::toString).toArray(String[]::new));
        int code = Main.run(texts, terminal);
        return new Run(code, out.toByteArray(), err.toString(StandardCharsets.UTF_8));
    }

    @BeforeEach
    void render() throws IOException {
        scene = CliRun.scene(folder, "\"width\": 20, \"height\": 12");
        picture = folder.resolve("p.png");
        assertEquals(0, CliRun.of("render", scene, "-o", picture).code());
    }

    @Test
    void standardOutputGetsTheBytesOfTheFile() throws IOException {
        Run run = run(new byte[0], "render", scene, "-o", "-");
        assertEquals("", run.err());
        assertEquals(0, run.code());
        assertArrayEquals(Files.readAllBytes(picture), run.out());
    }

    @Test
    void anExrFileThereHasItsChannels() throws IOException {
        Path file = folder.resolve("p.exr");
        assertEquals(0, CliRun.of("render", scene, "-o", file, "--aov", "depth").code());
        Run run = run(new byte[0], "render", scene, "-o", "-", "--format", "exr", "--aov", "depth");
        assertEquals("", run.err());
        assertArrayEquals(Files.readAllBytes(file), run.out());
    }

    @Test
    void nothingElseGoesThere() throws IOException {
        Run run = run(
                new byte[0],
                "render",
                scene,
                "-o",
                "-",
                "--stats",
                "--time",
                "0.1",
                "--progress",
                "plain",
                "--depth",
                "16");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.err().contains("makes the same picture"), run.err());
        assertTrue(run.err().contains("samples per pixel"), run.err());
        Path copy = Files.write(folder.resolve("copy.png"), run.out());
        assertEquals(20, enlightenment.image.ImageFiles.read(copy).width());
        // The last chunk of the file is the last that was written.
        assertEquals("IEND", new String(run.out(), run.out().length - 8, 4, StandardCharsets.US_ASCII));
    }

    @Test
    void floatsGoThereOnDemand() throws IOException {
        Path floats = folder.resolve("p.pfm");
        assertEquals(0, CliRun.of("render", scene, "-o", floats).code());
        Run run = run(new byte[0], "render", scene, "-o", "-", "--format", "pfm");
        assertEquals(0, run.code(), run.err());
        assertArrayEquals(Files.readAllBytes(floats), run.out());
    }

    @Test
    void aSceneComesFromStandardInput() throws IOException {
        byte[] text = Files.readAllBytes(scene);
        Path other = folder.resolve("q.png");
        Run run = run(text, "render", "-", "-o", other);
        assertEquals("", run.err());
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(other));
        run = run(text, "render", "-", "-o", "-");
        assertArrayEquals(Files.readAllBytes(picture), run.out());
        assertEquals("standard input: valid\n", run(text, "validate", "-").text());
        assertTrue(run(text, "inspect", "-").text().startsWith("name:             Two balls\n"));
    }

    @Test
    void problemsOfStandardInputHaveTheirPlace() throws IOException {
        byte[] bad = Files.readAllBytes(CliRun.badScene(folder));
        for (List<String> command : List.of(List.of("render", "-", "-o", "-"), List.of("validate", "-"))) {
            Run run = run(bad, command.toArray());
            assertEquals(2, run.code());
            assertEquals(0, run.out().length);
            assertTrue(run.err().matches("(?s).*\nstandard input:\\d+:\\d+: /objects/0/radius: must be .*"), run.err());
        }
        assertTrue(run(new byte[0], "validate", "-").err().contains("is empty"));
        assertTrue(run(new byte[] {(byte) 0xff}, "validate", "-").err().contains("UTF-8"));
    }

    /** Also of what is seen only when the scene is put together. */
    @Test
    void problemsOfLightsThatAreTooSmallHaveTheirPlace() {
        String text =
                """
                { "image": { "width": 4, "height": 4 }, "shading": { "model": "physical" }, "objects": [],
                  "camera": { "type": "isometric", "lookAt": [0, 0, 0], "height": 4 },
                  "lights": [ { "type": "sphere", "center": [0, 3, 0], "radius": 1e-60, "color": "#fff",
                    "power": 1e60 } ] }
                """;
        Run run = run(text.getBytes(StandardCharsets.UTF_8), "validate", "-");
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("standard input:4:14: /lights/0/power: is too much"), run.err());
    }

    @Test
    void texturesAreRelativeToTheWorkingFolder() {
        String text =
                """
                { "image": { "width": 4, "height": 4 },
                  "camera": { "type": "isometric", "lookAt": [0, 0, 0], "height": 3 },
                  "textures": { "t": { "file": "textures/no-such-file.png" } },
                  "objects": [] }
                """;
        String err = run(text.getBytes(StandardCharsets.UTF_8), "validate", "-").err();
        assertTrue(err.contains("(" + Path.of("textures/no-such-file.png").toAbsolutePath() + ")"), err);
    }

    @Test
    void anNffFileIsConvertedInAPipe() throws IOException {
        String nff = "v\nfrom 0 0 -5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 16 16\n"
                + "l 2 3 -2\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n";
        Run run = run(nff.getBytes(StandardCharsets.UTF_8), "convert", "-", "-");
        assertEquals(0, run.code(), run.err());
        assertEquals("standard input: valid\n", run(run.out(), "validate", "-").text());
    }

    @Test
    void partsAreMergedToStandardOutput() throws IOException {
        Path part = folder.resolve("a.film");
        assertEquals(0, CliRun.of("render", scene, "--part", "1/1", "-o", part).code());
        Run run = run(new byte[0], "merge", part, "-o", "-");
        assertEquals("", run.err());
        assertArrayEquals(Files.readAllBytes(picture), run.out());
    }

    @Test
    void whatNeedsAFileSaysSo() {
        refused("--aov writes files beside the picture: -o must name a file, not standard output", "--aov", "depth");
        refused("--preview replaces the picture: -o must name a file, not standard output", "--preview", "1");
        refused("--format must be one of png, jpg, pfm, exr, not \"bmp\"", "--format", "bmp");
        refused("--depth must not be given for --format pfm, which holds floats", "--format", "pfm", "--depth", "8");
        refused(
                "only the picture (-o) can go to standard output, \"-\"; \"./-\" is a file of that name",
                "--report",
                "-");
        Run run = run(new byte[0], "render", scene, "-o", picture, "--format", "png");
        assertEquals(
                "enlightenment: --format must only be given with -o -: the name of a file tells its format\n",
                run.err());
        run = run(new byte[0], "trade", "-", "-o", folder.resolve("trade"));
        assertEquals("enlightenment: a trade needs a scene file, not standard input: it can be resumed\n", run.err());
    }

    private void refused(String message, Object... options) {
        Run run = run(
                new byte[0],
                Stream.concat(Stream.of("render", scene, "-o", "-"), Stream.of(options))
                        .toArray());
        assertEquals("enlightenment: " + message + "\n", run.err());
        assertEquals(2, run.code());
        assertEquals(0, run.out().length);
    }
}
