package enlightenment.shading;

/** Across which axis a group of points is cut: that of the longest side of the box around them. */
final class LongestSide {
    private LongestSide() {}

    /** A coordinate of a point. */
    interface Coordinates {
        double of(int point, int axis);
    }

    /** The axis, 0..2, of the points with the numbers from the first on and before the end; the first one of those with equal sides. */
    static int of(int first, int end, Coordinates coordinates) {
        int longest = 0;
        double length = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double greatest = Double.NEGATIVE_INFINITY;
            for (int k = first; k < end; k++) {
                double coordinate = coordinates.of(k, axis);
                least = Math.min(least, coordinate);
                greatest = Math.max(greatest, coordinate);
            }
            if (greatest - least > length) {
                length = greatest - least;
                longest = axis;
            }
        }
        return longest;
    }
}
