package enlightenment.status;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** The pages that look at a render, by the numbers that they give themselves: they are to see its end before it is gone. */
final class Watchers {
    /** More are not remembered. */
    static final int MOST = 32;

    /** Who has asked nothing for so long looks no more: pages ask every second. */
    static final long SILENCE_NANOS = 3_000_000_000L;

    /** When each was heard of last, the longest ago first. */
    private final Map<String, Long> seen = new LinkedHashMap<>();

    /** A page will be told how far it is, as far as is known not that it is over. */
    synchronized void told(String page, long now) {
        seen.remove(page);
        if (seen.size() == MOST) {
            seen.remove(seen.keySet().iterator().next());
        }
        seen.put(page, now);
    }

    /** A page has all that it will be shown. */
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
