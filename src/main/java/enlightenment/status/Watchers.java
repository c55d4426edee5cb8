package enlightenment.status;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** The open pages of a render, by identifiers they choose. The process waits until they have received the end. */
final class Watchers {
    /** Largest number of pages remembered. */
    static final int MOST = 32;

    /** A page without a request for this long is closed: open pages send one every second. */
    static final long SILENCE_NANOS = 3_000_000_000L;

    /** Time of the last request in nanoseconds, by page; the oldest first. */
    private final Map<String, Long> seen = new LinkedHashMap<>();

    /** Registers a page that has not received the end of the render. */
    synchronized void told(String page, long now) {
        seen.remove(page);
        if (seen.size() == MOST) {
            seen.remove(seen.keySet().iterator().next());
        }
        seen.put(page, now);
    }

    /** Removes a page that has received the end of the render. */
    synchronized void served(String page) {
        seen.remove(page);
        notifyAll();
    }

    /**
     * Waits until all pages that are open at a time have received the end of the render.
     *
     * @param now the time in nanoseconds, of the clock of {@link #told}
     * @param millis the longest wait
     * @return false if the wait was too short
     */
    synchronized boolean await(long now, long millis) {
        seen.values().removeIf(last -> now - last > SILENCE_NANOS);
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        long left = millis;
        try {
            while (!seen.isEmpty() && left > 0) {
                wait(left);
                left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return seen.isEmpty();
    }
}
