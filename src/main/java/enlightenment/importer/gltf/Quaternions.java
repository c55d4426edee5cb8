package enlightenment.importer.gltf;

/** Arithmetic of rotations as quaternions x, y, z, w. */
final class Quaternions {
    private Quaternions() {}

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    }

    /** The quaternion of length 1 in this direction; that of no rotation for length 0. */
    static double[] unit(double[] q) {
        double n = StrictMath.sqrt(dot(q, q));
        return n > 0 ? new double[] {q[0] / n, q[1] / n, q[2] / n, q[3] / n} : new double[] {0, 0, 0, 1};
    }

    /** Spherical linear interpolation of unit quaternions along the shorter arc (K. Shoemake, SIGGRAPH 1985). */
    static double[] slerp(double[] a, double[] b, double s) {
        double side = dot(a, b) < 0 ? -1 : 1;
        double[] difference = new double[4];
        double[] sum = new double[4];
        for (int i = 0; i < 4; i++) {
            difference[i] = side * b[i] - a[i];
            sum[i] = side * b[i] + a[i];
        }
        // By half the chord: accurate for small angles, where an arc cosine is not.
        double angle =
                2 * StrictMath.atan2(StrictMath.sqrt(dot(difference, difference)), StrictMath.sqrt(dot(sum, sum)));
        double sine = StrictMath.sin(angle);
        double from = sine > 0 ? StrictMath.sin((1 - s) * angle) / sine : 1 - s;
        double to = side * (sine > 0 ? StrictMath.sin(s * angle) / sine : s);
        return unit(new double[] {
            from * a[0] + to * b[0], from * a[1] + to * b[1], from * a[2] + to * b[2], from * a[3] + to * b[3]
        });
    }
}
