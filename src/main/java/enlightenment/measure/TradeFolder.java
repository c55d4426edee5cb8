package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The folder of a trade: what it was made with, the runs so far, the parts of the reference. Whatever happens to the process,
 * the next one can go on from here.
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
     * Begins a folder or goes on with one.
     *
     * @throws InvalidValueException if the place is taken (key "output") or belongs to a trade of something else (key
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
            WholeFile.write(identity, String.join("\n", settings.identity()) + "\n");
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
     * Opens a folder to read what was measured. One that lost its settings, as those in the documentation did, must hold runs with
     * the same light points and threads.
     *
     * @throws InvalidValueException key "evaluate", if there is no trade in it or one of something else
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
        checkRuns(folder, stored.journal.runs(), settings.base());
        return stored;
    }

    private static void checkRuns(Path folder, List<TradeRun> runs, RenderSettings base) {
        boolean ran = false;
        for (TradeRun run : runs) {
            boolean ladder = run.kind().equals(TradeRun.LADDER);
            if (ladder && run.threads() != base.threads()) {
                throw new InvalidValueException(
                        "evaluate", folder + " holds runs with " + run.threads() + " threads, not " + base.threads());
            }
            ran |= ladder && run.shadowSamples() == base.shadowSamples();
        }
        if (!ran) {
            throw new InvalidValueException(
                    "evaluate", folder + " holds no runs with " + base.shadowSamples() + " light points");
        }
    }

    private static void checkIdentity(Path folder, TradeSettings settings, String key) throws IOException {
        List<String> then = Files.readAllLines(folder.resolve(IDENTITY));
        List<String> now = settings.identity();
        for (int i = 0; i < now.size(); i++) {
            String old = i < then.size() ? then.get(i) : "nothing";
            if (!old.equals(now.get(i))) {
                throw new InvalidValueException(
                        key,
                        folder + " holds a trade of something else: it was made with " + old + ", not " + now.get(i));
            }
        }
    }

    /** What is needed beside the runs to evaluate them once more. */
    record Kept(Reference reference, Circumstances circumstances) {}

    /** Keeps the figures of the reference and the circumstances. */
    void keep(Reference reference, Circumstances circumstances) throws IOException {
        WholeFile.write(file(KEPT), String.join("\n", KeptText.lines(reference, circumstances)) + "\n");
    }

    /** Reads what was kept, with the reference's picture if that is still there. */
    Kept kept() throws IOException {
        Optional<Image> picture = Optional.empty();
        for (String name : List.of("reference.png", "reference.pfm")) {
            if (Files.exists(file(name))) {
                picture = Optional.of(ImageFiles.read(file(name)));
            }
        }
        return KeptText.parse(file(KEPT), picture);
    }

    /** All files that a trade of these methods may write; those who write them name them the same way. */
    static List<String> names(List<String> methods) {
        List<String> names = new ArrayList<>(List.of(IDENTITY, RUNS, KEPT, "reference.pfm", "reference.png"));
        // Of a single method the reference has two parts.
        for (int part = 1; part <= Math.max(methods.size(), 2); part++) {
            names.addAll(List.of("reference-" + part + ".pfm", "reference-" + part + ".txt"));
        }
        for (String method : methods) {
            String picture = "equal-time-" + method;
            names.addAll(List.of(picture + ".png", picture + "-flip.png", picture + "-error.png"));
        }
        return names;
    }

    Path file(String name) {
        return folder.resolve(name);
    }

    TradeJournal journal() {
        return journal;
    }
}
