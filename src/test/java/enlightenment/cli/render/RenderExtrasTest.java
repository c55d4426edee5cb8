package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import enlightenment.cli.SceneFixture;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.image.ImageFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** The options for what there is beside the finished picture. */
class RenderExtrasTest extends SceneFixture {
    private static final String ALL = "error,samples,depth,normal,object";
    private static final String WRITER = "preview";
    private static final int SIGTERM_EXIT = 128 + 15;

    @RegisterExtension
    final Processes processes = new Processes();

    RenderExtrasTest() {
        super(40, 24);
    }

    private Set<String> files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.map(f -> f.getFileName().toString()).collect(Collectors.toCollection(TreeSet::new));
        }
    }

    @Test
    void picturesOfAllThatCanBeToldAppearBesideThePicture() throws IOException {
        assertEquals(new CliRun(0, "", ""), render("--aov", ALL));
        assertEquals(
                Set.of(
                        "p.depth.png",
                        "p.error.png",
                        "p.normal.png",
                        "p.object.png",
                        "p.png",
                        "p.samples.png",
                        "scene.json"),
                files());
        for (String word : ALL.split(",")) {
            Path file = folder.resolve("p." + word + ".png");
            String bytes = Files.readString(file, StandardCharsets.ISO_8859_1);
            assertTrue(bytes.contains("method=raytrace size=40x24"), word);
            assertTrue(bytes.contains("Comment"), word);
            // The heat maps have a scale of 15 rows below.
            int scale = word.equals("error") || word.equals("samples") ? 15 : 0;
            assertEquals(24 + scale, ImageFiles.read(file).height(), word);
        }
        String depth = Files.readString(folder.resolve("p.depth.png"), StandardCharsets.ISO_8859_1);
        assertTrue(depth.contains("in the scene's units"));
    }

    @Test
    void besideFloatsThereAreTheRawNumbers() throws IOException {
        picture = folder.resolve("p.PFM");
        assertEquals(new CliRun(0, "", ""), render("--aov", "samples,depth,object", "--antialias", "3"));
        assertEquals(Set.of("p.PFM", "p.samples.PFM", "p.depth.PFM", "p.object.PFM", "scene.json"), files());
        Image samples = ImageFiles.read(folder.resolve("p.samples.PFM"));
        assertEquals(9, samples.component(20, 12, 0));
        // The ball of radius 1 is seen from 5 before its centre.
        assertEquals(4, ImageFiles.read(folder.resolve("p.depth.PFM")).component(20, 12, 1), 0.01);
        assertEquals(0, ImageFiles.read(folder.resolve("p.object.PFM")).component(20, 12, 1));
        assertEquals(-1, ImageFiles.read(folder.resolve("p.object.PFM")).component(0, 0, 1));
    }

    @Test
    void whatIsWrongWithTheListIsToldBeforeAnythingIsDone() throws IOException {
        refused(
                "--aov must be one of error, samples, depth, normal, position, object, albedo, direct, indirect, not \"eror\"",
                "--aov",
                "error,eror");
        refused(
                "--aov must be one of error, samples, depth, normal, position, object, albedo, direct, indirect, not \"\"",
                "--aov",
                "error,");
        refused("--aov names depth twice", "--aov", "depth,error,depth");
        Path report = folder.resolve("p.error.png");
        refused(
                "--report and --aov error would write the same file, \"" + report + "\"",
                "--aov",
                "error",
                "--report",
                report);
        Path moved = Files.move(scene, folder.resolve("p.depth.png"));
        scene = moved;
        refused("--aov depth would write over the scene, \"" + moved + "\"", "--aov", "depth");
        assertEquals(Set.of("p.depth.png"), files());
    }

    @Test
    void aFileThatCannotBeWrittenIsToldBeforeTheRender() throws IOException {
        Path taken = Files.createDirectory(folder.resolve("p.normal.png"));
        assertEquals(
                new CliRun(1, "", "enlightenment: " + taken + ": cannot be written: it is a folder\n"),
                render("--aov", "normal"));
        assertFalse(Files.exists(picture));
    }

    @Test
    void thePictureIsTheSameWithPreviews() throws IOException {
        for (String method : List.of("raytrace", "cluster")) {
            render("--method", method, "--antialias", "8");
            byte[] plain = Files.readAllBytes(picture);
            assertEquals(new CliRun(0, "", ""), render("--method", method, "--antialias", "8", "--preview", "0.01"));
            assertArrayEquals(plain, Files.readAllBytes(picture));
        }
        assertEquals(Set.of("p.png", "scene.json"), files());
        refused("--preview must be a number in 0.01..1000000000, not \"0\"", "--preview", "0");
        refused("--preview must be a number in 0.01..1000000000, not \"soon\"", "--preview=soon");
    }

    /** The clock of this test goes on by a minute at each look, after the preview that is under way has been written. */
    @Test
    @Timeout(600)
    void previewsAreWholePicturesAndBecomeFiner() throws IOException {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Terminal terminal = new Terminal(null, new PrintStream(err, true), new ShutdownSignal());
        AtomicLong minutes = new AtomicLong();
        List<Image> previews = new ArrayList<>();
        RenderCommand command = new RenderCommand(terminal, () -> {
            if (!Thread.currentThread().getName().equals(WRITER)) {
                takePreview(previews);
                minutes.incrementAndGet();
            }
            return minutes.get() * 60_000_000_000L;
        });
        new CommandLine(command)
                .parseArgs(
                        scene.toString(),
                        "-o",
                        picture.toString(),
                        "--preview",
                        "1",
                        "--threads",
                        "1",
                        "--progress",
                        "none");
        assertEquals(0, command.execute());
        assertEquals("", err.toString(StandardCharsets.UTF_8));
        Image end = ImageFiles.read(picture);
        assertTrue(previews.size() >= 3, previews.size() + " previews");
        double before = Double.POSITIVE_INFINITY;
        for (Image preview : List.of(previews.get(0), previews.get(previews.size() / 2))) {
            assertEquals(40, preview.width());
            assertEquals(24, preview.height());
            for (int x = 0; x < 40; x++) {
                assertTrue(preview.component(x, 23, 0) > 0, "the ground fills the lowest row");
            }
            double error = ImageError.between(preview, end).rmse();
            assertTrue(error > 0 && error < before, "error " + error);
            before = error;
        }
    }

    /** Waits for a preview that is being written, and takes it away, so that the next one is seen to come. */
    private void takePreview(List<Image> previews) {
        try {
            for (Thread thread : Thread.getAllStackTraces().keySet()) {
                if (thread.getName().equals(WRITER)) {
                    thread.join();
                }
            }
            if (Files.exists(picture)) {
                String bytes = Files.readString(picture, StandardCharsets.ISO_8859_1);
                assertTrue(bytes.contains("preview"), "it says that it is a preview");
                previews.add(ImageFiles.read(picture));
                Files.delete(picture);
            }
        } catch (IOException | InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private void refused(String message, Object... options) {
        assertEquals(new CliRun(2, "", "enlightenment: " + message + "\n"), render(options));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.25", "0.001", "0.000000001", "1e-9"})
    @Timeout(600)
    void aTimeIsToldAsANumberOfSamplesThatMakesTheSameBytes(String time) throws IOException {
        CliRun run = render("--time", time, "--threads", "2");
        assertEquals(0, run.code());
        List<String> said = run.errLines();
        String last = said.get(said.size() - 1);
        assertTrue(last.matches("time [0-9.]+ s: --samples [0-9.]+ makes the same picture"), run.err());
        // How much fits into a moment depends on the machine, but nothing fits into less than an instant.
        boolean mayFit = Double.parseDouble(time) >= 0.001;
        assertTrue(said.size() == 1 && mayFit || said.get(0).contains(" is too short: "), run.err());
        assertTrue(said.size() <= 2, run.err());
        byte[] timed = Files.readAllBytes(picture);
        String samples = last.replaceAll(".*--samples ([0-9.]+) .*", "$1");
        assertTrue(said.size() == 1 || samples.equals("1"), run.err());
        assertEquals(new CliRun(0, "", ""), render("--samples", samples));
        assertArrayEquals(Files.readAllBytes(picture), timed);
    }

    @Test
    void anErrorThatIsNotReachedIsToldAndTheExitCodeSaysSo() throws IOException {
        Path report = folder.resolve("r.json");
        CliRun run = render("--error", "0.001", "--depth", "16", "--samples", "2", "--stats", "--report", report);
        assertEquals(1, run.code());
        List<String> said = run.errLines();
        assertTrue(
                said.get(said.size() - 1)
                        .matches("enlightenment: the error is about 0\\.[0-9]+ and may be 0\\.[0-9]+, more than"
                                + " --error 0\\.001; decided by samples; try --samples [0-9.]+ or more"),
                run.err());
        assertTrue(run.out().matches("(?s).*\nerror asked for +0\\.00100 +not met;.*"), run.out());
        assertTrue(Files.readString(report).contains("\"errorMet\": false"));
        byte[] bytes = Files.readAllBytes(picture);
        assertEquals(0, render("--samples", "2", "--depth", "16").code());
        assertArrayEquals(Files.readAllBytes(picture), bytes);
        CliRun met = render("--error", "0.5", "--stats");
        assertEquals("", met.err());
        assertTrue(met.out().matches("(?s).*\nerror asked for +0\\.50000 +met; .*"), met.out());
    }

    /** Rounds and all: what the report says makes the same file, and no round is silent. */
    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "cluster"})
    void anErrorIsToldAsANumberOfSamplesThatMakesTheSameBytes(String method) throws IOException {
        Path report = folder.resolve("r.json");
        CliRun run = render("--method", method, "--error", "0.02", "--report", report);
        assertEquals(0, run.code(), run.err());
        JsonNode sampling =
                new ObjectMapper().readTree(Files.readString(report)).get("sampling");
        assertTrue(sampling.get("errorMet").asBoolean());
        assertEquals(sampling.get("rounds").asInt() - 1, run.errLines().size());
        assertTrue(run.errLines().stream().allMatch(line -> line.contains("once more with")), run.err());
        byte[] bytes = Files.readAllBytes(picture);
        assertEquals(
                0,
                render(
                                "--method",
                                method,
                                "--samples",
                                sampling.get("plannedSamples").asString())
                        .code());
        assertArrayEquals(Files.readAllBytes(picture), bytes);
    }

    /** Sixteen bits can keep what eight cannot; where nothing else ends the render it is refused before it begins. */
    @ParameterizedTest
    @ValueSource(strings = {"256x160", "16x16"})
    void anErrorBelowTheRoundingOfTheFileIsRefusedBeforeTheRender(String size) {
        CliRun run = render("--size", size, "--error", "0.0005");
        assertEquals(2, run.code());
        assertTrue(
                run.err()
                        .matches(
                                "enlightenment: --error cannot be kept: rounding to 8 bits makes an error of about 0\\.[0-9]+,"
                                        + " of 0\\.0005[0-9]* that is asked for; more bits \\(--depth 16\\) or a .pfm file can\n"),
                run.err());
        assertFalse(Files.exists(picture));
        CliRun limited = render("--size", size, "--error", "0.0005", "--samples", "2");
        assertEquals(1, limited.code());
        assertTrue(limited.err().contains("it cannot be kept\n"), limited.err());
        assertTrue(Files.exists(picture));
    }

    @Test
    @Timeout(600)
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end there")
    void aSignalAfterAPreviewLeavesAWholePicture() throws Exception {
        // Minutes of work wherever it runs, in tiles of less than a second.
        Object[] work = words("render", "--size", "400x240", "--threads", 2, "--samples", 5000, "--preview", 0.1);
        Processes.Running render = processes.start(folder, work);
        render.until("there is a preview", () -> Files.exists(picture));
        assertEquals(400, ImageFiles.read(picture).width());
        render.process().destroy();
        String said = render.ended(SIGTERM_EXIT);
        assertTrue(
                said.matches("enlightenment: stopped: \\Q" + picture
                        + "\\E holds \\d+ % of the picture, and a preview of the rest\n"),
                said);
        Image image = ImageFiles.read(picture);
        for (int x = 0; x < 400; x++) {
            // The ground fills the lowest row.
            assertTrue(image.component(x, 239, 0) > 0);
        }
    }
}
