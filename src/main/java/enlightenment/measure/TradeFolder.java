package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.EqualTimeComparison;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The folder of a measurement: its settings, the runs so far, the parts of the reference. A later process can resume from it after any
 * interruption.
 */
final class TradeFolder {
    private static final String IDENTITY = "settings.txt";
    private static final String RUNS = "trade.csv";
    private static final String KEPT = "measured.txt";

    private final Path folder;
    private final TradeJournal journal;

    private TradeFolder(Path folder, TradeJournal journal) {
        this.folder = folder;
        this.journal = journal;
    }

    /**
     * Begins a measurement in a folder, or resumes the one it holds.
     *
     * @throws InvalidValueException if the folder holds something else (key "output") or a measurement with other settings (key
     *     "resume")
     */
    static TradeFolder open(Path folder, TradeSettings settings, boolean resume) throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new InvalidValueException("output", folder + " is a file; a folder is needed");
        }
        Files.createDirectories(folder);
        Path identity = folder.resolve(IDENTITY);
        Path runs = folder.resolve(RUNS);
        if (!Files.exists(identity) || !Files.exists(runs)) {
            TradeJournal journal = TradeJournal.create(runs);
            WholeFile.write(identity, String.join("\n", identity(settings)) + "\n");
            return new TradeFolder(folder, journal);
        }
        if (!resume) {
            throw new InvalidValueException(
                    "output", folder + " holds a trade already: --resume goes on with it, or name another folder");
        }
        checkIdentity(folder, settings, "resume");
        return new TradeFolder(folder, TradeJournal.open(runs));
    }

    /**
     * Opens a folder to read what was measured. One without its settings must hold runs with the same light samples and threads.
     *
     * @throws InvalidValueException key "evaluate", if it holds no measurement, or one with other settings
     */
    static TradeFolder stored(Path folder, TradeSettings settings) throws IOException {
        for (String name : List.of(RUNS, KEPT)) {
            if (!Files.exists(folder.resolve(name))) {
                throw new InvalidValueException("evaluate", folder + " holds no finished trade: there is no " + name);
            }
        }
        if (Files.exists(folder.resolve(IDENTITY))) {
            checkIdentity(folder, settings, "evaluate");
        }
        TradeFolder stored = new TradeFolder(folder, TradeJournal.open(folder.resolve(RUNS)));
        checkRuns(folder, stored.journal.runs(), settings);
        return stored;
    }

    private static void checkRuns(Path folder, List<TradeRun> runs, TradeSettings settings) {
        RenderSettings base = settings.base();
        int lightSamples = Configuration.ofScene(settings, base.method().word()).lightSamples();
        boolean ran = false;
        for (TradeRun run : runs) {
            boolean series = run.kind().equals(TradeRun.BUDGET_SERIES);
            if (series && run.threads() != base.threads()) {
                throw new InvalidValueException(
                        "evaluate", folder + " holds runs with " + run.threads() + " threads, not " + base.threads());
            }
            ran |= series && run.shadowSamples() == lightSamples;
        }
        if (!ran) {
            throw new InvalidValueException(
                    "evaluate", folder + " holds no runs with " + lightSamples + " light samples");
        }
    }

    private static void checkIdentity(Path folder, TradeSettings settings, String key) throws IOException {
        List<String> then = Files.readAllLines(folder.resolve(IDENTITY));
        List<String> now = identity(settings);
        for (int i = 0; i < now.size(); i++) {
            String old = i < then.size() ? then.get(i) : "nothing";
            if (!old.equals(now.get(i))) {
                throw new InvalidValueException(
                        key,
                        folder + " holds a trade of something else: it was made with " + old + ", not " + now.get(i));
            }
        }
    }

    /** Writes the figures of the reference and the conditions. */
    void keep(Reference reference, TradeResult.Conditions conditions) throws IOException {
        WholeFile.write(file(KEPT), String.join("\n", MeasurementFile.lines(reference, conditions)) + "\n");
    }

    /** Reads the figures of the reference and the conditions, with the reference's picture if that exists. */
    MeasurementFile.Content kept(Scene scene) throws IOException {
        Optional<Image> picture = Optional.empty();
        for (String name : List.of("reference.png", "reference.pfm")) {
            if (Files.exists(file(name))) {
                picture = Optional.of(StoredPicture.read(scene, file(name)));
            }
        }
        return MeasurementFile.parse(file(KEPT), picture);
    }

    /** The names of all files that a measurement of these methods may write. */
    static List<String> names(List<String> methods) {
        List<String> names = new ArrayList<>(List.of(IDENTITY, RUNS, KEPT, "reference.pfm", "reference.png"));
        for (int part = 1; part <= ReferenceMaker.PARTS; part++) {
            names.addAll(List.of("reference-" + part + ".pfm", "reference-" + part + ".txt"));
        }
        for (String method : methods) {
            names.addAll(List.of(
                    EqualTimeComparison.pictureName(method),
                    EqualTimeComparison.flipName(method),
                    EqualTimeComparison.differenceName(method)));
        }
        return names;
    }

    /** The settings that must be equal to resume a measurement, one {@code key=value} per line. */
    private static List<String> identity(TradeSettings settings) {
        RenderSettings base = settings.base();
        RenderSettings.Crop c = base.region();
        List<String> lines = new ArrayList<>(List.of(
                "format=3",
                "scene=" + settings.sceneKey(),
                "methods=" + String.join(",", settings.methods()),
                "size=" + base.width() + "x" + base.height(),
                "crop=" + c.x() + "," + c.y() + "," + c.width() + "," + c.height(),
                "antialias=" + base.antialias()));
        List<Method> methods = new ArrayList<>(BuiltInMethod.ALL);
        settings.methods().forEach(word -> methods.add(Method.named(word)));
        Method.settings(methods)
                .forEach(s -> lines.add(s.key() + "=" + base.chosen().value(s)));
        lines.addAll(List.of(
                "threads=" + base.threads(),
                "reference="
                        + settings.reference()
                                .map(r -> "given, " + Arrays.hashCode(r.toArray()))
                                .orElse("auto")));
        return lines;
    }

    Path file(String name) {
        return folder.resolve(name);
    }

    TradeJournal journal() {
        return journal;
    }
}
