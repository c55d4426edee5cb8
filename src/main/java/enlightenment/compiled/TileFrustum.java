package enlightenment.compiled;

import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;
import enlightenment.math.Bounds;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;

/**
 * The part of space that the camera rays of one tile can reach, as four planes through the rays at its corners.
 *
 * <p>A primitive whose box lies wholly beyond one of the planes is met by no ray of the tile. The test is conservative:
 * its margin covers all roundings.
 */
final class TileFrustum {
    private static final double PLANE_ERROR = Scale.gamma(64);

    private final Vec3[] origins = new Vec3[4];
    private final Vec3[] normals = new Vec3[4];
    private final double[] magnitudes = new double[4];

    /** The frustum of the rays at (x0..x1, y0..y1), 0..1 from the picture's upper left corner. */
    TileFrustum(CompiledCamera camera, double x0, double y0, double x1, double y1) {
        double[] xs = {x0, x1, x1, x0};
        double[] ys = {y0, y0, y1, y1};
        Vec3[] o = new Vec3[5];
        Vec3[] d = new Vec3[5];
        Ray ray = new Ray();
        for (int i = 0; i <= 4; i++) {
            camera.ray(i < 4 ? xs[i] : (x0 + x1) / 2, i < 4 ? ys[i] : (y0 + y1) / 2, ray);
            o[i] = new Vec3(ray.ox, ray.oy, ray.oz);
            d[i] = new Vec3(ray.dx, ray.dy, ray.dz);
        }
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) & 3;
            Vec3 across = o[j].plus(d[j]).minus(o[i].plus(d[i]));
            Vec3 n = d[i].cross(across);
            // The middle ray shows which side is inside.
            double side = n.dot(o[4].plus(d[4]).minus(o[i]));
            origins[i] = o[i];
            normals[i] = side < 0 ? n.negated() : n;
            magnitudes[i] =
                    PLANE_ERROR * d[i].length() * (o[i].length() + o[j].length() + d[i].length() + d[j].length());
        }
    }

    /** Collects the ids of the primitives that rays of the tile may meet; returns how many there are. */
    int gather(Primitive[] primitives, Bounds[] bounds, int[] out) {
        int n = 0;
        for (int id = 0; id < primitives.length; id++) {
            if (reaches(bounds[id])) {
                out[n++] = id;
            }
        }
        return n;
    }

    private boolean reaches(Bounds box) {
        for (int i = 0; i < 4; i++) {
            if (isBeyond(box, i)) {
                return false;
            }
        }
        return true;
    }

    private boolean isBeyond(Bounds box, int plane) {
        Vec3 n = normals[plane];
        Vec3 o = origins[plane];
        // The corner that reaches farthest to the inside.
        double x = (n.x() > 0 ? box.max().x() : box.min().x()) - o.x();
        double y = (n.y() > 0 ? box.max().y() : box.min().y()) - o.y();
        double z = (n.z() > 0 ? box.max().z() : box.min().z()) - o.z();
        double margin = magnitudes[plane] * (Math.abs(x) + Math.abs(y) + Math.abs(z) + box.maxAbs());
        return n.x() * x + n.y() * y + n.z() * z < -margin;
    }
}
