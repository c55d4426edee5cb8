package enlightenment.measure.analysis;

import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The trade-off of speed against accuracy, from the runs of a result.
 *
 * @param result the measurement
 * @param curves error against budget of each configuration: methods in the order asked for, the scene's own number of light
 *     samples first
 * @param costs costs of errors with each configuration of the methods that sample all light of the scene
 * @param sweeps time and accuracy of each value of the swept settings
 */
public record TradeAnalysis(
        TradeResult result, List<Curve> curves, List<MeasuredCosts> costs, List<SweepResult> sweeps) {
    /** Number of the longest renders that {@link #shareOfProcessors} is computed from. */
    private static final int LONGEST = 7;

    public TradeAnalysis {
        curves = List.copyOf(curves);
        costs = List.copyOf(costs);
        sweeps = List.copyOf(sweeps);
    }

    /** Evaluates a result. */
    public static TradeAnalysis of(TradeResult result) {
        TradeSettings settings = result.settings();
        List<TradeRun> runs = result.runs();
        double variance = result.reference().variance();
        return new TradeAnalysis(
                result,
                configurations(settings, runs).stream()
                        .map(c -> Curve.of(c, runs, variance))
                        .filter(c -> !c.points().isEmpty())
                        .toList(),
                costs(settings, runs, variance).stream()
                        .filter(c -> result.sightedMethods()
                                .contains(c.configuration().method()))
                        .toList(),
                settings.sweeps().stream()
                        .map(s -> SweepResult.of(s, settings.base().method().word(), runs, variance))
                        .toList());
    }

    /** The costs of each configuration that ran on the scene's number of threads. */
    public static List<MeasuredCosts> costs(TradeSettings settings, List<TradeRun> runs, double referenceVariance) {
        return configurations(settings, runs).stream()
                .map(c -> MeasuredCosts.of(c, runs, settings.base().threads(), referenceVariance))
                .toList();
    }

    private static Set<Configuration> configurations(TradeSettings settings, List<TradeRun> runs) {
        Set<Configuration> all = new LinkedHashSet<>();
        for (String method : settings.methods()) {
            all.add(Configuration.ofScene(settings, method));
            runs.stream()
                    .map(Configuration::of)
                    .filter(c -> c.method().equals(method))
                    .sorted(Comparator.comparing(Configuration::grid).thenComparing(Configuration::lightSamples))
                    .forEach(all::add);
        }
        return all;
    }

    /** The settings of the measurement. */
    public TradeSettings settings() {
        return result.settings();
    }

    /** Methods that may be advised: those that sample all light of the scene, in the order of the settings. */
    public List<String> methods() {
        return result.sightedMethods();
    }

    /** Whether a method does not sample all light of the scene. */
    public boolean isBlind(String method) {
        return result.blindSpots().containsKey(method);
    }

    /** The costs of a method with any number of light samples. */
    public List<MeasuredCosts> costs(String method) {
        return costs.stream()
                .filter(r -> r.configuration().method().equals(method))
                .toList();
    }

    /** A method with the scene's own number of light samples. */
    public Configuration own(String method) {
        return Configuration.ofScene(settings(), method);
    }

    /** The costs of one configuration. */
    public Optional<MeasuredCosts> costs(Configuration configuration) {
        return costs.stream()
                .filter(r -> r.configuration().equals(configuration))
                .findFirst();
    }

    /** The cost of an error by a method with the scene's own number of light samples, if that is known. */
    public Optional<CostEstimate> own(String method, double target) {
        return costs(own(method)).flatMap(r -> r.forError(target));
    }

    /**
     * The cost of an error by a method with the fastest number of light samples that ran. Measured costs are preferred to extrapolated ones.
     */
    public Optional<CostEstimate> best(String method, double target) {
        return fastest(costs(method), target);
    }

    /** The least time of some configurations for an error; only measured costs count if there are any. */
    public static Optional<CostEstimate> fastest(List<MeasuredCosts> costs, double target) {
        return costs.stream()
                .flatMap(r -> r.forError(target).stream())
                .min(Comparator.comparing((CostEstimate n) -> !n.isMeasured())
                        .thenComparingDouble(n -> n.wall().median()));
    }

    /** Whether an error can be judged: it is not below that of the reference. */
    public boolean isKnown(double target) {
        return target >= result.reference().error();
    }

    /** Origin and error of the reference, in two sentences. */
    public String referenceSentence() {
        Reference reference = result.reference();
        String error = Digits.of(reference.error(), 2);
        if (reference.parts().isEmpty()) {
            return "The reference was given. Its own error, estimated from two independent renders, is " + error + ".";
        }
        List<String> parts = reference.parts().stream()
                .map(p -> new Configuration(p.method(), p.lightSamples(), false).name() + ", "
                        + Digits.samples(p.samples()) + " samples per pixel")
                .toList();
        return "The reference is the mean of two independent renders: " + String.join(" and ", parts)
                + ". Its own error, from the difference of the two, is " + error + ".";
    }

    /**
     * The share of the requested processor time that the longest renders received, 0..1. It is well below 1 if the machine had other load, and 1 if
     * the system reports no processor times.
     */
    public double shareOfProcessors() {
        int processors = result.conditions().processors();
        List<Double> shares = result.runs().stream()
                .filter(r -> r.kind().equals(TradeRun.BUDGET_SERIES) && r.cpuSeconds() > 0)
                .sorted((a, b) -> Double.compare(b.wallSeconds(), a.wallSeconds()))
                .limit(LONGEST)
                .map(r -> r.cpuSeconds() / (r.wallSeconds() * Math.min(r.threads(), processors)))
                .toList();
        return shares.isEmpty() ? 1 : Math.min(Spread.of(shares).median(), 1);
    }
}
