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
 */
public record TradeResult(TradeSettings settings, Reference reference, List<TradeRun> runs, Conditions conditions) {
    /** The errors that advice is given for: root mean square errors of one, a half and a tenth of a percent of white. */
    public static final List<Double> TARGETS = List.of(0.01, 0.005, 0.001);

    public TradeResult {
        runs = List.copyOf(runs);
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
