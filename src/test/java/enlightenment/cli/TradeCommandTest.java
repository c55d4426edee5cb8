package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.Sweep;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TradeCommandTest {
    private static final String SIZE = "\"width\": 48, \"height\": 32";

    @TempDir
    Path folder;

    private Path scene;
    private Path out;

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliRun.scene(folder, SIZE);
        out = folder.resolve("out");
    }

    private CliRun trade(Object... more) {
        List<Object> args = new ArrayList<>(List.of("trade", scene, "-o", out));
        args.addAll(List.of(more));
        if (!args.contains("--progress")) {
            args.addAll(List.of("--progress", "none"));
        }
        return CliRun.of(args.toArray());
    }

    @Test
    void theAdviceFollowedToTheLetterGivesTheErrorThatCompareConfirms() throws IOException {
        CliRun run = trade("--budget", "4", "--sweep", "antialias=1..2", "--threads", "2");
        assertEquals(0, run.code(), run.err());
        for (String name : List.of(
                "index.html",
                "trade.csv",
                "trade.json",
                "summary.csv",
                "measured.txt",
                "error-over-time.png",
                "error-over-time.svg",
                "error-over-samples.png",
                "error-over-samples.svg",
                "reference.pfm",
                "reference.png",
                "equal-time-raytrace.png",
                "equal-time-cluster-error.png",
                "sweep-antialias.svg")) {
            assertTrue(Files.size(out.resolve(name)) > 0, name);
        }
        assertNothingIsWrittenButWhatWasAnnounced(List.of(Sweep.parse("antialias=1..2")));
        assertTrue(run.outLines().get(0).startsWith("For an error of 0.0"), run.out());
        String command = run.outLines().get(1).strip();
        assertTrue(command.startsWith("java -jar target/enlightenment.jar render " + scene), command);
        // The scene's folder is a temporary one, so the words hold no spaces; the picture goes there as well.
        Path picture = folder.resolve("scene.png");
        String[] words = command.replace("java -jar target/enlightenment.jar ", "")
                .replace("-o scene.png", "-o " + picture + " --progress none")
                .split(" ");
        assertEquals(0, CliRun.of((Object[]) words).code());
        double target = Double.parseDouble(run.outLines().get(0).replaceFirst("For an error of (\\S+) .*", "$1"));
        String json = CliRun.of("compare", picture, out.resolve("reference.pfm"), "--json")
                .out();
        double rmse = Double.parseDouble(json.replaceFirst("(?s).*\"rmse\": ([^,]+),.*", "$1"));
        assertTrue(rmse <= 1.15 * target, rmse + " where at most " + target + " was promised\n" + run.out());
    }

    @Test
    void thePageNeedsNothingButItself() throws IOException {
        assertEquals(0, trade("--budget", "1", "--seeds", "1").code());
        String page = Files.readString(out.resolve("index.html"));
        assertFalse(page.replaceAll("data:[^\"]*", "").matches("(?s).*(src|href)=\"[^\"].*"));
        assertFalse(page.contains("http://www.w3.org/1999"));
        assertTrue(page.contains("data:image/png;base64,") && page.contains("data:image/svg+xml;base64,"));
        assertTrue(page.contains("<h1>Two balls: speed against accuracy</h1>"));
    }

    /** Evaluated again from what was kept, every figure and sentence is the same; without the pictures as well. */
    @Test
    void evaluatingAgainMeasuresNothingAndSaysTheSame() throws IOException {
        CliRun first = trade("--budget", "1", "--seeds", "1", "--threads", "2");
        assertEquals(0, first.code(), first.err());
        String json = Files.readString(out.resolve("trade.json"));
        String page = Files.readString(out.resolve("index.html"));
        String runs = Files.readString(out.resolve("trade.csv"));
        Files.delete(out.resolve("trade.json"));
        CliRun again = trade("--budget", "1", "--seeds", "1", "--threads", "2", "--evaluate");
        assertEquals(0, again.code(), again.err());
        assertEquals(first.out(), again.out());
        assertEquals(json, Files.readString(out.resolve("trade.json")));
        assertEquals(runs, Files.readString(out.resolve("trade.csv")));
        // The pictures on the page are those of the files, which have eight bits.
        String pictures = "data:image/png[^\"]*";
        assertEquals(
                page.replaceAll(pictures, ""),
                Files.readString(out.resolve("index.html")).replaceAll(pictures, ""));
        for (String name : List.of("equal-time-cluster.png", "reference.pfm", "reference.png", "settings.txt")) {
            Files.delete(out.resolve(name));
        }
        assertEquals(
                first.out(),
                trade("--budget", "1", "--seeds", "1", "--threads", "2", "--evaluate")
                        .out());
    }

    @Test
    void aFolderThatLostItsSettingsMustHoldRunsWithTheSameOnes() throws IOException {
        assertEquals(0, trade("--budget", "1", "--seeds", "1", "--threads", "2").code());
        Files.delete(out.resolve("settings.txt"));
        CliRun threads = trade("--evaluate", "--threads", "3");
        assertEquals(2, threads.code());
        assertTrue(threads.err().contains("holds runs with 2 threads, not 3"), threads.err());
        CliRun points = trade("--evaluate", "--threads", "2", "--shadow-samples", "77");
        assertEquals(2, points.code());
        assertTrue(points.err().contains("holds no runs with 77 light samples"), points.err());
    }

    @Test
    void onlyAFolderWithATradeOfThisSceneIsEvaluated() throws IOException {
        CliRun none = trade("--evaluate");
        assertEquals(2, none.code());
        assertTrue(none.err().contains("--evaluate: " + out + " holds no finished trade"), none.err());
        assertFalse(Files.exists(out));
        assertEquals(0, trade("--budget", "1", "--seeds", "1").code());
        CliRun other = trade("--evaluate", "--size", "16x16");
        assertEquals(2, other.code());
        assertTrue(other.err().contains("--evaluate: " + out + " holds a trade of something else"), other.err());
        Files.writeString(out.resolve("measured.txt"), "reference.variance=little\n");
        CliRun damaged = trade("--evaluate");
        assertEquals(1, damaged.code());
        assertTrue(damaged.err().contains("is not what the command trade wrote"), damaged.err());
    }

    /** Every sentence that names a ratio names what was measured; what is extrapolated is called so. */
    @Test
    void everySentenceSaysWhereItsFiguresComeFrom() throws IOException {
        CliRun run = trade("--budget", "2", "--seeds", "1");
        assertEquals(0, run.code(), run.err());
        List<String> sentences = run.outLines().stream()
                .filter(l -> l.startsWith("For an error of"))
                .toList();
        assertEquals(3, sentences.size(), run.out());
        for (String sentence : sentences) {
            assertTrue(
                    sentence.matches(".* s \\((tried|measured|interpolated between measured|extrapolated from).*")
                            || sentence.contains("there is no verdict: "),
                    sentence);
            assertEquals(sentence.contains("extrapolated"), sentence.contains("there is no comparison"), sentence);
        }
        String page = Files.readString(out.resolve("index.html"));
        String json = Files.readString(out.resolve("trade.json"));
        for (String sentence : sentences) {
            assertTrue(json.contains("\"sentence\": \"" + sentence + "\""), json);
            assertTrue(page.contains(sentence.replace("'", "&#39;")) || page.contains(sentence), sentence);
        }
        assertTrue(Files.readString(out.resolve("measured.txt")).contains("reference.part=raytrace,2,"));
        // raytrace was measured with other numbers of light samples than the scene's, too.
        String runs = Files.readString(out.resolve("trade.csv"));
        assertTrue(runs.contains("ladder,raytrace,")
                && runs.lines().map(l -> l.split(",")[3]).distinct().count() > 2);
    }

    @Test
    void resumedTradesKeepTheirRunsAndTheirReference() throws IOException {
        assertEquals(0, trade("--budget", "1", "--seeds", "1").code());
        List<String> before = Files.readAllLines(out.resolve("trade.csv"));
        byte[] reference = Files.readAllBytes(out.resolve("reference.pfm"));
        assertEquals(0, trade("--budget", "2", "--seeds", "2", "--resume").code());
        List<String> after = Files.readAllLines(out.resolve("trade.csv"));
        assertEquals(before, after.subList(0, before.size()));
        assertTrue(after.size() > before.size());
        assertTrue(java.util.Arrays.equals(reference, Files.readAllBytes(out.resolve("reference.pfm"))));
    }

    /** All files of the folder are among those that are kept apart from the inputs. */
    private void assertNothingIsWrittenButWhatWasAnnounced(List<Sweep> sweeps) throws IOException {
        RenderSettings base = RenderSettings.of(SceneReader.read(scene));
        List<String> announced = TradeOutput.names(
                new TradeSettings(base, List.of("raytrace", "cluster"), 4, 3, sweeps, Optional.empty(), ""));
        try (Stream<Path> files = Files.list(out)) {
            for (Path file : files.toList()) {
                assertTrue(announced.contains(file.getFileName().toString()), file.toString());
            }
        }
    }

    @Test
    void aTradeDoesNotGoOnWithAnotherPictureInATexture() throws IOException {
        Path texture = folder.resolve("floor.png");
        Files.copy(Path.of("textures/fire.png"), texture);
        Files.writeString(
                scene,
                Files.readString(scene)
                        .replaceFirst(
                                "\"materials\"", "\"textures\": { \"t\": { \"file\": \"floor.png\" } }, \"materials\"")
                        .replaceFirst("\"color\": \\[[^\\]]*\\]", "\"color\": { \"texture\": \"t\" }"));
        CliRun first = trade("--budget", "1", "--seeds", "1");
        assertEquals(0, first.code(), first.err());
        assertEquals(0, trade("--budget", "1", "--seeds", "1", "--resume").code());
        Files.copy(Path.of("textures/ice.png"), texture, StandardCopyOption.REPLACE_EXISTING);
        CliRun other = trade("--budget", "1", "--resume");
        assertEquals(2, other.code());
        assertTrue(other.err().contains("holds a trade of something else: it was made with scene="), other.err());
    }

    @Test
    void theHelpDoesNotOfferWhatWouldBeRefused() {
        String help = CliRun.of("trade", "--help").out();
        assertTrue(help.contains("--shadow-samples") && help.contains("--methods"), help);
        for (String refused : List.of("--samples", "--error", "--time", "--method=")) {
            assertFalse(help.contains(" " + refused), help);
            assertFalse(help.contains("[" + refused), help);
        }
    }

    @Test
    void aFolderOfAnotherTradeIsLeftAlone() throws IOException {
        assertEquals(0, trade("--budget", "1", "--seeds", "1").code());
        CliRun again = trade("--budget", "1");
        assertEquals(2, again.code());
        assertTrue(again.err().contains("holds a trade already"), again.err());
        CliRun otherSize = trade("--budget", "1", "--resume", "--size", "16x16");
        assertEquals(2, otherSize.code());
        assertTrue(otherSize.err().contains("size=48x32, not size=16x16"), otherSize.err());
        Files.writeString(scene, Files.readString(scene).replace("\"radius\": 1,", "\"radius\": 0.9,"));
        CliRun otherScene = trade("--budget", "1", "--resume");
        assertEquals(2, otherScene.code());
        assertTrue(
                otherScene.err().contains("holds a trade of something else: it was made with scene="),
                otherScene.err());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--methods nonsense | --methods must be some of raytrace,cluster",
                "--methods raytrace,raytrace | --methods must name each method once",
                "--methods '' | --methods must be some of",
                "--budget 0 | --budget must be a number in 0.1..10000000, not \"0\"",
                "--budget soon | --budget must be a number",
                "--seeds 0 | --seeds must be a whole number in 1..1000",
                "--evaluate --resume | --evaluate measures nothing",
                "--sweep antialias=3 | --sweep must be NAME=FROM..TO",
                "--sweep antialias=1..1000 | --sweep antialias must lie in",
                "--samples 4 | --samples must not be given here",
                "--method cluster | --method must not be given here",
                "--reference missing.pfm | --reference: cannot read missing.pfm: there is no such file",
                "--progress loud | --progress must be one of"
            })
    void wrongOptionsGetOneMessageAndNoFolder(String options, String message) {
        CliRun run = trade((Object[]) options.replace("''", "").split(" ", -1));
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().startsWith("enlightenment: " + message), run.err());
        assertFalse(Files.exists(out));
    }

    @Test
    void aMissingSceneAndAFolderThatIsAFileAreRefused() throws IOException {
        CliRun missing = CliRun.of("trade", folder.resolve("none.json"), "-o", out);
        assertEquals(2, missing.code());
        assertTrue(missing.err().contains("none.json"), missing.err());
        Files.writeString(out, "kept");
        CliRun file = trade("--budget", "1");
        assertEquals(2, file.code());
        assertTrue(file.err().contains("is a file; a folder is needed"), file.err());
        assertEquals("kept", Files.readString(out));
    }

    @Test
    void aReferenceOfAnotherSizeIsRefused() throws IOException {
        Path small = folder.resolve("small.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", small, "--size", "8x8", "--progress", "none")
                        .code());
        CliRun run = trade("--reference", small, "--budget", "1");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--reference must have 48x32 pixels, as the renders, not 8x8"), run.err());
    }

    @Test
    void aGivenReferenceIsJudgedAsWell() throws IOException {
        Path rough = folder.resolve("rough.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", rough, "--samples", "4", "--seed", "99", "--progress", "none")
                        .code());
        assertEquals(
                0, trade("--reference", rough, "--budget", "1", "--seeds", "1").code());
        String json = Files.readString(out.resolve("trade.json"));
        double stated =
                Double.parseDouble(json.replaceFirst("(?s).*\"reference\": \\{\\s*\"error\": ([^,]+),.*", "$1"));
        Path good = folder.resolve("good.pfm");
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", good, "--samples", "1024", "--progress", "none")
                        .code());
        String compared = CliRun.of("compare", rough, good, "--json").out();
        double true_ = Double.parseDouble(compared.replaceFirst("(?s).*\"rmse\": ([^,]+),.*", "$1"));
        assertEquals(true_, stated, 0.15 * true_);
    }

    @Test
    void whoStopsItAtOnceIsToldHowToGoOn() {
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        CliRun run = CliRun.of(stop, "trade", scene, "-o", out, "--progress", "none");
        assertEquals(1, run.code());
        assertTrue(run.err().contains("--resume goes on"), run.err());
    }
}
