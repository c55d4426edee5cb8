package enlightenment.compiled;

import enlightenment.geometry.Primitive;
import enlightenment.geometry.RectanglePrimitive;
import enlightenment.math.Bounds;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * Which primitives can stand between a point and a light.
 *
 * <p>For a point P and a light inside a ball, every shadow ray runs inside the cone with apex P around the ball. A
 * primitive whose bounding ball keeps clear of that cone can block none of them. Bounds are conservative: a candidate
 * too many costs a test, one too few would be a wrong picture.
 *
 * <p>A rectangle that has everything on one side (a wall of the room) can never stand between two things in the room and
 * is left out from the start.
 */
final class OccluderSet {
    /** Covers the roundings of the cone test, with room to spare. */
    private static final double TEST_ERROR = Scale.gamma(64);

    /** What {@link #gather} returns where one ball hides the whole light, so that no ray is needed to know it. */
    static final int ALL_BLOCKED = -1;

    private final int[] ids;

    /** Per candidate: centre and radius of a ball around it. */
    private final double[] balls;

    /** Per candidate: whether it is that ball, so that it blocks what the ball blocks. */
    private final boolean[] isBall;

    OccluderSet(Primitive[] primitives, CompiledLight[] lights) {
        int[] candidates = new int[primitives.length];
        int n = 0;
        for (int i = 0; i < primitives.length; i++) {
            if (!isWall(primitives[i], primitives, lights)) {
                candidates[n++] = i;
            }
        }
        ids = Arrays.copyOf(candidates, n);
        balls = new double[4 * ids.length];
        isBall = new boolean[ids.length];
        for (int k = 0; k < ids.length; k++) {
            ball(primitives[ids[k]], k);
        }
    }

    private void ball(Primitive p, int k) {
        Bounds box = p.bounds();
        Vec3 c = box.center();
        double radius = box.max().minus(c).length();
        if (p instanceof enlightenment.geometry.SpherePrimitive s) {
            c = s.center();
            radius = s.radius();
            isBall[k] = true;
        }
        balls[4 * k] = c.x();
        balls[4 * k + 1] = c.y();
        balls[4 * k + 2] = c.z();
        balls[4 * k + 3] = radius * (1 + TEST_ERROR);
    }

    /** Whether a rectangle parallel to two axes has every other primitive and every light on one side or in its plane. */
    private static boolean isWall(Primitive p, Primitive[] primitives, CompiledLight[] lights) {
        if (!(p instanceof RectanglePrimitive)) {
            return false;
        }
        Bounds plane = p.bounds();
        for (int axis = 0; axis < 3; axis++) {
            double at = plane.min().component(axis);
            if (plane.max().component(axis) == at
                    && (all(primitives, lights, axis, at, 1) || all(primitives, lights, axis, at, -1))) {
                return true;
            }
        }
        return false;
    }

    private static boolean all(Primitive[] primitives, CompiledLight[] lights, int axis, double at, int side) {
        for (Primitive q : primitives) {
            if (beyond(q.bounds(), axis, at, side)) {
                return false;
            }
        }
        for (CompiledLight light : lights) {
            if (beyond(light.bounds(), axis, at, side)) {
                return false;
            }
        }
        return true;
    }

    private static boolean beyond(Bounds b, int axis, double at, int side) {
        return side > 0 ? b.min().component(axis) < at : b.max().component(axis) > at;
    }

    int size() {
        return ids.length;
    }

    /**
     * Collects the primitives that may stand between (x, y, z) and the light, in the order of their ids.
     *
     * @param cone how the light is seen from there
     * @param self a primitive that is known not to, or -1
     * @return how many there are in {@code out}, or {@link #ALL_BLOCKED}
     */
    int gather(double x, double y, double z, LightCone cone, int self, int[] out) {
        int n = 0;
        double end = cone.distance + cone.radius;
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == self) {
                continue;
            }
            double cx = balls[4 * k] - x;
            double cy = balls[4 * k + 1] - y;
            double cz = balls[4 * k + 2] - z;
            double along = cx * cone.wx + cy * cone.wy + cz * cone.wz;
            double slack = balls[4 * k + 3] + TEST_ERROR * (Math.abs(cx) + Math.abs(cy) + Math.abs(cz) + end);
            double cc = cx * cx + cy * cy + cz * cz;
            if (!cone.inside && isClear(along, cc, slack, end, cone)) {
                continue;
            }
            if (isBall[k] && !cone.inside && hides(cc, along, balls[4 * k + 3], cone)) {
                return ALL_BLOCKED;
            }
            out[n++] = ids[k];
        }
        return n;
    }

    /**
     * Whether a ball of radius {@code slack} keeps clear of the cone: it lies behind the apex, beyond the light, or its
     * centre is farther than its radius from the cone's side: across·cosθ − along·sinθ &gt; slack, squared.
     */
    private static boolean isClear(double along, double cc, double slack, double end, LightCone cone) {
        if (along < -slack || along - slack > end) {
            return true;
        }
        double reach = slack + along * cone.sine;
        double across2 = cc - along * along - TEST_ERROR * cc;
        return reach < 0 || across2 * cone.cosine * cone.cosine > reach * reach * (1 + TEST_ERROR);
    }

    /**
     * Whether a ball hides the whole cone around the light: it is nearer, and the cone around it, seen from the same
     * point, contains the light's: cos of the angle between the axes &gt; cos(θball − θlight), θball &gt; θlight.
     */
    private static boolean hides(double cc, double along, double paddedRadius, LightCone cone) {
        double radius = paddedRadius * (1 - 2 * TEST_ERROR);
        double nearestLight = cone.distance - cone.radius;
        double tangent = cc - radius * radius;
        if (!(tangent > 0) || !(tangent < nearestLight * nearestLight * (1 - TEST_ERROR))) {
            return false;
        }
        double distance = Math.sqrt(cc);
        double ballSine = radius / distance;
        double ballCosine = Math.sqrt(tangent) / distance;
        return ballSine > cone.sine && along / distance > ballCosine * cone.cosine + ballSine * cone.sine + TEST_ERROR;
    }
}
