package enlightenment.measure;

import java.util.List;
import java.util.Optional;

/**
 * The trade of speed against accuracy of one scene.
 *
 * @param settings what was to be measured
 * @param reference what was taken for the truth
 * @param curves one for each method, in the order asked for
 * @param needs what each method needs for each of {@link #TARGETS}, where that can be told
 * @param equalTime pictures that took equally long; empty where there was no time for them
 * @param sweeps what the notches of the switches cost and bought
 * @param runs all runs
 * @param coldSeconds by how much the very first render of this process took longer than the same one later
 * @param seconds how long all of it took, this time
 * @param complete false where it was stopped
 */
public record TradeResult(
        TradeSettings settings,
        Reference reference,
        List<Curve> curves,
        List<Need> needs,
        List<EqualTime> equalTime,
        List<SweepResult> sweeps,
        List<TradeRun> runs,
        double coldSeconds,
        double seconds,
        boolean complete) {
    /** The errors that are asked about: one, a half and a tenth of a percent of white. */
    public static final List<Double> TARGETS = List.of(0.01, 0.005, 0.001);

    /** How many renders tell how busy the machine was. */
    private static final int LONGEST = 7;

    public TradeResult {
        curves = List.copyOf(curves);
        needs = List.copyOf(needs);
        equalTime = List.copyOf(equalTime);
        sweeps = List.copyOf(sweeps);
        runs = List.copyOf(runs);
    }

    /** What a method needs for an error, if that can be told. */
    public Optional<Need> need(String method, double target) {
        return needs.stream()
                .filter(n -> n.method().equals(method) && n.target() == target)
                .findFirst();
    }

    /**
     * How much of the processors' time the longest renders got, 0..1: well below 1 where the machine had other work to do. Also
     * 1 where the machine does not tell processor times.
     */
    public double shareOfProcessors() {
        int processors = Runtime.getRuntime().availableProcessors();
        List<Double> shares = runs.stream()
                .filter(r -> r.kind().equals(TradeRun.LADDER) && r.cpuSeconds() > 0)
                .sorted((a, b) -> Double.compare(b.wallSeconds(), a.wallSeconds()))
                .limit(LONGEST)
                .map(r -> r.cpuSeconds() / (r.wallSeconds() * Math.min(r.threads(), processors)))
                .toList();
        return shares.isEmpty() ? 1 : Math.min(Spread.of(shares).median(), 1);
    }
}
