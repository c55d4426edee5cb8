package enlightenment.transport.state;

/**
 * Survival probabilities of Russian roulette for random walks in media. A mutable work object, one per thread.
 *
 * <p>Where a medium scatters a path, its throughput is compared to that before the flight that led there; a loss since roulette was last
 * played counts once.
 */
public final class RussianRoulette {
    /**
     * From this event on the share of paths that are still followed falls as the inverse root of the number of events. A path in a medium
     * that absorbs nothing ends only outside of it, and leaves a thick one after n events with a probability that falls as n^(−3/2): so
     * both the events of a path and its squared weight have a mean that grows as the logarithm of the medium's thickness.
     */
    private static final int LONG = 64;

    /**
     * From this event on survival no longer rises towards 1: the share of surviving paths falls as a geometric series, so that a path that
     * can never leave its medium ends.
     */
    private static final int ENDLESS = 1 << 16;

    /** An upper bound of the distance of anything in a scene from the origin of its frame. */
    private static final double NEAR = 4;

    /** The number of events in media and at their interfaces so far. */
    private int events;

    /** Whether the last event was in a medium and roulette was played there. */
    private boolean isLevel;

    /** The throughput, summed over bands, that survival is measured against. */
    private double level;

    /** The largest distance from the origin that the path has had where roulette was played, in the frame; at least {@link #NEAR}. */
    private double farthest;

    /** Begins a path: no events. */
    public void begin() {
        events = 0;
        isLevel = false;
        farthest = NEAR;
    }

    /** Begins a flight with this throughput, summed over bands. */
    public void depart(double carried) {
        if (!isLevel) {
            level = carried;
        }
        isLevel = false;
    }

    /**
     * The survival probability at a point (x, y, z) of a medium that has scattered the path.
     *
     * @param carried throughput now, summed over bands
     * @param isSafe whether events and throughput call for no roulette yet ({@link PathValue#isSafe})
     */
    public double survival(double carried, double x, double y, double z, boolean isSafe) {
        events++;
        double distance = Math.sqrt(x * x + y * y + z * z);
        isLevel = distance > NEAR || !isSafe;
        if (!isLevel) {
            return 1;
        }
        level /= Math.min(farthest / distance, 1) * thinning();
        farthest = Math.max(farthest, distance);
        return Math.min(carried / level, 1);
    }

    /**
     * The survival probability after an event of this weight at an interface of media. It may reach 1: inside a white medium only the
     * interface changes the throughput, and the usual {@link PathValue#LARGEST_SURVIVAL} would only add noise.
     */
    public double survivalAtInterface(double r, double g, double b) {
        events++;
        double most = Math.max(r, Math.max(g, b));
        return Math.min(most, 1) * thinning();
    }

    /** The survival probability because of the number of events alone. */
    private double thinning() {
        return events <= LONG ? 1 : Math.sqrt(1 - 1.0 / Math.min(events, ENDLESS));
    }
}
