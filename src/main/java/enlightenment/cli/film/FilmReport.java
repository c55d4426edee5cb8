package enlightenment.cli.film;

import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.machine.MachineFacts;
import enlightenment.net.RenderServer;
import enlightenment.numeric.Counts;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import picocli.CommandLine.Option;

/** Time and statistics of a film's frames, for each and for all together. */
final class FilmReport {
    private static final double NANO = 1e-9;

    @Option(
            names = "--report",
            paramLabel = "FILE",
            description = "write the statistics of the film and of each frame that was rendered to this JSON file")
    private Path file;

    @Option(names = "--stats", description = "print the film's statistics")
    private boolean stats;

    /** By frame, the report of its last render. */
    private final Map<Integer, RenderReport> frames = new TreeMap<>();

    private int kept;
    private int asked;
    private long begun;
    private long cpu;

    FilmReport() {}

    /** Which file will be written; null for none. */
    Path file() {
        return file;
    }

    /**
     * Rendering begins.
     *
     * @param all how many frames are wanted
     * @param there how many of them are there already
     */
    void begin(int all, int there) {
        asked = all;
        kept = there;
        begun = System.nanoTime();
        cpu = MachineFacts.processorNanos();
    }

    /** A frame is written. */
    void add(int frame, RenderResult result) {
        if (file != null || stats) {
            frames.put(frame, result.report());
        }
    }

    /** Writes and prints what was asked for, when all frames are there or the film was stopped. */
    void write(Optional<RenderServer.AuditReport> audits, Terminal terminal) throws IOException {
        double seconds = (System.nanoTime() - begun) * NANO;
        double processors = (MachineFacts.processorNanos() - cpu) * NANO;
        if (file != null) {
            WholeFile.write(file, FilmReportJson.of(asked, kept, frames, audits, seconds, processors));
        }
        if (stats) {
            terminal.out().print(table(seconds, processors));
        }
    }

    static long rays(Map<Integer, RenderReport> frames) {
        return Counts.sum(frames.values().stream().mapToLong(RenderReport::rays));
    }

    static long pixels(Map<Integer, RenderReport> frames) {
        return frames.values().stream().mapToLong(RenderReport::pixels).sum();
    }

    private String table(double seconds, double processors) {
        StringBuilder text = new StringBuilder();
        line(text, "frames", "%,18d   %,d of %,d were there already", frames.size(), kept, asked);
        line(text, "rays in all", "%,18d", rays(frames));
        line(text, "pixels", "%,18d", pixels(frames));
        if (!frames.isEmpty()) {
            ToDoubleFunction<RenderReport> error = r -> r.sampling().estimatedError();
            int worst = worst(error);
            line(
                    text,
                    "samples per pixel",
                    "%,18.2f   in the mean",
                    frames.values().stream()
                            .mapToDouble(r -> r.sampling().samplesPerPixel())
                            .average()
                            .orElseThrow());
            line(
                    text,
                    "estimated error",
                    "%18.5f   the largest, of frame %d",
                    error.applyAsDouble(frames.get(worst)),
                    worst);
        }
        line(text, "time", "%,18.3f s   %,.3f s of processors here", seconds, processors);
        if (!frames.isEmpty()) {
            line(
                    text,
                    "  per frame",
                    "%,18.3f s   %,.3f s of processors here",
                    seconds / frames.size(),
                    processors / frames.size());
        }
        return text.toString();
    }

    private int worst(ToDoubleFunction<RenderReport> error) {
        int worst = frames.keySet().iterator().next();
        for (Map.Entry<Integer, RenderReport> e : frames.entrySet()) {
            if (error.applyAsDouble(e.getValue()) > error.applyAsDouble(frames.get(worst))) {
                worst = e.getKey();
            }
        }
        return worst;
    }

    private static void line(StringBuilder text, String label, String format, Object... values) {
        text.append(String.format(Locale.ROOT, "%-20s", label));
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}
