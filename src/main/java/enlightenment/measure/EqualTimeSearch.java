package enlightenment.measure;

import enlightenment.measure.analysis.Digits;
import enlightenment.measure.analysis.EqualTimeComparison;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Search for budgets of equal render time. It renders, as the time of a budget cannot be predicted and the machine's speed drifts. The
 * slowest configuration keeps its budget; the others approach its time.
 */
final class EqualTimeSearch {
    private static final int MAX_ROUNDS = 6;

    /** Largest factor by which a budget changes in one round. */
    private static final double MAX_CHANGE = 4;

    /** Largest power of the ratio of times by which a budget changes. */
    private static final double MAX_POWER = 3;

    /** Renders once with a budget and returns the seconds. */
    @FunctionalInterface
    interface Stopwatch {
        double seconds(int configuration, double samples);
    }

    /**
     * The budgets with the smallest ratio of times.
     *
     * @param samples samples per pixel, by configuration
     * @param seconds measured times of the same round, by configuration: means of two renders
     */
    record Found(double[] samples, double[] seconds) {
        /** The ratio of the longest to the shortest time. */
        double apart() {
            return Arrays.stream(seconds).max().orElse(1)
                    / Arrays.stream(seconds).min().orElse(1);
        }

        boolean isEqual() {
            return apart() <= EqualTimeComparison.TOLERANCE;
        }
    }

    private final Stopwatch stopwatch;
    private final BooleanSupplier more;

    /** @param more returns whether there is time for another round; the first is always made */
    EqualTimeSearch(Stopwatch stopwatch, BooleanSupplier more) {
        this.stopwatch = stopwatch;
        this.more = more;
    }

    /** Searches from the given budgets, each at least 1. */
    Found search(double[] start) {
        Found now = measure(start);
        Found best = now;
        int leader = slowest(now.seconds);
        double[] power = new double[start.length];
        Arrays.fill(power, 1);
        for (int round = 1; round < MAX_ROUNDS && !best.isEqual() && more.getAsBoolean(); round++) {
            double[] samples = now.samples.clone();
            for (int i = 0; i < samples.length; i++) {
                if (i != leader) {
                    double factor = Math.pow(now.seconds[leader] / now.seconds[i], power[i]);
                    samples[i] = Digits.nearTwo(samples[i] * Math.min(Math.max(factor, 1 / MAX_CHANGE), MAX_CHANGE));
                }
            }
            Found before = now;
            now = measure(samples);
            for (int i = 0; i < samples.length; i++) {
                power[i] = power(before, now, i);
            }
            best = now.apart() < best.apart() ? now : best;
        }
        return best;
    }

    /** Measures all configurations in turn and in reverse order, so that a linear drift of speed favours none. */
    private Found measure(double[] samples) {
        double[] seconds = new double[samples.length];
        for (int i = 0; i < samples.length; i++) {
            seconds[i] += stopwatch.seconds(i, samples[i]) / 2;
        }
        for (int i = samples.length - 1; i >= 0; i--) {
            seconds[i] += stopwatch.seconds(i, samples[i]) / 2;
        }
        return new Found(samples, seconds);
    }

    /** Exponent of the budget as a power of the time, from two rounds; above 1 with large fixed costs. */
    private static double power(Found before, Found now, int i) {
        double samples = Math.log(now.samples[i] / before.samples[i]);
        double seconds = Math.log(now.seconds[i] / before.seconds[i]);
        double power = samples / seconds;
        return Double.isFinite(power) && power > 1 ? Math.min(power, MAX_POWER) : 1;
    }

    private static int slowest(double[] seconds) {
        int slowest = 0;
        for (int i = 1; i < seconds.length; i++) {
            slowest = seconds[i] > seconds[slowest] ? i : slowest;
        }
        return slowest;
    }
}
