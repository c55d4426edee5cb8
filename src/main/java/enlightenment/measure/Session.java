package enlightenment.measure;

import enlightenment.scene.Scene;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;

/** What the steps of a trade share: stopwatch, journal, reference, and what renders are known to cost. */
final class Session {
    private static final double NANO = 1e-9;

    final TradeSettings settings;
    final TradeFolder folder;
    final Meter meter;
    private final TradeListener listener;
    private final long start = System.nanoTime();

    /** Seconds by the clock for one sample per pixel, by contender, as last seen. */
    private final Map<Contender, Double> secondsPerSample = new HashMap<>();

    private volatile String doing = "";
    private Reference reference;

    Session(
            Scene scene,
            TradeSettings settings,
            TradeFolder folder,
            TradeListener listener,
            BooleanSupplier cancelled) {
        this.settings = settings;
        this.folder = folder;
        this.listener = listener;
        meter = new Meter(scene, cancelled, this::tick);
    }

    double elapsed() {
        return (System.nanoTime() - start) * NANO;
    }

    /** Whether work of so many seconds still fits in before this share of the budget is over. */
    boolean fits(double seconds, double share) {
        return elapsed() + seconds <= share * settings.budgetSeconds();
    }

    /** Says what comes next. */
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

    /** Renders, and remembers what it cost. */
    Meter.Timed timed(Contender contender, double samples, long seed) {
        Meter.Timed t = meter.render(contender.settings(settings.base(), samples, seed));
        secondsPerSample.put(contender, t.wall() / samples);
        return t;
    }

    /** What so many samples are expected to take; too much rather than too little where they are more than last time. */
    double expected(Contender contender, double samples) {
        Contender own = settings.own(contender.method());
        // Of a number of light points that was not seen yet, what those of the scene take; more take more.
        double unseen = secondsPerSample.getOrDefault(own, 0.0)
                * Math.max((double) contender.lightPoints() / own.lightPoints(), 1);
        return secondsPerSample.getOrDefault(contender, unseen) * samples;
    }

    /** Judges renders that were made one after the other and writes them into the journal. */
    List<TradeRun> record(String kind, List<Meter.Timed> renders) throws IOException {
        List<TradeRun> runs = Meter.judge(kind, renders, reference.image());
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

    /** What is known of a contender by now. */
    Reach reach(Contender contender) {
        return Reach.of(contender, folder.journal().runs(), settings.base().threads(), reference.variance());
    }

    /** What is known by now of all that ran, those with the scene's own light points first. */
    List<Reach> reaches() {
        return TradeResult.reaches(settings, folder.journal().runs(), reference.variance());
    }

    /** What is known by now of a method with any number of light points. */
    List<Reach> reaches(String method) {
        return reaches().stream()
                .filter(r -> r.contender().method().equals(method))
                .toList();
    }
}
