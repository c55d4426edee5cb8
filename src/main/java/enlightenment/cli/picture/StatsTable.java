package enlightenment.cli.picture;

import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;

/** A render's report as a table to read. */
final class StatsTable {
    private static final double MEBI = 1 << 20;

    /** With fewer samples per pixel there are no quarters, which show how the error falls. */
    private static final int FEW = 4;

    private final StringBuilder text = new StringBuilder();

    private StatsTable() {}

    /** Lines of a label, a value and its unit; every line ends with a line feed. */
    static String of(RenderReport report) {
        StatsTable table = new StatsTable();
        table.counts("rays", report.raysByKind());
        table.row("rays in all", report.rays());
        table.row("light samples", report.lightSamples());
        table.row("  without a ray", report.lightSamplesWithoutRay());
        table.sampling(report);
        table.primitives(report.testsByPrimitive(), report.hitsByPrimitive());
        table.row("texture look-ups", report.textureLookups());
        table.row("pixels", report.pixels());
        for (RenderReport.Phase phase : report.phases()) {
            table.line(
                    "time: " + phase.name(),
                    "%,18.3f s   %,.3f s of processors",
                    phase.wallSeconds(),
                    phase.cpuSeconds());
        }
        table.line("rays per second", "%,18.0f", report.raysPerSecond());
        table.line("peak memory", "%,18.1f MiB", report.peakMemoryBytes() / MEBI);
        return table.text.toString();
    }

    private void sampling(RenderReport report) {
        RenderReport.Sampling s = report.sampling();
        boolean own = s.method() == report.settings().method();
        String plain = own ? "" : ", too few for a survey: evenly spaced, as with " + s.method();
        line("samples per pixel", "%,18.2f   decided by %s%s", s.samplesPerPixel(), report.decidedBy(), plain);
        line(
                "estimated error",
                "%18.5f   95 %% interval %.5f .. %.5f",
                s.estimatedError(),
                s.errorLow(),
                s.errorHigh());
        if (s.light().isPresent() && s.plannedSamples() < FEW) {
            line("  of so few samples", "%18s   they do not tell how much light they have missed", "a guess");
        }
        s.light().ifPresent(this::light);
        OptionalDouble asked = report.settings().budget().error();
        if (asked.isPresent()) {
            String met = report.isErrorMet() ? "met" : "not met";
            if (s.rounding() > 0) {
                met += String.format(Locale.ROOT, "; the file's rounding makes the upper end %.5f", s.errorInFile());
            }
            line(
                    "error asked for",
                    "%18.5f   %s%s",
                    asked.getAsDouble(),
                    met,
                    s.rounds() > 1 ? "; rendered " + s.rounds() + " times" : "");
        }
        if (s.clusters() > 0) {
            double percent = s.proposals() == 0 ? 0 : 100.0 * s.accepted() / s.proposals();
            boolean areChains = s.method() == Method.METROPOLIS;
            line(
                    areChains ? "Markov chains" : "ray clusters",
                    "%,18d   %,d %s, %.1f %% accepted",
                    s.clusters(),
                    s.proposals(),
                    areChains ? "steps proposed" : "proposals",
                    percent);
            if (areChains) {
                row("  in blocks", BuiltInMethod.MetropolisSettings.blocks(report.settings()));
            }
        }
    }

    /** Beside the error of what a screen shows. One sample of each pixel tells nothing. */
    private void light(RenderReport.Light light) {
        if (Double.isFinite(light.relativeError())) {
            line("  of linear light", "%18.5f   relative", light.relativeError());
        }
        if (Double.isFinite(light.kurtosis())) {
            line("  kurtosis", "%,18.1f%s", light.kurtosis(), light.heavyTail() ? "   " + LightNotes.HEAVY_TAIL : "");
        }
        if (!light.undersampled().isEmpty()) {
            line("  undersampled", "   %s", String.join("; ", light.undersampled()));
        }
        if (light.lostSamples() > 0) {
            row("lost samples", light.lostSamples());
        }
    }

    private void counts(String what, Map<String, Long> counts) {
        for (Map.Entry<String, Long> e : counts.entrySet()) {
            row(what + ": " + e.getKey(), e.getValue());
        }
    }

    private void primitives(Map<String, Long> tests, Map<String, Long> hits) {
        for (Map.Entry<String, Long> e : tests.entrySet()) {
            line(e.getKey(), "%,18d tests   %,d hits", e.getValue(), hits.getOrDefault(e.getKey(), 0L));
        }
    }

    private void row(String label, long value) {
        line(label, "%,18d", value);
    }

    private void line(String label, String format, Object... values) {
        text.append(String.format(Locale.ROOT, "%-20s", label));
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}
