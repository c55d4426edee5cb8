package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Version;
import enlightenment.file.WholeFile;
import enlightenment.scene.Method;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

class RenderCommandTest extends SceneFixture {
    RenderCommandTest() {
        super(20, 12);
    }

    @Test
    void aPictureHasTheSceneSizeAndSaysWhatItIs() throws IOException {
        CliRun run = CliRun.of("render", scene, "-o", picture, "--antialias", "1");
        assertEquals(new CliRun(0, "", ""), run);
        BufferedImage image = ImageIO.read(picture.toFile());
        assertEquals(20, image.getWidth());
        assertEquals(12, image.getHeight());
        String bytes = Files.readString(picture, StandardCharsets.ISO_8859_1);
        assertTrue(bytes.contains("Two balls"), "title");
        assertTrue(bytes.contains("Enlightenment " + Version.number()), "software");
        assertTrue(bytes.contains("method=raytrace size=20x12 antialias=1 shadowSamples=10 seed=0"), "settings");
    }

    @Test
    void theNumberOfThreadsDoesNotChangeAByte() throws IOException {
        Path other = folder.resolve("other.png");
        assertEquals(
                0, CliRun.of("render", scene, "-o", picture, "--threads", "1").code());
        assertEquals(
                0, CliRun.of("render", scene, "-o", other, "--threads", "3").code());
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(other));
    }

    @Test
    void aCropHasThePixelsOfTheWhole() throws IOException {
        Path part = folder.resolve("part.png");
        CliRun.of("render", scene, "-o", picture, "--size", "30x20", "--seed", "-5");
        CliRun.of("render", scene, "-o", part, "--size", "30x20", "--seed", "-5", "--crop", "3,4,10,9");
        BufferedImage whole = ImageIO.read(picture.toFile()).getSubimage(3, 4, 10, 9);
        BufferedImage crop = ImageIO.read(part.toFile());
        assertArrayEquals(whole.getRGB(0, 0, 10, 9, null, 0, 10), crop.getRGB(0, 0, 10, 9, null, 0, 10));
    }

    @Test
    void theReportIsJsonThatAgreesWithThePicture() throws IOException {
        Path report = folder.resolve("report.json");
        CliRun run =
                CliRun.of("render", scene, "-o", picture, "--antialias", "2", "--report", report, "--crop", "1,2,8,4");
        assertEquals(0, run.code(), run.err());
        JsonNode json = new ObjectMapper().readTree(Files.readString(report));
        assertTrue(json.get("complete").asBoolean());
        assertEquals("Two balls", json.get("scene").asString());
        assertEquals(32, json.get("pixels").asLong());
        // Two by two positions in each of the pixels.
        assertEquals(128, json.get("rays").get("camera").asLong());
        assertEquals(8, json.get("settings").get("crop").get(2).asInt());
        assertEquals("render", json.get("phases").get(2).get("name").asString());
    }

    @Test
    void statsShowEveryCount() {
        CliRun run = CliRun.of("render", scene, "-o", picture, "--antialias", "1", "--stats");
        assertTrue(run.out().matches("(?s)rays: camera +240\n.*"), run.out());
        for (String label : List.of(
                "rays: shadow",
                "rays in all",
                "light samples",
                "  without a ray",
                "sphere",
                "texture look-ups",
                "time: render",
                "rays per second",
                "peak memory")) {
            assertEquals(
                    1,
                    run.outLines().stream()
                            .filter(l -> l.startsWith(label + " "))
                            .count(),
                    label);
        }
    }

    @Test
    void badValuesNameTheOptionAndWhatIsExpected() throws IOException {
        refused(
                "--size must be WIDTHxHEIGHT, two whole numbers in 1..65536 such as 800x400, not \"0x5\"",
                "--size",
                "0x5");
        refused(
                "--size must be WIDTHxHEIGHT, two whole numbers in 1..65536 such as 800x400, not \"12\"",
                "--size",
                "12");
        refused(
                "--size must be WIDTHxHEIGHT, two whole numbers in 1..65536 such as 800x400, not \"65537x1\"",
                "--size",
                "65537x1");
        refused("--crop must lie inside the picture of 20x12 pixels, not 0,0,21,1", "--crop", "0,0,21,1");
        refused(
                "--crop must lie inside the picture of 20x12 pixels, not 2147483647,0,1,1",
                "--crop",
                "2147483647,0,1,1");
        refused(
                "--crop must be X,Y,WIDTH,HEIGHT, four whole numbers in pixels such as 0,0,100,50, not \"1,2\"",
                "--crop",
                "1,2");
        refused("--threads must be a whole number in 1..4096, not \"0\"", "--threads", "0");
        refused("--antialias must be a whole number in 1..256, not \"257\"", "--antialias", "257");
        refused("--shadow-samples must be a whole number in 1..1000000, not \"x\"", "--shadow-samples", "x");
        refused(
                "--seed must be a whole number in -9223372036854775808..9223372036854775807, not \"1.5\"",
                "--seed",
                "1.5");
        refused("--frame must be a whole number in 0..2147483647, not \"-1\"", "--frame", "-1");
        refused(
                "--method must be one of " + String.join(", ", Method.words(Method.selectable())) + ", not \"magic\"",
                "--method",
                "magic");
        refused("--depth must be one of 8, 16, 32, not \"12\"", "--depth", "12");
        refused("--progress must be one of auto, bar, plain, none, not \"x\"", "--progress", "x");
    }

    private void refused(String message, String... options) throws IOException {
        Files.writeString(picture, "precious");
        CliRun run = CliRun.of(Stream.concat(Stream.of("render", scene, "-o", picture), Stream.of(options))
                .toArray());
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), run);
        assertEquals("precious", Files.readString(picture));
        assertEquals(2, files(), "nothing is left behind");
    }

    private long files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.count();
        }
    }

    @Test
    void aPictureThatCannotFitIsRefusedBeforeAnythingIsAllocated() {
        // JPEG files are written from memory; others from a file, which may fit on a large disk.
        Path photo = folder.resolve("picture.jpg");
        CliRun run = CliRun.of("render", scene, "-o", photo, "--size", "60000x60000");
        assertEquals(2, run.code());
        assertTrue(
                run.err().startsWith("enlightenment: --size: a picture of 60000x60000 pixels needs 187200000000 bytes"),
                run.err());
        assertFalse(Files.exists(photo));
    }

    @Test
    void anUnknownExtensionIsRefused() {
        Path gif = folder.resolve("picture.gif");
        CliRun run = CliRun.of("render", scene, "-o", gif);
        assertEquals(
                new CliRun(
                        2,
                        "",
                        "enlightenment: -o must name a file that ends in .png, .jpg, .pfm or .exr, not \"" + gif
                                + "\"\n"),
                run);
    }

    @Test
    void depthIsRefusedForFloats() {
        CliRun run = CliRun.of("render", scene, "-o", folder.resolve("p.pfm"), "--depth", "8");
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("enlightenment: --depth must not be given for a .pfm file"), run.err());
    }

    @Test
    void aTargetThatCannotBeWrittenIsToldBeforeTheRender() throws IOException {
        Path missing = folder.resolve("missing");
        Path target = missing.resolve("p.png");
        failed(target + ": cannot be written: there is no folder " + missing, "-o", target);
        Path directory = Files.createDirectory(folder.resolve("folder.png"));
        failed(directory + ": cannot be written: it is a folder", "-o", directory);
        Path inFile = scene.resolve("p.png");
        failed(inFile + ": cannot be written: " + scene + " is not a folder", "-o", inFile);
        Path report = missing.resolve("r.json");
        failed(report + ": cannot be written: there is no folder " + missing, "-o", picture, "--report", report);
        assertFalse(Files.exists(picture));
    }

    private void failed(String message, Object... options) {
        CliRun run = CliRun.of(
                Stream.concat(Stream.of("render", scene), Stream.of(options)).toArray());
        assertEquals(new CliRun(1, "", "enlightenment: " + message + "\n"), run);
    }

    @Test
    void aReportNeverReplacesTheSceneNorThePicture() throws IOException {
        String before = Files.readString(scene);
        CliRun run = CliRun.of("render", scene, "-o", picture, "--report", scene);
        assertEquals(new CliRun(2, "", "enlightenment: --report would write over the scene, \"" + scene + "\"\n"), run);
        assertEquals(before, Files.readString(scene));
        assertEquals(
                2,
                CliRun.of("render", scene, "-o", picture, "--report", folder.resolve("./p.png"))
                        .code());
        assertFalse(Files.exists(picture));
    }

    @Test
    void aMissingSceneIsAWrongInput() {
        Path missing = folder.resolve("missing.json");
        CliRun run = CliRun.of("render", missing, "-o", picture);
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith(missing + ": "), run.err());
        assertEquals(1, run.errLines().size());
    }

    @Test
    void aBadSceneIsToldWithAllItsProblemsAndNothingIsWritten() throws IOException {
        Path bad = CliRun.badScene(folder);
        CliRun run = CliRun.of("render", bad, "-o", picture);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("/objects/0/radius"), run.err());
        assertTrue(run.err().contains("/lights/0"), run.err());
        for (String line : run.errLines()) {
            assertTrue(line.matches("\\Q" + bad + "\\E:\\d+:\\d+: .*"), line);
        }
        assertFalse(Files.exists(picture));
    }

    @Test
    void aRenderStoppedBeforeItBeganWritesNothing() throws IOException {
        Files.writeString(picture, "precious");
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        CliRun run = CliRun.of(stop, "render", scene, "-o", picture);
        assertEquals(
                new CliRun(
                        1,
                        "",
                        "enlightenment: stopped before anything was rendered; " + picture + " was not written\n"),
                run);
        assertEquals("precious", Files.readString(picture));
    }

    @Test
    void aRenderStoppedWhileALargeSceneIsPreparedWritesNothing() throws IOException {
        Files.writeString(picture, "precious");
        String balls = IntStream.range(0, 3000)
                .mapToObj(i -> "{ \"type\": \"sphere\", \"center\": [" + i + ", 0, 9], \"radius\": 0.4, "
                        + "\"material\": { \"type\": \"matte\", \"color\": \"#ffffff\" } }")
                .collect(Collectors.joining(",\n"));
        Path large = Files.writeString(
                folder.resolve("large.json"),
                """
                { "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "objects": [%s] }
                """
                        .formatted(balls));
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        for (String[] more : new String[][] {
            {"-o", picture.toString()}, {"-o", folder.resolve("a.film").toString(), "--part", "1/2"}
        }) {
            CliRun run = CliRun.of(
                    stop,
                    Stream.concat(Stream.of("render", large), Stream.of(more)).toArray());
            assertEquals(1, run.code(), run.err());
            assertTrue(run.err().startsWith("enlightenment: stopped before anything was rendered"), run.err());
        }
        assertEquals("precious", Files.readString(picture));
    }

    @Test
    void aPartStoppedBeforeItBeganWritesNothing() {
        Path part = folder.resolve("p.film");
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        CliRun run = CliRun.of(stop, "render", scene, "-o", part, "--part", "1/2");
        assertEquals("enlightenment: stopped before anything was rendered; " + part + " was not written\n", run.err());
        assertEquals(1, run.code());
        assertFalse(Files.exists(part));
    }

    @Test
    void theBarShowsThatAllIsDone() {
        CliRun run = CliRun.of("render", scene, "-o", picture, "--progress", "bar");
        assertEquals(0, run.code());
        assertTrue(run.err().contains("100%"), run.err());
    }

    @Test
    void aFullDiskOrSuchIsAFailureWithoutATrace() throws IOException {
        // A report that cannot replace a folder which appears only after the check has the same path as any failed
        // write.
        Path target = Files.createDirectory(folder.resolve("r.json"));
        Files.writeString(target.resolve("inside"), "");
        IOException e =
                org.junit.jupiter.api.Assertions.assertThrows(IOException.class, () -> WholeFile.write(target, "text"));
        assertTrue(e.getMessage().startsWith("cannot write " + target + ": "), e.getMessage());
        assertEquals(2, files(), "the part is gone");
    }
}
