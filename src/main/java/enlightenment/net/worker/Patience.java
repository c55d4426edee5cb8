package enlightenment.net.worker;

/**
 * How long a worker goes on trying to work for a server, and how long it pauses before it tries again. Only tiles that the server has taken
 * begin both anew: a peer that greets can also talk nonsense. Reads no clock; times are nanoseconds of any origin.
 */
public final class Patience {
    private static final double SECOND = 1e9;
    private static final long FIRST_PAUSE_MILLIS = 100;
    private static final long LONGEST_PAUSE_MILLIS = 5_000;

    private final double limitSeconds;
    private long since;
    private long pause = FIRST_PAUSE_MILLIS;

    /** @param limitSeconds how long it goes on without a server that is of use */
    public Patience(double limitSeconds, long now) {
        this.limitSeconds = limitSeconds;
        since = now;
    }

    /**
     * A session has ended.
     *
     * @param usefulNanos for how much of it the server did what a server does: that time does not count as lost
     * @param hasProgress whether the server has taken a tile in it
     */
    public void sessionEnded(long now, long usefulNanos, boolean hasProgress) {
        if (hasProgress) {
            since = now;
            pause = FIRST_PAUSE_MILLIS;
        } else {
            since += usefulNanos;
        }
    }

    /** Seconds without a server that is of use. */
    public double lostSeconds(long now) {
        return (now - since) / SECOND;
    }

    public boolean isOver(long now) {
        return lostSeconds(now) >= limitSeconds;
    }

    /** The longest that the next pause should be; half of it is the shortest. Each is twice the one before, up to 5 s. */
    public long nextPauseMillis() {
        long next = pause;
        pause = Math.min(2 * pause, LONGEST_PAUSE_MILLIS);
        return next;
    }
}
