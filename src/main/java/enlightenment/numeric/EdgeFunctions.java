package enlightenment.numeric;

/** What the signs of a triangle's three edge functions say, which are those of a point in the plane that the triangle is projected to. */
public final class EdgeFunctions {
    /**
     * Bounds the rounding of a sheared coordinate relative to the distance of the vertices from the origin, and that of an
     * edge function relative to the square of the distance.
     */
    public static final double ERROR = Scale.gamma(64);

    private EdgeFunctions() {}

    /** Whether the point lies in the closed triangle; false if the triangle is seen edge-on. */
    public static boolean cover(double e0, double e1, double e2) {
        boolean anyNegative = e0 < 0 || e1 < 0 || e2 < 0;
        boolean anyPositive = e0 > 0 || e1 > 0 || e2 > 0;
        return anyNegative != anyPositive;
    }
}
