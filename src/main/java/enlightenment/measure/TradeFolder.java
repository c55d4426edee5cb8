package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.math.Check.InvalidValueException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The folder of a trade: what it was made with, the runs so far, the parts of the reference. Whatever happens to the process,
 * the next one can go on from here.
 */
final class TradeFolder {
    private static final String IDENTITY = "settings.txt";
    private static final String RUNS = "trade.csv";

    private final Path folder;
    private final Journal journal;
    private final boolean resumed;

    private TradeFolder(Path folder, Journal journal, boolean resumed) {
        this.folder = folder;
        this.journal = journal;
        this.resumed = resumed;
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
            Journal journal = Journal.create(runs);
            WholeFile.write(identity, String.join("\n", settings.identity()) + "\n");
            return new TradeFolder(folder, journal, false);
        }
        if (!resume) {
            throw new InvalidValueException(
                    "output", folder + " holds a trade already: --resume goes on with it, or name another folder");
        }
        List<String> then = Files.readAllLines(identity);
        List<String> now = settings.identity();
        for (int i = 0; i < now.size(); i++) {
            String old = i < then.size() ? then.get(i) : "nothing";
            if (!old.equals(now.get(i))) {
                throw new InvalidValueException(
                        "resume",
                        folder + " holds a trade of something else: it was made with " + old + ", not " + now.get(i));
            }
        }
        return new TradeFolder(folder, Journal.open(runs), true);
    }

    /** All files that a trade of these methods may write; those who write them name them the same way. */
    static List<String> names(List<String> methods) {
        List<String> names = new ArrayList<>(List.of(IDENTITY, RUNS, "reference.pfm", "reference.png"));
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

    Journal journal() {
        return journal;
    }

    /** Whether this goes on with what was there. */
    boolean isResumed() {
        return resumed;
    }
}
