package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files of other programs where a scene is expected. */
class ForeignFilesTest extends SceneFixture {
    private static final String OBJ = "o Cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

    /** A stretched sphere, which becomes a mesh. */
    private static final String EGG = "<scene version=\"3.0.0\"><shape type=\"sphere\"><transform name=\"to_world\">"
            + "<scale x=\"2\" y=\"1\" z=\"1\"/></transform></shape></scene>";

    ForeignFilesTest() {
        super(8, 6);
    }

    private Path file(String name, String content) throws IOException {
        return Files.writeString(folder.resolve(name), content);
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "inspect", "validate", "server", "animate", "trade"})
    void everyCommandThatReadsASceneSaysWhatTheFileIsInOneLine(String command) throws IOException {
        Path mesh = file("model.json", OBJ);
        Object[] words = {command, mesh, "-o", folder.resolve(command.equals("animate") ? "f-%d.png" : "p.png")};
        boolean hasOutput = !command.equals("inspect") && !command.equals("validate");
        CliRun run = hasOutput ? CliRun.of(words) : CliRun.of(command, mesh);
        assertEquals(2, run.code(), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(
                run.err().startsWith(mesh + ": is a mesh in the Wavefront OBJ format, not a scene file: "), run.err());
        assertFalse(Files.exists(folder.resolve("p.png")));
    }

    @ParameterizedTest
    @CsvSource({"scene.blend, a scene of Blender's", "scene.pov, a scene of POV-Ray's"})
    void aNameIsEnoughWhereTheContentIsNot(String name, String what) throws IOException {
        Path file = file(name, "\u0001\u0002");
        CliRun run = CliRun.of("render", file, "-o", picture);
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith(file + ": is " + what + ", not a scene file: "), run.err());
        assertEquals(1, run.errLines().size(), run.err());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"model.ply", "model.stl", "model.obj", "model.glb", "model.gltf", "scene.xml", "scene.pbrt"})
    void whatIsNoSuchFileIsRefusedInOneLine(String name) throws IOException {
        Path file = file(name, "\u0001\u0002");
        CliRun run = CliRun.of("render", file, "-o", picture);
        assertEquals(2, run.code());
        assertTrue(run.err().contains(file + ":"), run.err());
        assertEquals(1, run.errLines().size(), run.err());
    }

    @Test
    void ofAFileThatCanBeConvertedTheCommandIsNamed() throws IOException {
        Path file = file("balls.json", "v\nfrom 0 0 -5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\n");
        assertTrue(CliRun.of("render", file, "-o", picture)
                .err()
                .contains("'enlightenment convert IN.nff OUT.json' makes"));
    }

    @Test
    void standardInputIsRecognizedByItsContent() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Terminal terminal = new Terminal(
                new ByteArrayInputStream(OBJ.getBytes(StandardCharsets.US_ASCII)),
                new PrintStream(new ByteArrayOutputStream(), true),
                new PrintStream(err, true, StandardCharsets.UTF_8),
                new ShutdownSignal());
        assertEquals(2, Main.run(CliRun.texts("render", "-", "-o", picture), terminal));
        String said = err.toString(StandardCharsets.UTF_8);
        assertTrue(said.startsWith("standard input: is a mesh in the Wavefront OBJ format"), said);
    }

    @Test
    void aSceneIsASceneWhateverItsName() throws IOException {
        Path odd = Files.copy(scene, folder.resolve("scene.obj"));
        assertEquals(new CliRun(0, "", ""), CliRun.of("render", odd, "-o", picture));
        Path bad = Files.copy(CliRun.badScene(folder), folder.resolve("bad.gltf"));
        assertTrue(CliRun.of("validate", bad).err().contains("/objects/0/radius"));
    }

    @Test
    void aSecondConversionWritesTheSameFiles() throws IOException {
        Path egg = file("c.xml", EGG);
        Path scene = folder.resolve("c.json");
        String first = converted(egg, scene);
        byte[] mesh = Files.readAllBytes(folder.resolve("c-files/mesh-1.ply"));
        assertEquals(first, converted(egg, scene));
        assertArrayEquals(mesh, Files.readAllBytes(folder.resolve("c-files/mesh-1.ply")));
        assertFalse(Files.exists(folder.resolve("c-files/mesh-2.ply")));
    }

    @Test
    void meshesOfAnotherConversionStay() throws IOException {
        Path other = Files.createDirectory(folder.resolve("c-files")).resolve("mesh-1.ply");
        Files.writeString(other, "precious");
        assertTrue(converted(file("c.xml", EGG), folder.resolve("c.json")).contains("c-files/mesh-2.ply"));
        assertEquals("precious", Files.readString(other));
    }

    private static String converted(Path from, Path to) throws IOException {
        CliRun run = CliRun.of("convert", from, to);
        assertEquals(0, run.code(), run.err());
        return Files.readString(to);
    }
}
