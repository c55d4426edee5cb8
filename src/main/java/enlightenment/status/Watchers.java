package enlightenment.status;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** The open pages of a render, by the numbers that they give themselves. The process waits until they have received its end. */
final class Watchers {
    /** Largest number of pages remembered. */
    static final int MOST = 32;

    /** A page without a request for this long is closed: open pages send one every second. */
    static final long SILENCE_NANOS = 3_000_000_000L;

    /** By page, the time of its last request, the oldest first. */
    private final Map<String, Long> seen = new LinkedHashMap<>();

    /** A page receives an answer that does not say that the render is over. */
    synchronized void told(String page, long now) {
        seen.remove(page);
        if (seen.size() == MOST) {
            seen.remove(seen.keySet().iterator().next());
        }
        seen.put(page, now);
    }

    /** A page has received all that it will be shown. */
    synchronized void served(String page) {
        seen.remove(page);
        notifyAll();
    }

    /**
     * Waits until all pages that still looked at this time have all that they will be shown.
     *
     * @param millis no longer than this
     * @return whether all of them have
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
