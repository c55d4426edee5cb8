package enlightenment.compiled;

import enlightenment.accel.Bvh;
import enlightenment.accel.BvhQuery;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.SpherePrimitive;
import enlightenment.geometry.SupportSurface;
import enlightenment.math.Bounds;
import enlightenment.math.Vec3;

/**
 * Which primitives can stand between a point and a light.
 *
 * <p>For a point P and a light inside a ball, every shadow ray runs inside the cone with apex P around the ball. A
 * primitive whose bounding ball keeps clear of that cone can block none of them. Bounds are conservative: a candidate
 * too many costs a test, one too few would be a wrong picture. See docs/occluders.md.
 *
 * <p>A flat primitive (a wall of the room) blocks none of them if point and light lie on the same side of its plane. That is told
 * by the two alone: whatever else there is in the scene changes nothing.
 */
final class OccluderSet {
    /** What {@link #gather} returns where one ball hides the whole light, so that no ray is needed to know it. */
    static final int ALL_BLOCKED = -1;

    /** By id: centre and radius of a ball around the primitive. */
    private final double[] balls;

    /** By id: whether the primitive is that ball, so that it blocks what the ball blocks. */
    private final boolean[] isBall;

    private final Bvh bvh;

    /** By id: the unit normal and the offset of a flat primitive's plane, or null. */
    private final double[][] planes;

    OccluderSet(Primitive[] primitives, Bvh bvh) {
        this.bvh = bvh;
        balls = new double[4 * primitives.length];
        isBall = new boolean[primitives.length];
        planes = new double[primitives.length][];
        for (int id = 0; id < primitives.length; id++) {
            setBall(primitives[id], id);
            if (primitives[id].support(0) instanceof SupportSurface.Plane p && primitives[id].isFlat()) {
                Vec3 n = p.unitNormal();
                planes[id] = new double[] {n.x(), n.y(), n.z(), n.dot(p.corners()[0])};
            }
        }
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

    /**
     * Collects the primitives that may stand between the cone's apex and the light.
     *
     * @param cone how the light is seen
     * @param starts begins with the ids of primitives that are known not to
     * @param count how many these are
     * @param query receives their ids
     * @return how many there are, or {@link #ALL_BLOCKED}
     */
    int gather(LightCone cone, int[] starts, int count, BvhQuery query) {
        query.clear();
        if (bvh == null) {
            for (int id = 0; id < planes.length; id++) {
                if (!isAmong(id, starts, count) && add(cone, id, query)) {
                    return ALL_BLOCKED;
                }
            }
            return query.size();
        }
        bvh.gather(cone, query);
        int n = query.size();
        query.clear();
        for (int k = 0; k < n; k++) {
            int id = query.get(k);
            if (!isAmong(id, starts, count) && add(cone, id, query)) {
                return ALL_BLOCKED;
            }
        }
        return query.size();
    }

    private static boolean isAmong(int id, int[] starts, int count) {
        for (int k = 0; k < count; k++) {
            if (starts[k] == id) {
                return true;
            }
        }
        return false;
    }

    /** Adds a primitive if it may stand in the way; true if it hides the light wholly. */
    private boolean add(LightCone cone, int id, BvhQuery query) {
        double[] plane = planes[id];
        if (plane != null && cone.staysBeside(plane[0], plane[1], plane[2], plane[3])) {
            return false;
        }
        double cx = balls[4 * id];
        double cy = balls[4 * id + 1];
        double cz = balls[4 * id + 2];
        double radius = balls[4 * id + 3];
        if (cone.misses(cx, cy, cz, radius)) {
            return false;
        }
        if (isBall[id] && cone.isHiddenBy(cx, cy, cz, radius)) {
            return true;
        }
        query.add(id);
        return false;
    }
}
