package enlightenment.transport.state;

/**
 * When a random walk in media that scatter light ends by chance: the probabilities of Russian roulette. A mutable work object, one per
 * thread.
 *
 * <p>At a point where a medium scatters a path, what the path carries is compared to what it carried before the flight that brought it
 * there; what was lost since roulette was last played counts once.
 */
public final class RussianRoulette {
    /**
     * From this event on the share of paths that are still followed falls as the inverse root of the number of events. A path in a medium
     * that absorbs nothing ends only outside of it, and leaves a thick one after n events with a probability that falls as n^(−3/2): so
     * both the events of a path and its squared weight have a mean that grows as the logarithm of the medium's thickness.
     */
    private static final int LONG = 64;

    /** From this event on it falls as a geometric series: a path that can never leave has an end. */
    private static final int ENDLESS = 1 << 16;

    /** All of a scene is nearer to the origin of its frame. */
    private static final double NEAR = 4;

    /** How many events of media and their borders the path has had. */
    private int events;

    /** Whether the last event was one of a medium at which roulette was played. */
    private boolean isLevel;

    /** What the path carried, summed over bands, when roulette last was even. */
    private double level;

    /** How far from the origin the path has been. */
    private double farthest;

    /** Begins a path. */
    public void begin() {
        events = 0;
        isLevel = false;
        farthest = NEAR;
    }

    /** The path sets out on a flight and carries this, summed over bands. */
    public void depart(double carried) {
        if (!isLevel) {
            level = carried;
        }
        isLevel = false;
    }

    /**
     * The probability with which a path goes on that a medium has scattered at (x, y, z).
     *
     * @param carried what it carries now, summed over bands
     * @param isSafe whether nothing in its history asks for an end
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
     * The probability with which a path goes on after an event at a border of media of this weight. Inside a white medium nothing but its
     * border turns a path, so that the usual end of every hundredth path would make noise of the others.
     */
    public double survivalAtBorder(double r, double g, double b) {
        events++;
        double most = Math.max(r, Math.max(g, b));
        return Math.min(most, 1) * thinning();
    }

    /** The share of paths that go on from here because they have had so many events. */
    private double thinning() {
        return events <= LONG ? 1 : Math.sqrt(1 - 1.0 / Math.min(events, ENDLESS));
    }
}
