package enlightenment.cli.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.measure.trade.Sweep;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TradeCommandTest {
    private static final String SIZE = "\"width\": 24, \"height\": 16";

    /** More than this the trade of most tests is not given, in seconds, however busy the machine is. */
    private static final double MAX_BUDGET = 200;

    private static final String METHODS = "raytrace,cluster";

    @TempDir
    static Path common;

    /** The trade that most tests look at; they work on copies of its folder. */
    private static CliRun usual;

    @TempDir
    Path folder;

    private Path scene;
    private Path out;

    private static double budget = 1;

    /** Two methods and a sweep; on a busy machine it is resumed with more time until all that the tests look at is measured. */
    @BeforeAll
    static void runTheUsualTrade() throws IOException {
        Path first = CliRun.scene(common, SIZE);
        Path folder = common.resolve("out");
        usual = CliRun.of(usualArgs(first, folder));
        while (usual.code() == 0 && !isMeasured(folder) && budget < MAX_BUDGET) {
            budget *= 2;
            usual = CliRun.of(usualArgs(first, folder, "--resume"));
        }
        assertEquals(0, usual.code(), usual.err());
    }

    private static Object[] usualArgs(Path scene, Path folder, Object... more) {
        List<Object> args = new ArrayList<>(List.of("trade", scene, "-o", folder, "--budget", budget));
        args.addAll(List.of("--methods", METHODS));
        args.addAll(List.of("--seeds", 2, "--threads", 2, "--sweep", "antialias=1..2"));
        args.addAll(List.of(more));
        return args.toArray();
    }

    private static boolean isMeasured(Path folder) throws IOException {
        return Files.exists(folder.resolve("sweep-antialias.svg"))
                && lightSamplesTried(folder) > 2
                && commandLine().isPresent()
                && triedAdvice().find();
    }

    private static Optional<String> commandLine() {
        return usual.outLines().stream().filter(l -> l.startsWith("  ")).findFirst();
    }

    /** The first advice that was tried with this very picture: no other is a promise. Groups: the error, the options. */
    private static Matcher triedAdvice() {
        return Pattern.compile("(?m)^For an error of (\\S+) use (.*?): \\S+ s \\(tried\\)")
                .matcher(usual.out());
    }

    private static long lightSamplesTried(Path folder) throws IOException {
        return Files.readString(folder.resolve("trade.csv"))
                .lines()
                .map(l -> l.split(",")[3])
                .distinct()
                .count();
    }

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliRun.scene(folder, SIZE);
        out = folder.resolve("out");
    }

    private void copyTheUsualTrade() throws IOException {
        Files.createDirectory(out);
        try (Stream<Path> files = Files.list(common.resolve("out"))) {
            for (Path file : files.toList()) {
                Files.copy(file, out.resolve(file.getFileName()));
            }
        }
    }

    private CliRun trade(Object... more) {
        List<Object> args = new ArrayList<>(List.of("trade", scene, "-o", out));
        args.addAll(List.of(more));
        if (!args.contains("--methods")) {
            args.addAll(List.of("--methods", METHODS));
        }
        if (!args.contains("--threads")) {
            // As the usual one: what is usual otherwise depends on the machine.
            args.addAll(List.of("--threads", 2));
        }
        return CliRun.of(args.toArray());
    }

    private CliRun evaluate() {
        return CliRun.of(usualArgs(scene, out, "--evaluate"));
    }

    @Test
    void theAdviceFollowedToTheLetterGivesTheErrorThatCompareConfirms() throws IOException {
        copyTheUsualTrade();
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
        assertTrue(usual.outLines().get(0).startsWith("For this scene use "), usual.out());
        assertTrue(usual.outLines().get(1).startsWith("For an error of 0.0"), usual.out());
        assertTrue(usual.out().contains("\nThe reference is the mean of two independent renders: "), usual.out());
        String last = usual.outLines().get(usual.outLines().size() - 1);
        assertTrue(
                last.matches("At an error of 0\\.\\d+ --method auto comes to (raytrace|cluster|metropolis), .*\\."),
                last);
        String command = commandLine().orElseThrow().strip();
        assertTrue(command.startsWith("enlightenment render " + common.resolve("scene.json")), command);
        // The scene's folder is a temporary one, so the words hold no spaces; the picture goes there as well.
        Path picture = folder.resolve("scene.png");
        String whereto = "-o " + picture + " --progress none";
        String[] words = command.replace("enlightenment ", "")
                .replace("-o scene.png", whereto)
                .split(" ");
        assertEquals(0, CliRun.of((Object[]) words).code());
        Matcher advice = triedAdvice();
        assertTrue(advice.find(), usual.out());
        double target = Double.parseDouble(advice.group(1));
        String render = "render " + common.resolve("scene.json") + " " + whereto + " " + advice.group(2);
        assertEquals(0, CliRun.of((Object[]) render.split(" ")).code());
        String json = CliRun.of("compare", picture, out.resolve("reference.pfm"), "--json")
                .out();
        double rmse = Double.parseDouble(json.replaceFirst("(?s).*\"rmse\": ([^,]+),.*", "$1"));
        // Which advice is given depends on measured times; the error of another seed in a picture this small varies by
        // a quarter.
        assertTrue(rmse <= 1.5 * target, rmse + " where at most " + target + " was promised\n" + usual.out());
    }

    @Test
    void thePageNeedsNothingButItself() throws IOException {
        String page = Files.readString(common.resolve("out/index.html"));
        assertFalse(page.replaceAll("data:[^\"]*", "").matches("(?s).*(src|href)=\"[^\"].*"));
        assertFalse(page.contains("http://www.w3.org/1999"));
        assertTrue(page.contains("data:image/png;base64,") && page.contains("data:image/svg+xml;base64,"));
        assertTrue(page.contains("<h1>Two balls: speed against accuracy</h1>"));
    }

    /** Evaluated again from what was kept, every figure and sentence is the same, even without the pictures. */
    @Test
    void evaluatingAgainMeasuresNothingAndSaysTheSameWithoutWhatCanBeMissing() throws IOException {
        copyTheUsualTrade();
        for (String name :
                List.of("trade.json", "equal-time-cluster.png", "reference.pfm", "reference.png", "settings.txt")) {
            Files.delete(out.resolve(name));
        }
        CliRun first = evaluate();
        assertEquals(0, first.code(), first.err());
        assertEquals(usual.out().replace(common.toString(), folder.toString()), first.out());
        assertEquals(Files.readString(common.resolve("out/trade.json")), Files.readString(out.resolve("trade.json")));
        assertEquals(Files.readString(common.resolve("out/trade.csv")), Files.readString(out.resolve("trade.csv")));
    }

    /** With the pictures there the page is the same as well. */
    @Test
    @Tag("full")
    void evaluatingAgainMeasuresNothingAndSaysTheSame() throws IOException {
        copyTheUsualTrade();
        CliRun first = evaluate();
        assertEquals(0, first.code(), first.err());
        assertEquals(usual.out().replace(common.toString(), folder.toString()), first.out());
        assertEquals(Files.readString(common.resolve("out/trade.json")), Files.readString(out.resolve("trade.json")));
        assertEquals(Files.readString(common.resolve("out/trade.csv")), Files.readString(out.resolve("trade.csv")));
        // The pictures on the page are those of the files, which have eight bits.
        assertEquals(
                withoutPictures(common.resolve("out/index.html")).replace(common.toString(), folder.toString()),
                withoutPictures(out.resolve("index.html")));
        for (String name :
                List.of("trade.json", "equal-time-cluster.png", "reference.pfm", "reference.png", "settings.txt")) {
            Files.delete(out.resolve(name));
        }
        assertEquals(first, evaluate());
        assertEquals(Files.readString(common.resolve("out/trade.json")), Files.readString(out.resolve("trade.json")));
    }

    private static String withoutPictures(Path page) throws IOException {
        return Files.readString(page).replaceAll("data:image/png[^\"]*", "");
    }

    @Test
    void aFolderThatLostItsSettingsMustHoldRunsWithTheSameOnes() throws IOException {
        copyTheUsualTrade();
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
        copyTheUsualTrade();
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
        copyTheUsualTrade();
        List<String> sentences = usual.outLines().stream()
                .filter(l -> l.startsWith("For an error of"))
                .toList();
        assertEquals(3, sentences.size(), usual.out());
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
        assertTrue(Files.readString(out.resolve("measured.txt"))
                .matches("(?s).*reference.part=(raytrace,2|cluster,\\d+),.*"));
        // Whether there is time for other numbers of light samples depends on the machine: VariantsTest has their
        // choice.
        assertTrue(Files.readString(out.resolve("trade.csv")).contains("ladder,raytrace,"));
    }

    /** Lines of the summary: an error, and each method that was measured there; the fastest takes 1 times as long as itself. */
    @Test
    void theSummaryHasALineForEachMethodThatWasMeasuredAtAnError() throws IOException {
        List<String> lines = Files.readAllLines(common.resolve("out/summary.csv"));
        assertTrue(lines.get(0).startsWith("error,smallestReached,lightPoints,method,timesAsLong,"), lines.get(0));
        Map<String, List<String>> places = new LinkedHashMap<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            assertEquals(lines.get(0).split(",").length, cells.length, line);
            places.computeIfAbsent(cells[0] + cells[2], k -> new ArrayList<>()).add(line);
        }
        assertFalse(places.isEmpty());
        for (List<String> place : places.values()) {
            assertEquals(2, place.size(), place.toString());
            assertEquals(
                    1,
                    place.stream()
                            .mapToDouble(l -> Double.parseDouble(l.split(",")[4]))
                            .min()
                            .orElseThrow());
        }
    }

    @Test
    void resumedTradesKeepTheirRunsAndTheirReference() throws IOException {
        copyTheUsualTrade();
        List<String> before = Files.readAllLines(out.resolve("trade.csv"));
        byte[] reference = Files.readAllBytes(out.resolve("reference.pfm"));
        // The first values of a new sweep are rendered even where time for nothing else is left.
        Object[] more = {"--budget", 0.5, "--seeds", 3, "--threads", 2, "--sweep", "shadowSamples=1..2", "--resume"};
        assertEquals(0, trade(more).code());
        List<String> after = Files.readAllLines(out.resolve("trade.csv"));
        assertEquals(before, after.subList(0, before.size()));
        assertTrue(after.size() > before.size());
        assertTrue(java.util.Arrays.equals(reference, Files.readAllBytes(out.resolve("reference.pfm"))));
    }

    /** All files of the folder are among those that are kept apart from the inputs. */
    private void assertNothingIsWrittenButWhatWasAnnounced(List<Sweep> sweeps) throws IOException {
        RenderSettings base = RenderSettings.of(SceneReader.read(scene));
        List<String> announced = TradeOutput.names(new TradeSettings(
                Shading.Model.CLASSIC, base, List.of("raytrace", "cluster"), 3, 2, sweeps, Optional.empty(), ""));
        try (Stream<Path> files = Files.list(out)) {
            for (Path file : files.toList()) {
                assertTrue(announced.contains(file.getFileName().toString()), file.toString());
            }
        }
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
        copyTheUsualTrade();
        CliRun again = trade("--budget", "1");
        assertEquals(2, again.code());
        assertTrue(again.err().contains("holds a trade already"), again.err());
        CliRun otherSize = trade("--budget", "1", "--resume", "--size", "16x16");
        assertEquals(2, otherSize.code());
        assertTrue(otherSize.err().contains("size=24x16, not size=16x16"), otherSize.err());
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
    void whoStopsItAtOnceIsToldHowToGoOn() {
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        CliRun run = CliRun.of(stop, "trade", scene, "-o", out, "--progress", "none");
        assertEquals(1, run.code());
        assertTrue(run.err().contains("--resume goes on"), run.err());
    }
}
