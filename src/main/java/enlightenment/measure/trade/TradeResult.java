package enlightenment.measure.trade;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a measurement of speed against accuracy found: every timed render, the reference they were compared with, and the
 * conditions. {@link enlightenment.measure.Trade#advice} evaluates it.
 *
 * @param settings what was asked for
 * @param reference what the errors are measured against
 * @param runs all runs, in the order they ended
 * @param conditions machine and time
 * @param blindSpots by the word of a method that cannot see all of the scene: what it cannot see, as a sentence without a full stop. Its
 *     errors include what is missing from its pictures
 */
public record TradeResult(
        TradeSettings settings,
        Reference reference,
        List<TradeRun> runs,
        Conditions conditions,
        Map<String, String> blindSpots) {
    /** The errors that advice is given for: root mean square errors of one, a half and a tenth of a percent of white. */
    public static final List<Double> TARGETS = List.of(0.01, 0.005, 0.001);

    public TradeResult {
        runs = List.copyOf(runs);
        blindSpots = new LinkedHashMap<>(blindSpots);
    }

    /** The methods that see all of the scene, in the order of the settings. */
    public List<String> sightedMethods() {
        return settings.methods().stream()
                .filter(word -> !blindSpots.containsKey(word))
                .toList();
    }

    /**
     * The conditions of a measurement.
     *
     * @param machine what it was measured on, by label, as {@link enlightenment.measure.Bench#machine()} returns it
     * @param coldSeconds by how much the first render of the process took longer than the same render later; at least 0
     * @param seconds how long the last session took by the clock
     * @param complete false where it was cancelled before its end
     */
    public record Conditions(Map<String, String> machine, double coldSeconds, double seconds, boolean complete) {
        /** The label of the number of processors in {@link #machine}. */
        public static final String PROCESSORS = "processors in use";

        public Conditions {
            machine = new LinkedHashMap<>(machine);
        }

        /** How many processors there were; those of this machine where {@link #machine} has none. */
        public int processors() {
            try {
                return Math.max(Integer.parseInt(machine.getOrDefault(PROCESSORS, "")), 1);
            } catch (NumberFormatException e) {
                return Runtime.getRuntime().availableProcessors();
            }
        }
    }
}
