package enlightenment.measure;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Under which circumstances something was measured.
 *
 * @param machine what it was measured on, label by label; {@link Machine#facts()} tells it
 * @param coldSeconds by how much the very first render of the process took longer than the same one later
 * @param seconds how long all of it took, the last time
 * @param complete false where it was stopped
 */
public record Circumstances(Map<String, String> machine, double coldSeconds, double seconds, boolean complete) {
    public Circumstances {
        machine = new LinkedHashMap<>(machine);
    }

    /** How many processors there were; those of this machine where that is not known. */
    int processors() {
        try {
            return Math.max(Integer.parseInt(machine.getOrDefault(Machine.PROCESSORS, "")), 1);
        } catch (NumberFormatException e) {
            return Runtime.getRuntime().availableProcessors();
        }
    }
}
