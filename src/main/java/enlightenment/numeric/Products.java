package enlightenment.numeric;

/**
 * Sums and differences of products that keep their accuracy when the terms cancel.
 *
 * <p>All of them use only {@code + - *} and {@link Math#fma}, which every machine rounds the same way.
 */
public final class Products {
    private Products() {}

    /**
     * a·b − c·d with an error of at most 1.5 units in the last place of the result (Kahan's algorithm; Jeannerod, Louvet
     * and Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2×2 determinants", 2013).
     */
    public static double difference(double a, double b, double c, double d) {
        double cd = c * d;
        double error = Math.fma(-c, d, cd);
        return Math.fma(a, b, -cd) + error;
    }

    /** a·b + c·d with the same bound as {@link #difference}. */
    public static double sum(double a, double b, double c, double d) {
        double cd = c * d;
        double error = Math.fma(c, d, -cd);
        return Math.fma(a, b, cd) + error;
    }

    /** The dot product of two vectors with fused steps: error at most γ₃·(|ax·bx| + |ay·by| + |az·bz|). */
    public static double dot(double ax, double ay, double az, double bx, double by, double bz) {
        return Math.fma(az, bz, Math.fma(ay, by, ax * bx));
    }

    /**
     * The dot product in twice the working precision, rounded once (Ogita, Rump and Oishi, "Accurate sum and dot
     * product", 2005, algorithm Dot2): error at most u·|result| + γ₃²·(|ax·bx| + |ay·by| + |az·bz|).
     */
    public static double accurateDot(double ax, double ay, double az, double bx, double by, double bz) {
        double p = ax * bx;
        double s = Math.fma(ax, bx, -p);
        double h = ay * by;
        double r = Math.fma(ay, by, -h);
        double sum = p + h;
        double t = sum - p;
        s += ((p - (sum - t)) + (h - t)) + r;
        p = sum;
        h = az * bz;
        r = Math.fma(az, bz, -h);
        sum = p + h;
        t = sum - p;
        s += ((p - (sum - t)) + (h - t)) + r;
        return sum + s;
    }

    /**
     * x² + y² + z² − r² in twice the working precision, rounded once: error at most u·|result| + γ₄²·(x² + y² + z² + r²). It
     * keeps its sign and most of its digits where the point (x, y, z) is close to the sphere of radius r.
     */
    public static double distanceSquaredMinus(double x, double y, double z, double r) {
        double p = x * x;
        double s = Math.fma(x, x, -p);
        double h = y * y;
        double e = Math.fma(y, y, -h);
        double sum = p + h;
        double t = sum - p;
        s += ((p - (sum - t)) + (h - t)) + e;
        p = sum;
        h = z * z;
        e = Math.fma(z, z, -h);
        sum = p + h;
        t = sum - p;
        s += ((p - (sum - t)) + (h - t)) + e;
        p = sum;
        h = -r * r;
        e = Math.fma(-r, r, -h);
        sum = p + h;
        t = sum - p;
        s += ((p - (sum - t)) + (h - t)) + e;
        return sum + s;
    }
}
