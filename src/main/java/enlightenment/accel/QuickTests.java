package enlightenment.accel;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.BoxPrimitive;
import enlightenment.primitive.CubePrimitive;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.RectanglePrimitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.TrianglePrimitive;

/**
 * Tests a few primitives in structures of arrays: a ray misses most of them by so much that a few operations and a single branch decide.
 * Undecided ones are tested by the primitive itself, so that the result is its own, bit for bit.
 *
 * <p>All conditions of a miss are combined before the branch: a branch for each would be mispredicted half of the time.
 */
final class QuickTests {
    /** A bound of the roundings of a quick test and of the primitive's own test together. */
    private static final double ERROR = Scale.gamma(128);

    private static final int BALL = 4;
    private static final int WALL = 5;

    private final SpherePrimitive[] spheres;
    private final int[] sphereIds;

    /** By sphere: the centre, and the squared radius rounded up. */
    private final double[] balls;

    private int sphereCount;

    /** Rectangles parallel to two axes: first those across x, then y, then z. */
    private final RectanglePrimitive[] rectangles;

    private final int[] rectangleIds;

    /** By rectangle: the coordinate on the axis that it is perpendicular to, and its extent on the others in order. */
    private final double[] walls;

    /** By axis, the index of the first rectangle perpendicular to it, then the end of the last. */
    private final int[] firstAcross = new int[4];

    /** The largest absolute coordinate of the rectangles. */
    private double reach;

    /** All other primitives; those with flat faces have bounding balls. */
    private final Primitive[] others;

    private final double[] ballsAround;
    private final int[] otherIds;
    private int otherCount;

    /** Makes room for this number of primitives. */
    QuickTests(int room) {
        spheres = new SpherePrimitive[room];
        sphereIds = new int[room];
        balls = new double[BALL * room];
        rectangles = new RectanglePrimitive[room];
        rectangleIds = new int[room];
        walls = new double[WALL * room];
        others = new Primitive[room];
        ballsAround = new double[BALL * room];
        otherIds = new int[room];
    }

    /** Sets the primitives: those with the first ids of an array. */
    void set(Primitive[] primitives, int[] ids, int size) {
        sphereCount = 0;
        otherCount = 0;
        reach = 0;
        int across = 0;
        for (int axis = 0; axis < 3; axis++) {
            firstAcross[axis] = across;
            for (int k = 0; k < size; k++) {
                if (axisOf(primitives[ids[k]]) == axis) {
                    setWall(across++, (RectanglePrimitive) primitives[ids[k]], ids[k], axis);
                }
            }
        }
        firstAcross[3] = across;
        for (int k = 0; k < size; k++) {
            Primitive p = primitives[ids[k]];
            if (p instanceof SpherePrimitive s && !p.isExtreme()) {
                setBall(sphereCount++, s, ids[k]);
            } else if (axisOf(p) < 0) {
                setBallAround(otherCount, p);
                others[otherCount] = p;
                otherIds[otherCount++] = ids[k];
            }
        }
    }

    private static int axisOf(Primitive p) {
        return p instanceof RectanglePrimitive r && !p.isExtreme() ? r.alignedAxis() : -1;
    }

    private void setBall(int k, SpherePrimitive s, int id) {
        spheres[k] = s;
        sphereIds[k] = id;
        put(balls, k, s.center(), s.radius());
    }

    private static void put(double[] balls, int k, Vec3 center, double radius) {
        balls[BALL * k] = center.x();
        balls[BALL * k + 1] = center.y();
        balls[BALL * k + 2] = center.z();
        balls[BALL * k + 3] = radius * radius * (1 + ERROR);
    }

    /**
     * Sets the bounding ball of a primitive. Those with curved faces, whose tests have errors of another kind, and extreme ones are always
     * tested.
     */
    private void setBallAround(int k, Primitive p) {
        boolean isFlatSided = p instanceof BoxPrimitive
                || p instanceof CubePrimitive
                || p instanceof RectanglePrimitive
                || p instanceof TrianglePrimitive;
        Bounds box = p.bounds();
        boolean isAsked = p.isExtreme() || !isFlatSided;
        Vec3 center = isAsked ? Vec3.ZERO : box.center();
        double radius =
                isAsked ? Double.POSITIVE_INFINITY : box.max().minus(center).length();
        put(ballsAround, k, center, radius);
    }

    private void setWall(int k, RectanglePrimitive r, int id, int axis) {
        Bounds box = r.bounds();
        int axis1 = axis == 0 ? 1 : 0;
        int axis2 = axis == 2 ? 1 : 2;
        rectangles[k] = r;
        rectangleIds[k] = id;
        walls[WALL * k] = box.min().component(axis);
        walls[WALL * k + 1] = box.min().component(axis1);
        walls[WALL * k + 2] = box.max().component(axis1);
        walls[WALL * k + 3] = box.min().component(axis2);
        walls[WALL * k + 4] = box.max().component(axis2);
        reach = Math.max(reach, box.maxAbs());
    }

