package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.primitive.Ray;

/**
 * Tests of rays from one point, the apex of a cone, against balls: terms that depend on the apex are computed once for all rays. A mutable
 * work object, one per thread.
 *
 * <p>Let f be the vector from a ball's centre to the apex, r the radius, d a ray's direction: the ray's line misses the ball if (f·d)² &lt;
 * (f² − r²)·d². Here f² is decreased and r² increased by 2^-40 of themselves, which covers all roundings, those of a sphere's own test too:
 * that computes the same f, and r²d² − (f × d)² with an error of a few units of 2^-53 of (f² + r²)·d². Where a product could leave the
 * range of doubles, the result is never a miss.
 */
final class ApexBalls {
    private static final double LESS = 1 - 0x1p-40;
    private static final double MORE = 1 + 0x1p-40;

    /** Squared distances between which products with squared directions that are not extreme stay in range. */
    private static final double NEAREST = 0x1p-480;

    private static final double FARTHEST = 0x1p480;

    private static final int NUMBERS = 4;

    /** By ball: f and f² − r²; NaN for the latter if the ball is never missed. */
    private final double[] b;

    private double x;
    private double y;
    private double z;

    ApexBalls(int most) {
        b = new double[NUMBERS * most];
    }

    /** Sets the apex to that of a cone. */
    void startAt(BallCone cone) {
        x = cone.x;
        y = cone.y;
        z = cone.z;
    }

    /** Sets a ball by its centre and squared radius. */
    void set(int k, double cx, double cy, double cz, double rr) {
        double fx = x - cx;
        double fy = y - cy;
        double fz = z - cz;
        double ff = fx * fx + fy * fy + fz * fz;
        int at = NUMBERS * k;
        b[at] = fx;
        b[at + 1] = fy;
        b[at + 2] = fz;
        b[at + 3] = ff >= NEAREST && ff <= FARTHEST ? LESS * ff - MORE * rr : Double.NaN;
    }

    /** Sets entry k to a ball that no ray misses. */
    void setAny(int k) {
        b[NUMBERS * k + 3] = Double.NaN;
    }

    /** Whether the line of a ray that is not extreme certainly misses a ball. */
    boolean misses(int k, Ray ray) {
        int at = NUMBERS * k;
        double fd = Math.fma(b[at + 2], ray.dz, Math.fma(b[at + 1], ray.dy, b[at] * ray.dx));
        return fd * fd < b[at + 3] * ray.dd;
    }

    void swap(int k, int l) {
        for (int i = 0; i < NUMBERS; i++) {
            double s = b[NUMBERS * k + i];
            b[NUMBERS * k + i] = b[NUMBERS * l + i];
            b[NUMBERS * l + i] = s;
        }
    }
}
