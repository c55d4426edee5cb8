package enlightenment.compiled;

import enlightenment.accel.ConeJudge;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.SupportSurface;

/**
 * Finds the primitives that can occlude a light from a point.
 *
 * <p>For a point P and a light inside a ball, every shadow ray runs inside the cone with apex P around the ball. A
 * primitive whose bounding ball does not intersect that cone can block none of them. Bounds are conservative: a candidate
 * too many costs a test, one too few would be a wrong picture. See docs/occluders.md.
 *
 * <p>A flat primitive (a wall of the room) blocks none of them if point and light lie on the same side of its plane. That depends
 * only on the two: nothing else in the scene changes it.
 */
final class OccluderSet {
    /** Bounds the rounding of a distance from a plane, relative to the coordinates involved. */
    private static final double PLANE_ERROR = Scale.gamma(16);

    private final int count;

    /** By id: centre and radius of a ball around the primitive. */
    private final double[] balls;

    /** By id: whether the primitive is that ball itself. */
    private final boolean[] isBall;

    /** By id: whether the primitive is flat, and its plane's unit normal and offset. */
    private final boolean[] isFlat;

    private final double[] planes;

    OccluderSet(Primitive[] primitives, CompiledLight[] lights, boolean few) {
        count = primitives.length;
        balls = new double[4 * count];
        isBall = new boolean[count];
        isFlat = new boolean[count];
        planes = new double[4 * count];
        for (int id = 0; id < count; id++) {
            setBall(primitives[id], id);
            isFlat[id] = primitives[id].isFlat();
            if (isFlat[id] && primitives[id].support(0) instanceof SupportSurface.Plane p) {
                setPlane(p.unitNormal(), p.corners()[0], id);
            }
        }
        for (CompiledLight light : lights) {
            light.sides = few ? sides(light) : null;
        }
    }

    private void setPlane(Vec3 n, Vec3 point, int id) {
        planes[4 * id] = n.x();
        planes[4 * id + 1] = n.y();
        planes[4 * id + 2] = n.z();
        planes[4 * id + 3] = n.dot(point);
    }

    private byte[] sides(CompiledLight light) {
        byte[] sides = new byte[count];
        for (int id = 0; id < count; id++) {
            sides[id] = isFlat[id] ? sidesOf(light, 4 * id) : 0;
        }
        return sides;
    }

    private byte sidesOf(CompiledLight light, int k) {
        return light.sidesOf(planes[k], planes[k + 1], planes[k + 2], planes[k + 3], PLANE_ERROR);
    }

    private void setBall(Primitive p, int id) {
        Bounds box = p.bounds();
        Vec3 c = box.center();
        double radius = box.max().minus(c).length();
        if (p instanceof SpherePrimitive s) {
            c = s.center();
            radius = s.radius();
            isBall[id] = true;
        }
        balls[4 * id] = c.x();
        balls[4 * id + 1] = c.y();
        balls[4 * id + 2] = c.z();
        balls[4 * id + 3] = radius;
    }

    /** What is known of the primitives that may occlude a light, for one cone after another. One per thread. */
    final class Judge implements ConeJudge {
        private LightCone cone;
        private int[] starts;
        private int startCount;

        /**
         * Sets the cone around the light.
         *
         * @param around the cone
         * @param clear begins with the ids of primitives that are known not to occlude the light
         * @param count the number of these
         */
        Judge of(LightCone around, int[] clear, int count) {
            cone = around;
            starts = clear;
            startCount = count;
            return this;
        }

        @Override
        public int judge(int id) {
            for (int k = 0; k < startCount; k++) {
                if (starts[k] == id) {
                    return CLEAR;
                }
            }
            if (isFlat[id] && staysBeside(cone, id)) {
                return CLEAR;
            }
            double cx = balls[4 * id];
            double cy = balls[4 * id + 1];
            double cz = balls[4 * id + 2];
            double radius = balls[4 * id + 3];
            if (cone.misses(cx, cy, cz, radius)) {
                return CLEAR;
            }
            return isBall[id] && cone.isHiddenBy(cx, cy, cz, radius) ? BLOCKS_ALL : MAY_BLOCK;
        }
    }

    /**
     * Whether no segment from the apex to the light crosses the plane of a flat primitive: both lie on the same side of it, or
     * one of them lies in it. A segment that only starts or ends in the plane does not cross it.
     */
    private boolean staysBeside(LightCone cone, int id) {
        CompiledLight light = cone.light();
        int sides = light.sides == null ? sidesOf(light, 4 * id) : light.sides[id];
        double offset = planes[4 * id + 3];
        double height = planes[4 * id] * cone.x + planes[4 * id + 1] * cone.y + planes[4 * id + 2] * cone.z - offset;
        double error = PLANE_ERROR * (Math.abs(cone.x) + Math.abs(cone.y) + Math.abs(cone.z) + Math.abs(offset));
        if (height > error) {
            return (sides & CompiledLight.ABOVE) != 0;
        }
        return height >= -error || (sides & CompiledLight.BELOW) != 0;
    }
}