    /**
     * Offers all primitives that the ray may hit.
     *
     * @return false, having offered nothing, for a ray that needs the general search
     */
    boolean search(Ray ray, Closest state) {
        double inverseX = 1 / ray.dx;
        double inverseY = 1 / ray.dy;
        double inverseZ = 1 / ray.dz;
        double sizes = Math.abs(inverseX) + Math.abs(inverseY) + Math.abs(inverseZ);
        if (ray.isSpecial() || !(ray.tMin >= 0) || !(sizes < Double.POSITIVE_INFINITY)) {
            return false;
        }
        searchBalls(balls, spheres, sphereIds, sphereCount, ray, state);
        double width = 2 * ERROR * (Math.abs(ray.ox) + Math.abs(ray.oy) + Math.abs(ray.oz) + reach);
        searchAcross(0, ray, state, ray.ox, inverseX, ray.oy, ray.dy, ray.oz, ray.dz, width);
        searchAcross(1, ray, state, ray.oy, inverseY, ray.ox, ray.dx, ray.oz, ray.dz, width);
        searchAcross(2, ray, state, ray.oz, inverseZ, ray.ox, ray.dx, ray.oy, ray.dy, width);
        searchBalls(ballsAround, others, otherIds, otherCount, ray, state);
        return true;
    }

    /** Skips a primitive if the ray's line misses its ball, or if the ray starts outside of the ball and leads away. */
    private static void searchBalls(double[] b, Primitive[] inBalls, int[] ids, int n, Ray ray, Closest state) {
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double dd = ray.dd;
        for (int k = 0; k < n; k++) {
            double fx = b[BALL * k] - ox;
            double fy = b[BALL * k + 1] - oy;
            double fz = b[BALL * k + 2] - oz;
            double along = fx * dx + fy * dy + fz * dz;
            double inside = b[BALL * k + 3] - (fx * fx + fy * fy + fz * fz) * (1 - ERROR);
            long refused = sign(inside * dd + along * along) | sign(inside) & sign(along);
            if (refused >= 0 && !leaves(ray, inBalls[k])) {
                state.offerCounted(ray, inBalls[k], ids[k]);
            }
        }
    }

    /** Whether the ray starts on the primitive and never meets it again. */
    private static boolean leaves(Ray ray, Primitive p) {
        return p == ray.start && ray.startSide == Ray.OUTSIDE && p.isConvex();
    }

    /**
     * Tests rectangles perpendicular to an axis: one is skipped if the ray meets its plane before its start, beyond the closest crossing,
     * or beside the rectangle. A ray that meets the plane well inside the rectangle hits it there ({@link RectanglePrimitive} decides
     * likewise).
     */
    private void searchAcross(
            int axis,
            Ray ray,
            Closest state,
            double o,
            double inverse,
            double o1,
            double d1,
            double o2,
            double d2,
            double width) {
        double[] w = walls;
        double slackT = width * Math.abs(inverse);
        double slack = slackT * (Math.abs(ray.dx) + Math.abs(ray.dy) + Math.abs(ray.dz));
        double least = ray.tMin - slackT;
        int end = firstAcross[axis + 1];
        for (int k = firstAcross[axis]; k < end; k++) {
            double t = (w[WALL * k] - o) * inverse;
            double p1 = Math.fma(t, d1, o1);
            double p2 = Math.fma(t, d2, o2);
            double below1 = p1 - w[WALL * k + 1];
            double above1 = w[WALL * k + 2] - p1;
            double below2 = p2 - w[WALL * k + 3];
            double above2 = w[WALL * k + 4] - p2;
            long refused = sign(t - least)
                    | sign(state.t() + slackT - t)
                    | sign(below1 + slack)
                    | sign(above1 + slack)
                    | sign(below2 + slack)
                    | sign(above2 + slack);
            if (refused < 0 || rectangles[k] == ray.start) {
                continue;
            }
            if ((sign(below1 - slack) | sign(above1 - slack) | sign(below2 - slack) | sign(above2 - slack)) >= 0) {
                t = (w[WALL * k] - o) / ray.d(axis);
                state.take(ray, rectangles[k], rectangleIds[k], t >= ray.tMin ? t : Primitive.MISS);
            } else {
                state.offerCounted(ray, rectangles[k], rectangleIds[k]);
            }
        }
    }

    /** A number whose sign bit is set if the argument is less than 0. */
    private static long sign(double v) {
        return Double.doubleToRawLongBits(v);
    }
}
