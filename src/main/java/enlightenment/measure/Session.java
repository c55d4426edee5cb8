package enlightenment.measure;

import enlightenment.image.Image;
import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.MeasuredCosts;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeListener;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.render.Renderer;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;

/** State shared by the steps of a measurement: clock, journal, reference, and expected render times. */
final class Session {
    private static final double NANO = 1e-9;

    final TradeSettings settings;

    /** Words of methods that do not sample all light of the scene; their errors include the missing light. */
    final Set<String> blind = new HashSet<>();

    final TradeFolder folder;
    final TimedRenderer renderer;
    private final Map<String, Double> fewest = new HashMap<>();
    private final TradeListener listener;
    private final long start = System.nanoTime();

    /** Seconds by the clock for one sample per pixel, by configuration, as last measured. */
    private final Map<Configuration, Double> secondsPerSample = new HashMap<>();

    private volatile String doing = "";
    private Reference reference;

    Session(
            Scene scene,
            TradeSettings settings,
            List<Renderer.Sight> methods,
            TradeFolder folder,
            TradeListener listener,
            BooleanSupplier cancelled) {
        this.settings = settings;
        for (Renderer.Sight sight : methods) {
            String word = sight.method().word();
            fewest.put(word, sight.fewestSamples());
            if (sight.blindSpot().isPresent()) {
                blind.add(word);
            }
        }
        this.folder = folder;
        this.listener = listener;
        renderer = new TimedRenderer(scene, cancelled, this::tick);
    }

    /** Reads a picture of the scene that was kept in a file. */
    Image read(Path file) throws IOException {
        return renderer.read(file);
    }

    double elapsed() {
        return (System.nanoTime() - start) * NANO;
    }

    /** Whether work of a duration in seconds would end within a share of the budget. */
    boolean fits(double seconds, double share) {
        return elapsed() + seconds <= share * settings.budgetSeconds();
    }

    /** The least samples per pixel of a method: with fewer, another one replaces it. */
    double fewest(String method) {
        return fewest.getOrDefault(method, 1.0);
    }

    /** Reports the next step to the listener. */
    void say(String what) {
        doing = what;
        tick();
    }

    private void tick() {
        double now = elapsed();
        listener.progress(doing, now, Math.max(settings.budgetSeconds(), now));
    }

    void reference(Reference made) {
        reference = made;
    }

    Reference reference() {
        return reference;
    }

    /** Renders, and records the time for {@link #expected}. */
    TimedRenderer.Timed timed(Configuration configuration, double samples, long seed) {
        TimedRenderer.Timed t = renderer.render(configuration.settings(settings.base(), samples, seed));
        secondsPerSample.put(configuration, t.wall() / samples);
        return t;
    }

    /** Expected seconds of a budget, in proportion to the last one, which overestimates larger budgets. */
    double expected(Configuration configuration, double samples) {
        Configuration own = Configuration.ofScene(settings, configuration.method());
        // A number of light samples without a run takes as long as the scene's own; a larger one longer in proportion.
        double unseen = secondsPerSample.getOrDefault(own, 0.0)
                * Math.max((double) configuration.lightSamples() / Math.max(own.lightSamples(), 1), 1);
        return secondsPerSample.getOrDefault(configuration, unseen) * samples;
    }

    /** Compares renders with the reference and writes them into the journal. */
    List<TradeRun> record(String kind, List<TimedRenderer.Timed> renders) throws IOException {
        List<TradeRun> runs = TimedRenderer.judge(kind, renders, reference.image());
        for (TradeRun run : runs) {
            record(run);
        }
        return runs;
    }

    void record(TradeRun run) throws IOException {
        folder.journal().add(run, reference.variance());
    }

    List<TradeRun> runs(Predicate<TradeRun> which) {
        return folder.journal().runs().stream().filter(which).toList();
    }

    boolean has(Predicate<TradeRun> which) {
        return folder.journal().runs().stream().anyMatch(which);
    }

    /** The costs of a configuration from all runs so far. */
    MeasuredCosts costs(Configuration configuration) {
        return MeasuredCosts.of(
                configuration, folder.journal().runs(), settings.base().threads(), reference.variance());
    }

    /** The costs of all configurations that ran, those with the scene's own light samples first. */
    List<MeasuredCosts> costs() {
        return TradeAnalysis.costs(settings, folder.journal().runs(), reference.variance());
    }

    /** The costs of a method with any number of light samples. */
    List<MeasuredCosts> costs(String method) {
        return costs().stream()
                .filter(r -> r.configuration().method().equals(method))
                .toList();
    }
}
