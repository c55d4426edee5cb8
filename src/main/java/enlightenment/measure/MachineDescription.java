package enlightenment.measure;

import enlightenment.machine.MachineFacts;
import enlightenment.measure.trade.TradeResult;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** Description of the machine of a measurement. */
final class MachineDescription {
    private static final Path CPU_INFO = Path.of("/proc/cpuinfo");
    private static final double MEBI = 1 << 20;

    private MachineDescription() {}

    /** Processor, system, Java, and current load of the machine, by label. */
    static Map<String, String> facts() {
        Map<String, String> facts = new LinkedHashMap<>();
        Runtime runtime = Runtime.getRuntime();
        facts.put("processor", processor());
        facts.put(TradeResult.Conditions.PROCESSORS, Integer.toString(runtime.availableProcessors()));
        facts.put(
                "system",
                System.getProperty("os.name") + " " + System.getProperty("os.version") + " "
                        + System.getProperty("os.arch"));
        facts.put("Java", Runtime.version() + ", " + System.getProperty("java.vm.name"));
        facts.put("largest heap", String.format(Locale.ROOT, "%.0f MiB", runtime.maxMemory() / MEBI));
        double load = MachineFacts.loadAverage();
        facts.put("load when it began", load < 0 ? "unknown" : String.format(Locale.ROOT, "%.1f", load));
        return facts;
    }

    /** The processor's model if Linux reports it, else its architecture. */
    private static String processor() {
        try {
            for (String line :
                    Files.readString(CPU_INFO, StandardCharsets.UTF_8).split("\n")) {
                if (line.startsWith("model name") && line.indexOf(':') > 0) {
                    return line.substring(line.indexOf(':') + 1).strip();
                }
            }
        } catch (IOException e) {
            // Not Linux, or not readable: the architecture is returned instead.
        }
        return System.getProperty("os.arch");
    }
}
