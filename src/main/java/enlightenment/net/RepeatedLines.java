package enlightenment.net;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;

/** Logs a line once, however often it comes, and later how often it came. For use by several threads at once. */
final class RepeatedLines {
    /** Different lines that are counted; with the next one all begin anew. */
    private static final int MOST = 100;

    private final Consumer<String> log;
    private final Map<String, Integer> counts = new LinkedHashMap<>();

    RepeatedLines(Consumer<String> log) {
        this.log = log;
    }

    synchronized void say(String line) {
        if (counts.size() == MOST && !counts.containsKey(line)) {
            settle();
        }
        if (counts.merge(line, 1, Integer::sum) == 1) {
            log.accept(line);
        }
    }

    /** Logs what came several times, with the number, and begins anew. */
    synchronized void settle() {
        counts.forEach((line, count) -> {
            if (count > 1) {
                log.accept(count + " times: " + line);
            }
        });
        counts.clear();
    }
}
