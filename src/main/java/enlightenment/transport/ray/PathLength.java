package enlightenment.transport.ray;

/**
 * Counts and limits the bounces of a path. Surfaces that keep the ray's direction are no bounces, so that cutting an object into pieces
 * changes nothing.
 */
final class PathLength {
    private final int maxBounces;

    /** No line meets more surfaces: a path that passes more of them without a bounce is in a loop by rounding, and ends. */
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

    /** The number of scattering events so far. */
    int bounces() {
        return bounces;
    }

    /** Whether the limit admits this number of further scattering events. */
    boolean mayScatter(int times) {
        return bounces <= maxBounces - times;
    }

    /** Counts a surface that kept the ray's direction; returns whether the path may go on. */
    boolean passed() {
        return ++straight <= maxStraight;
    }

    /** Counts a scattering event; returns whether the path may go on. */
    boolean bounced() {
        straight = 0;
        return ++bounces <= maxBounces;
    }
}
