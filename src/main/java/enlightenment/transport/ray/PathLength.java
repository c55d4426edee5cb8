package enlightenment.transport.ray;

/** How long a path is, and how long it may become. Surfaces that do not turn the ray are no bounces: cutting a scene into more pieces changes nothing. */
final class PathLength {
    private final int maxBounces;

    /** No line meets more surfaces: a path that passes more of them straight is caught in a loop by rounding, and ends. */
    private final int maxStraight;

    private int bounces;
    private int straight;

    PathLength(int maxBounces, int maxStraight) {
        this.maxBounces = maxBounces;
        this.maxStraight = maxStraight;
    }

    void begin() {
        bounces = 0;
        straight = 0;
    }

    /** How many scattering events the path has had. */
    int bounces() {
        return bounces;
    }

    /** Whether it may have this number of scattering events more. */
    boolean mayScatter(int times) {
        return bounces <= maxBounces - times;
    }

    /** Counts a surface that was passed straight; returns whether the path may go on. */
    boolean passed() {
        return ++straight <= maxStraight;
    }

    /** Counts a scattering event; returns whether the path may go on. */
    boolean bounced() {
        straight = 0;
        return ++bounces <= maxBounces;
    }
}
