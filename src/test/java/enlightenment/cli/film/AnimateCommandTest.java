package enlightenment.cli.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AnimateCommandTest {
    private static final String GROWING =
            """
            { "frames": 6, "framesPerSecond": 25,
              "tracks": [{ "target": "/objects/0/radius", "keys": { "0": 1, "5": 2 } }] }
            """;

    @TempDir
    Path folder;

    private Path scene;
    private Path frames;
    private String pattern;

    @BeforeEach
    void writeScene() throws IOException {
        scene = animated(GROWING);
        frames = folder.resolve("frames");
        pattern = frames.resolve("frame-%04d.png").toString();
    }

    private Path animated(String animation) throws IOException {
        Path file = CliRun.scene(folder, "\"width\": 16, \"height\": 12");
        String text = Files.readString(file);
        int end = text.lastIndexOf('}');
        return Files.writeString(file, text.substring(0, end) + ", \"animation\": " + animation + "}");
    }

    private Path frame(int number) {
        return frames.resolve(String.format("frame-%04d.png", number));
    }

    /** Names and contents. */
    private Map<String, List<Byte>> files() throws IOException {
        Map<String, List<Byte>> all = new TreeMap<>();
        try (Stream<Path> files = Files.list(frames)) {
            for (Path file : files.toList()) {
                byte[] bytes = Files.readAllBytes(file);
                Byte[] boxed = new Byte[bytes.length];
                java.util.Arrays.setAll(boxed, i -> bytes[i]);
                all.put(file.getFileName().toString(), List.of(boxed));
            }
        }
        return all;
    }

    @Test
    void eachFrameIsThePictureThatRenderMakesOfIt() throws IOException {
        assertEquals(new CliRun(0, "", ""), CliRun.of("animate", scene, "-o", pattern, "--antialias", 2));
        assertEquals(6, files().size());
        for (int n : new int[] {0, 3, 5}) {
            Path alone = folder.resolve("alone.png");
            assertEquals(
                    0,
                    CliRun.of("render", scene, "-o", alone, "--frame", n, "--antialias", 2)
                            .code());
            assertArrayEquals(
                    ImageFiles.read(alone).toArray(), ImageFiles.read(frame(n)).toArray(), "frame " + n);
        }
    }

    @Test
    void framesThatAreThereAreKeptAndTheRestIsTheSameAsInOneGo() throws IOException {
        CliRun.of("animate", scene, "-o", pattern, "--frames", "2-3");
        assertEquals(List.of("frame-0002.png", "frame-0003.png"), List.copyOf(files().keySet()));
        Object before = Files.getLastModifiedTime(frame(2));
        CliRun rest = CliRun.of("animate", scene, "-o", pattern, "--threads", 2);
        assertEquals(new CliRun(0, "", "enlightenment: 2 of 6 frames are there already\n"), rest);
        assertEquals(before, Files.getLastModifiedTime(frame(2)));
        Map<String, List<Byte>> inTwo = files();
        CliRun.of("animate", scene, "-o", folder.resolve("once/frame-%04d.png"));
        frames = folder.resolve("once");
        assertEquals(files(), inTwo);
    }

    @ParameterizedTest
    @CsvSource({"--antialias, 3", "--seed, 7", "--depth, 16", "--size, 8x6", "--shadow-samples, 3", "--samples, 2"})
    void framesOfOtherSettingsAreNeitherKeptNorTouched(String option, String value) throws IOException {
        CliRun.of("animate", scene, "-o", pattern, "--frames", "1-2");
        Map<String, List<Byte>> before = files();
        CliRun refused = CliRun.of("animate", scene, "-o", pattern, option, value);
        assertEquals(2, refused.code());
        assertTrue(
                refused.err().contains("frame-0001.png and 1 more files (of frames 1..2) are there already"),
                refused.err());
        assertEquals(before, files());
        assertEquals(
                0,
                CliRun.of("animate", scene, "-o", pattern, option, value, "--overwrite")
                        .code());
        assertEquals(6, files().size());
        assertNotEquals(before.get("frame-0001.png"), files().get("frame-0001.png"));
    }

    @Test
    void aFrameOfAnotherSceneOrProgramOrADamagedOneIsNotKept() throws IOException {
        CliRun.of("animate", scene, "-o", pattern);
        // Frame 0 is the same with this key; the others are not.
        animated(GROWING.replace("\"5\": 2", "\"5\": 2.5"));
        CliRun changed = CliRun.of("animate", scene, "-o", pattern);
        assertTrue(changed.err().contains("and 4 more files (of frames 1..5)"), changed.err());
        scene = animated(GROWING);
        byte[] damaged = Files.readAllBytes(frame(4));
        damaged[damaged.length / 2] ^= 1;
        Files.write(frame(4), damaged);
        CliRun run = CliRun.of("animate", scene, "-o", pattern);
        assertTrue(run.err().contains("frame-0004.png is there already, and was not made"), run.err());
        assertEquals(
                0, CliRun.of("animate", scene, "-o", pattern, "--overwrite").code());
        assertEquals(0, CliRun.of("animate", scene, "-o", pattern).code());
    }

    @Test
    void aStoppedFilmGoesOnWithTheSameBytes() throws Exception {
        animated(GROWING.replace("\"frames\": 6", "\"frames\": 100000"));
        ShutdownSignal stop = new ShutdownSignal();
        Thread asks = new Thread(() -> {
            while (!Files.exists(frame(2))) {
                Thread.onSpinWait();
            }
            stop.request();
        });
        asks.start();
        CliRun run = CliRun.of(stop, "animate", scene, "-o", pattern);
        asks.join();
        assertEquals(1, run.code());
        int done = files().size();
        assertTrue(done >= 3, done + " frames");
        assertTrue(
                run.err()
                        .contains("stopped: " + done + " of 100000 frames are in " + frames
                                + "; the same command goes on from there"),
                run.err());
        // The last one that was written is whole, and the first.
        CliRun kept = CliRun.of("animate", scene, "-o", pattern, "--frames", "0-" + (done - 1));
        assertEquals("enlightenment: " + done + " of " + done + " frames are there already\n", kept.err());
    }

    @Test
    void aFilmIsMadeOfTheFramesThatWereAskedFor() throws IOException {
        Path film = folder.resolve("film.apng");
        CliRun run = CliRun.of("animate", scene, "-o", pattern, "--frames", "1-4", "--video", film);
        assertEquals(new CliRun(0, "", ""), run);
        assertArrayEquals(
                ImageFiles.read(frame(1)).toArray(), ImageFiles.read(film).toArray());
    }

    @Test
    void whatIsWrongWithAFrameNamesItBeforeAnythingIsRendered() throws IOException {
        animated(GROWING.replace("\"5\": 2", "\"5\": -1"));
        CliRun run = CliRun.of("animate", scene, "-o", pattern);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("/objects/0/radius: must be a number greater than 0"), run.err());
        assertTrue(run.err().strip().endsWith("(in frame 3)"), run.err());
        assertFalse(Files.exists(frames));
        assertEquals(
                0, CliRun.of("animate", scene, "-o", pattern, "--frames", "0-2").code());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "frame.png",
                "frame-%04d.jpg",
                "frame-%d-%d.png",
                "frame-%4d.png",
                "frame-%s.png",
                "frame-%0d.png",
                "%04d",
                "frame-%00004d.png",
                "frame-%-4d.png",
                "frame-%1$d.png",
                "frame%%d.png",
                "100%-%d.png",
                "-"
            })
    void aPatternHasOneNumberAndNothingElseOfPrintf(String name) {
        CliRun run = CliRun.of("animate", scene, "-o", name);
        assertEquals(2, run.code());
        assertFalse(run.err().contains("internal"), run.err());
    }

    @Test
    void percentSignsOfFoldersAreWhatTheyAreAndThoseOfNamesAreDoubled() throws IOException {
        frames = folder.resolve("50% off %d");
        CliRun run = CliRun.of("animate", scene, "-o", frames.resolve("100%% $(x) %02d.png"), "--frames", "4");
        assertEquals(new CliRun(0, "", ""), run);
        assertEquals(List.of("100% $(x) 04.png"), List.copyOf(files().keySet()));
    }

    @ParameterizedTest
    @CsvSource({
        "0-6, there is no frame 6; the frames are 0..5",
        "3-1, must be FIRST-LAST",
        "-1, must be",
        "1-2-3, must be"
    })
    void rangesLieWithinTheFilm(String range, String message) {
        CliRun run = CliRun.of("animate", scene, "-o", pattern, "--frames=" + range);
        assertEquals(2, run.code());
        assertTrue(run.err().contains(message), run.err());
    }

    @Test
    void aSceneThatDoesNotMoveHasNoFilm() throws IOException {
        Path still = CliRun.scene(folder, "\"width\": 16, \"height\": 12");
        CliRun run = CliRun.of("animate", still, "-o", pattern);
        assertEquals(2, run.code());
        assertTrue(run.err().contains("has no \"animation\": 'render' makes its only picture"), run.err());
    }

    @Test
    void noFrameOrFilmIsWrittenOverWhatIsReadOrOverEachOther() throws IOException {
        Path texture = folder.resolve("t-0003.png");
        assertEquals(0, CliRun.of("render", scene, "-o", texture, "--frame", 0).code());
        String text = Files.readString(scene)
                .replace("\"materials\":", "\"textures\": { \"t\": { \"file\": \"t-0003.png\" } }, \"materials\":");
        Files.writeString(scene, text);
        byte[] before = Files.readAllBytes(texture);
        CliRun overTexture = CliRun.of("animate", scene, "-o", folder.resolve("t-%04d.png"), "--overwrite");
        assertTrue(overTexture.err().contains("-o would write over the image of texture \"t\""), overTexture.err());
        CliRun overFrame = CliRun.of("animate", scene, "-o", pattern, "--video", frame(3));
        assertTrue(overFrame.err().contains("--video and -o would write the same file"), overFrame.err());
        Files.createDirectories(frames);
        Files.createSymbolicLink(frame(2), scene);
        CliRun byLink = CliRun.of("animate", scene, "-o", pattern, "--overwrite");
        assertTrue(byLink.err().contains("-o would write over the scene"), byLink.err());
        assertEquals(List.of(2, 2, 2), List.of(overTexture.code(), overFrame.code(), byLink.code()));
        Files.delete(frame(2));
        Files.createSymbolicLink(frame(2), frame(4).getFileName());
        CliRun twice = CliRun.of("animate", scene, "-o", pattern, "--overwrite");
        assertEquals(2, twice.code());
        assertTrue(twice.err().contains("-o and -o would write the same file"), twice.err());
        assertFalse(Files.exists(frame(4)));
        assertArrayEquals(before, Files.readAllBytes(texture));
        assertEquals(text, Files.readString(scene));
    }

    @Test
    void aFilmThatCannotBeWrittenIsFoundOutBeforeFramesAreRendered() {
        for (String[] wrong : new String[][] {
            {"film.avi", ".apng, .png, .gif, .mp4, .webm, .mkv"},
            {"none/film.gif", "there is no folder"}
        }) {
            CliRun run = CliRun.of("animate", scene, "-o", pattern, "--video", folder.resolve(wrong[0]));
            assertNotEquals(0, run.code());
            assertTrue(run.err().contains(wrong[1]), run.err());
            assertFalse(Files.exists(frames));
        }
        CliRun none = CliRun.of(
                "animate", scene, "-o", pattern, "--video", folder.resolve("f.mp4"), "--ffmpeg", folder.resolve("no"));
        assertTrue(none.err().contains("is no program that can be run"), none.err());
    }

    @Test
    void anErrorThatIsNotKeptNamesItsFrameAndTheOthersAreRenderedAllTheSame() throws IOException {
        CliRun run = CliRun.of("animate", scene, "-o", pattern, "--error", 0.002, "--samples", 1, "--depth", 16);
        assertEquals(1, run.code());
        assertTrue(run.err().contains("enlightenment: frame 5: the error is about"), run.err());
        assertTrue(run.err().contains("enlightenment: 6 frames are not as asked"), run.err());
        assertEquals(6, files().size());
    }

    @Test
    void aFilmMayLieInTheFolderThatIsMadeForItsFrames() throws IOException {
        Path film = frames.resolve("film.apng");
        assertEquals(new CliRun(0, "", ""), CliRun.of("animate", scene, "-o", pattern, "--video", film));
        assertTrue(Files.size(film) > 0);
    }

    @Test
    void aReportMayLieInTheFolderThatIsMadeForTheFramesAndInNoOther() throws IOException {
        Path report = frames.resolve("r.json");
        assertEquals(new CliRun(0, "", ""), CliRun.of("animate", scene, "-o", pattern, "--report", report));
        assertTrue(Files.size(report) > 0);
        CliRun other = CliRun.of("animate", scene, "-o", pattern, "--report", folder.resolve("none/r.json"));
        assertEquals(1, other.code());
        assertTrue(other.err().contains("there is no folder"), other.err());
        CliRun frame = CliRun.of(
                "animate", scene, "-o", folder.resolve("new/%d.png"), "--report", folder.resolve("new/3.png"));
        assertEquals(2, frame.code());
        assertTrue(frame.err().contains("--report and -o would write the same file"), frame.err());
        CliRun both = CliRun.of(
                "animate",
                scene,
                "-o",
                folder.resolve("new/%d.png"),
                "--report",
                folder.resolve("new/a.gif"),
                "--video",
                folder.resolve("new/a.gif"));
        assertEquals(2, both.code());
        assertTrue(both.err().contains("--video and --report would write the same file"), both.err());
        assertFalse(Files.exists(folder.resolve("new")));
    }

    @Test
    void furtherFilesAreThoseThatRenderWritesAndAFrameWithoutThemIsNotThere() throws IOException {
        assertEquals(
                0, CliRun.of("animate", scene, "-o", pattern, "--frames", "0-2").code());
        CliRun more = CliRun.of("animate", scene, "-o", pattern, "--frames", "0-2", "--aov", "depth,object");
        assertEquals(new CliRun(0, "", ""), more);
        assertEquals(9, files().size());
        Path alone = folder.resolve("alone.png");
        CliRun.of("render", scene, "-o", alone, "--frame", 1, "--aov", "depth,object");
        assertArrayEquals(
                ImageFiles.read(folder.resolve("alone.depth.png")).toArray(),
                ImageFiles.read(frames.resolve("frame-0001.depth.png")).toArray());
        Map<String, List<Byte>> all = files();
        Files.delete(frames.resolve("frame-0001.depth.png"));
        CliRun again = CliRun.of("animate", scene, "-o", pattern, "--frames", "0-2", "--aov", "depth,object");
        assertEquals(new CliRun(0, "", "enlightenment: 2 of 3 frames are there already\n"), again);
        assertEquals(all, files());
    }

    @Test
    void furtherFilesThatWereMadeOtherwiseAreNotTouched() throws IOException {
        CliRun.of("animate", scene, "-o", pattern, "--frames", "0", "--aov", "depth", "--antialias", 2);
        Files.delete(frame(0));
        CliRun run = CliRun.of("animate", scene, "-o", pattern, "--frames", "0", "--aov", "depth");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("frame-0000.depth.png is there already, and was not made"), run.err());
        CliRun classic = CliRun.of("animate", scene, "-o", pattern, "--aov", "albedo");
        assertEquals(2, classic.code());
        assertTrue(classic.err().contains("--aov albedo is for physical shading"), classic.err());
    }

    @Test
    void theReportHasTheFilmAndEachFrameThatWasRendered() throws IOException {
        Path report = folder.resolve("film.json");
        CliRun.of("animate", scene, "-o", pattern, "--frames", "2-3");
        CliRun run = CliRun.of("animate", scene, "-o", pattern, "--report", report, "--stats");
        assertEquals(0, run.code(), run.err());
        String json = Files.readString(report);
        assertTrue(json.contains("\"framesAsked\": 6"), json);
        assertTrue(json.contains("\"framesKept\": 2"), json);
        assertTrue(json.contains("\"framesRendered\": 4"), json);
        assertTrue(json.contains("\"pixels\": " + 4 * 16 * 12), json);
        assertTrue(json.contains("\"frame\": 5"), json);
        assertFalse(json.contains("\"frame\": 3"), json);
        assertTrue(
                run.out().startsWith("frames                               4   2 of 6 were there already"), run.out());
        assertTrue(run.out().contains("  per frame"), run.out());
        CliRun over = CliRun.of("animate", scene, "-o", pattern, "--report", scene);
        assertTrue(over.err().contains("--report would write over the scene"), over.err());
    }
}
