package enlightenment.primitive;

/** The interval of a line within the lateral surface of a cylinder or cone. */
final class LateralInterval {
    private LateralInterval() {}

    /**
     * m·A = F·(d × A), the moment of the line about the axis, by whichever of the two forms has the smaller error bound. Given are
     * the three products of each form; F carries roundings of its own, as large as those of the products.
     */
    static double axialMoment(double m1, double m2, double m3, double f1, double f2, double f3) {
        double boundM = Math.abs(m1) + Math.abs(m2) + Math.abs(m3);
        double boundF = Math.abs(f1) + Math.abs(f2) + Math.abs(f3);
        return boundM <= 2 * boundF ? m1 + m2 + m3 : f1 + f2 + f3;
    }

    /**
     * The lower end of the interval where aτ² + 2bτ + c ≤ 0 on the proper nappe; above {@link #upper} if it is empty.
     *
     * @param s the root of b² − ac, at least 0
     * @param e d·A: its sign says which end of a line within the cone's directions is on the proper nappe
     */
    static double lower(double a, double b, double c, double s, double e) {
        double q = b > 0 ? -b - s : -b + s;
        if (a < 0) {
            return e < 0 ? Double.NEGATIVE_INFINITY : q == 0 ? 0 : Math.max(q / a, c / q);
        }
        if (q == 0) {
            return a > 0 ? 0 : c > 0 ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
        }
        return b > 0 ? q / a : c / q;
    }

    /** The upper end of the interval of {@link #lower}. */
    static double upper(double a, double b, double c, double s, double e) {
        double q = b > 0 ? -b - s : -b + s;
        if (a < 0) {
            return e > 0 ? Double.POSITIVE_INFINITY : q == 0 ? 0 : Math.min(q / a, c / q);
        }
        if (q == 0) {
            return a > 0 ? 0 : c > 0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
        }
        return b > 0 ? c / q : q / a;
    }
}
