package enlightenment.net.schedule;

/** Tiles per second of a worker over about its last {@value #MEMORY_SECONDS} busy seconds; older ones fade. */
final class Speed {
    private static final double MEMORY_SECONDS = 8;

    private double tiles;
    private double seconds;

    /** One more tile, this long after the one before or after the worker was given work. */
    void delivered(double afterSeconds) {
        double keep = MEMORY_SECONDS / (MEMORY_SECONDS + afterSeconds);
        tiles = tiles * keep + 1;
        seconds = seconds * keep + afterSeconds;
    }

    /** Whether anything has been measured. */
    boolean isKnown() {
        return seconds > 0;
    }

    /** Tiles per second; only if known. */
    double perSecond() {
        return tiles / seconds;
    }
}
