package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import java.util.Arrays;

/** The texture coordinates of a triangle's corners a, b, c: u to the right, v upwards, as vertices of meshes have them. */
record CornerUv(double au, double av, double bu, double bv, double cu, double cv) {
    /** The u of the point a + s (b − a) + t (c − a). */
    double u(double s, double t) {
        return (1 - s - t) * au + s * bu + t * cu;
    }

    /** The v, upwards, of the point a + s (b − a) + t (c − a). */
    double v(double s, double t) {
        return (1 - s - t) * av + s * bv + t * cv;
    }

    /**
     * The vectors in which u and v grow by 1.
     *
     * @param b from the first corner to the second
     * @param c from the first corner to the third
     * @return null if the corners' texture coordinates are collinear, or nearly so
     */
    Vec3[] directions(Vec3 b, Vec3 c) {
        double determinant = Products.difference(bu - au, cv - av, bv - av, cu - au);
        if (determinant == 0) {
            return null;
        }
        Vec3 u = b.times((cv - av) / determinant).minus(c.times((bv - av) / determinant));
        Vec3 v = c.times((bu - au) / determinant).minus(b.times((cu - au) / determinant));
        return u.isFinite() && v.isFinite() ? new Vec3[] {u, v} : null;
    }

    /** Appends these numbers to others. */
    double[] appendTo(double[] numbers) {
        double[] all = Arrays.copyOf(numbers, numbers.length + 6);
        int n = numbers.length;
        all[n] = au;
        all[n + 1] = av;
        all[n + 2] = bu;
        all[n + 3] = bv;
        all[n + 4] = cu;
        all[n + 5] = cv;
        return all;
    }
}
