package enlightenment.measure;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The trade of speed against accuracy of one scene.
 *
 * @param settings what was to be measured
 * @param reference what was taken for the truth
 * @param curves the ladder of each contender: methods in the order asked for, the scene's own number of light points first
 * @param reaches what each contender was seen to reach
 * @param equalTime pictures that took equally long, as far as that was possible; empty where there was no time for them
 * @param sweeps what the notches of the switches cost and bought
 * @param runs all runs
 * @param circumstances machine and time
 */
public record TradeResult(
        TradeSettings settings,
        Reference reference,
        List<Curve> curves,
        List<Reach> reaches,
        List<EqualTime> equalTime,
        List<SweepResult> sweeps,
        List<TradeRun> runs,
        Circumstances circumstances) {
    /** The errors that are asked about: one, a half and a tenth of a percent of white. */
    public static final List<Double> TARGETS = List.of(0.01, 0.005, 0.001);

    /** How many renders tell how busy the machine was. */
    private static final int LONGEST = 7;

    public TradeResult {
        curves = List.copyOf(curves);
        reaches = List.copyOf(reaches);
        equalTime = List.copyOf(equalTime);
        sweeps = List.copyOf(sweeps);
        runs = List.copyOf(runs);
    }

    /** What can be told from the runs. */
    static TradeResult of(
            TradeSettings settings,
            Reference reference,
            List<TradeRun> runs,
            List<EqualTime> equalTime,
            Circumstances circumstances) {
        double variance = reference.variance();
        return new TradeResult(
                settings,
                reference,
                contenders(settings, runs).stream()
                        .map(c -> Curve.of(c, runs, variance))
                        .filter(c -> !c.points().isEmpty())
                        .toList(),
                reaches(settings, runs, variance),
                equalTime,
                settings.sweeps().stream()
                        .map(s -> SweepResult.of(s, settings.base().method().word(), runs, variance))
                        .toList(),
                runs,
                circumstances);
    }

    /** What is known of each contender that ran on the usual number of threads. */
    static List<Reach> reaches(TradeSettings settings, List<TradeRun> runs, double referenceVariance) {
        return contenders(settings, runs).stream()
                .map(c -> Reach.of(c, runs, settings.base().threads(), referenceVariance))
                .toList();
    }

    private static Set<Contender> contenders(TradeSettings settings, List<TradeRun> runs) {
        Set<Contender> all = new LinkedHashSet<>();
        for (String method : settings.methods()) {
            all.add(settings.own(method));
            runs.stream()
                    .map(Contender::of)
                    .filter(c -> c.method().equals(method))
                    .sorted(Comparator.comparing(Contender::grid).thenComparing(Contender::lightPoints))
                    .forEach(all::add);
        }
        return all;
    }

    /** What a contender was seen to reach. */
    public Optional<Reach> reach(Contender contender) {
        return reaches.stream().filter(r -> r.contender().equals(contender)).findFirst();
    }

    /** What a method needs for an error with the scene's own number of light points, if that can be told. */
    public Optional<Need> own(String method, double target) {
        return reach(settings.own(method)).flatMap(r -> r.forError(target));
    }

    /**
     * What a method needs for an error with that of the tried numbers of light points that is quickest there. What was measured
     * goes before what is extrapolated.
     */
    public Optional<Need> best(String method, double target) {
        return quickest(
                reaches.stream()
                        .filter(r -> r.contender().method().equals(method))
                        .toList(),
                target);
    }

    /** The quickest of some contenders for an error; of what was measured, if anything was. */
    static Optional<Need> quickest(List<Reach> reaches, double target) {
        return reaches.stream()
                .flatMap(r -> r.forError(target).stream())
                .min(Comparator.comparing((Need n) -> !n.isMeasured())
                        .thenComparingDouble(n -> n.wall().median()));
    }

    /** Whether something can be said about an error: not below that of the reference. */
    public boolean isKnown(double target) {
        return target >= reference.error();
    }

    /**
     * How much of the processors' time the longest renders got, 0..1: well below 1 where the machine had other work to do. Also
     * 1 where the machine does not tell processor times.
     */
    public double shareOfProcessors() {
        int processors = circumstances.processors();
        List<Double> shares = runs.stream()
                .filter(r -> r.kind().equals(TradeRun.LADDER) && r.cpuSeconds() > 0)
                .sorted((a, b) -> Double.compare(b.wallSeconds(), a.wallSeconds()))
                .limit(LONGEST)
                .map(r -> r.cpuSeconds() / (r.wallSeconds() * Math.min(r.threads(), processors)))
                .toList();
        return shares.isEmpty() ? 1 : Math.min(Spread.of(shares).median(), 1);
    }
}
