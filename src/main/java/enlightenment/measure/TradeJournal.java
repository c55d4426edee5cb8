package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.measure.trade.TradeRun;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/** The file of a measurement's runs as comma-separated values, one line each, written when the run has ended. */
final class TradeJournal {
    private static final String HEADER =
            "kind,method,antialias,shadowSamples,threads,samples,seed,wallSeconds,cpuSeconds,"
                    + "samplesPerPixel,meanSquaredDifference,flip,estimatedError,estimatedLow,estimatedHigh,error";
    private static final int COLUMNS = 16;

    private final Path file;
    private final List<TradeRun> runs = new ArrayList<>();

    private TradeJournal(Path file) {
        this.file = file;
    }

    /** Creates the file. */
    static TradeJournal create(Path file) throws IOException {
        WholeFile.write(file, HEADER + "\n");
        return new TradeJournal(file);
    }

    /** Opens a file to append to. An incomplete last line, left by an interruption, is removed from the file. */
    static TradeJournal open(Path file) throws IOException {
        TradeJournal journal = new TradeJournal(file);
        String text = Files.readString(file);
        String whole = text.substring(0, text.lastIndexOf('\n') + 1);
        List<String> lines = whole.lines().toList();
        if (lines.isEmpty() || !lines.get(0).equals(HEADER)) {
            throw new IOException(file + ": is not a file of the command trade: its first line is unknown");
        }
        for (int i = 1; i < lines.size(); i++) {
            journal.runs.add(parse(lines.get(i), file + ":" + (i + 1)));
        }
        if (whole.length() < text.length()) {
            WholeFile.write(file, whole);
        }
        return journal;
    }

    List<TradeRun> runs() {
        return List.copyOf(runs);
    }

    void add(TradeRun run, double referenceVariance) throws IOException {
        Files.write(
                file,
                (line(run, referenceVariance) + "\n").getBytes(StandardCharsets.UTF_8),
                StandardOpenOption.APPEND,
                StandardOpenOption.WRITE);
        runs.add(run);
    }

    private static String line(TradeRun r, double referenceVariance) {
        return String.join(
                ",",
                r.kind(),
                r.method(),
                Integer.toString(r.antialias()),
                Integer.toString(r.shadowSamples()),
                Integer.toString(r.threads()),
                Double.toString(r.samples()),
                Long.toString(r.seed()),
                Double.toString(r.wallSeconds()),
                Double.toString(r.cpuSeconds()),
                Double.toString(r.samplesPerPixel()),
                Double.toString(r.meanSquaredDifference()),
                Double.toString(r.flip()),
                Double.toString(r.estimatedError()),
                Double.toString(r.estimatedLow()),
                Double.toString(r.estimatedHigh()),
                Double.toString(r.error(referenceVariance)));
    }

    private static TradeRun parse(String line, String place) throws IOException {
        String[] f = line.split(",", -1);
        try {
            if (f.length == COLUMNS) {
                return new TradeRun(
                        f[0],
                        f[1],
                        Integer.parseInt(f[2]),
                        Integer.parseInt(f[3]),
                        Integer.parseInt(f[4]),
                        Double.parseDouble(f[5]),
                        Long.parseLong(f[6]),
                        Double.parseDouble(f[7]),
                        Double.parseDouble(f[8]),
                        Double.parseDouble(f[9]),
                        Double.parseDouble(f[10]),
                        Double.parseDouble(f[11]),
                        Double.parseDouble(f[12]),
                        Double.parseDouble(f[13]),
                        Double.parseDouble(f[14]));
            }
        } catch (NumberFormatException e) {
            // Reported below, as a wrong number of columns is.
        }
        throw new IOException(place + ": is not a line that the command trade wrote: \"" + line + "\"");
    }
}
