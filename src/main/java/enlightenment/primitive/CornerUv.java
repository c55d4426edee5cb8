package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import java.util.Arrays;

/** The texture coordinates of a triangle's corners a, b, c: u to the right, v upwards, as vertices of meshes have them. */
record CornerUv(double au, double av, double bu, double bv, double cu, double cv) {
    /** Sets the texture coordinates of the point a + s (b − a) + t (c − a). */
    void interpolate(double s, double t, Hit hit) {
        double rest = 1 - s - t;
        hit.u = rest * au + s * bu + t * cu;
        hit.v = 1 - (rest * av + s * bv + t * cv);
    }

    /**
     * Sets the directions in which texture coordinates grow.
     *
     * @param b from the first corner to the second
     * @param c from the first corner to the third
     * @return false if the corners' texture coordinates lie in one line, or nearly so
     */
    boolean directions(Vec3 b, Vec3 c, Hit hit) {
        double determinant = Products.difference(bu - au, cv - av, bv - av, cu - au);
        if (determinant == 0) {
            return false;
        }
        Vec3 u = b.times((cv - av) / determinant).minus(c.times((bv - av) / determinant));
        Vec3 v = c.times((bu - au) / determinant).minus(b.times((cu - au) / determinant));
        hit.setTextureDirections(u, v);
        return u.isFinite() && v.isFinite();
    }

    /** These numbers behind others. */
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
