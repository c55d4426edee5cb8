package enlightenment.measure.trade;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The result of a measurement of speed against accuracy: all timed renders, their reference, and the conditions.
 * {@link enlightenment.measure.Trade#advice} evaluates it.
 *
 * @param settings settings of the measurement
 * @param reference the reference of all errors
 * @param runs all runs, in the order they ended
 * @param conditions machine and time
 * @param blindSpots light that methods do not sample, as sentences without a full stop, by the words of these methods. Their errors include the
 *     missing light
 */
public record TradeResult(
        TradeSettings settings,
        Reference reference,
        List<TradeRun> runs,
        Conditions conditions,
        Map<String, String> blindSpots) {
    /** Root mean square errors that advice is given for: one, a half and a tenth of a percent of white. */
    public static final List<Double> TARGETS = List.of(0.01, 0.005, 0.001);

    public TradeResult {
        runs = List.copyOf(runs);
        blindSpots = new LinkedHashMap<>(blindSpots);
    }

    /** Methods that sample all light of the scene, in the order of the settings. */
    public List<String> sightedMethods() {
        return settings.methods().stream()
                .filter(word -> !blindSpots.containsKey(word))
                .toList();
    }

    /**
     * The conditions of a measurement.
     *
     * @param machine facts about the machine by label, as of {@link enlightenment.measure.Bench#machine()}
     * @param coldSeconds seconds by which the first render of the process exceeded the same render later; at least 0
     * @param seconds seconds of the last session by the clock
     * @param complete false if the measurement was cancelled
     */
    public record Conditions(Map<String, String> machine, double coldSeconds, double seconds, boolean complete) {
        /** The label of the number of processors in {@link #machine}. */
        public static final String PROCESSORS = "processors in use";

        public Conditions {
            machine = new LinkedHashMap<>(machine);
        }

        /** Number of processors of the measurement; of this machine if {@link #machine} has no such fact. */
        public int processors() {
            try {
                return Math.max(Integer.parseInt(machine.getOrDefault(PROCESSORS, "")), 1);
            } catch (NumberFormatException e) {
                return Runtime.getRuntime().availableProcessors();
            }
        }
    }
}
