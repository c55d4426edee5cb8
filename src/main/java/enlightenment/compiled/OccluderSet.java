package enlightenment.compiled;

import enlightenment.accel.Bvh;
import enlightenment.accel.BvhQuery;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.RectanglePrimitive;
import enlightenment.geometry.SpherePrimitive;
import enlightenment.math.Bounds;
import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * Which primitives can stand between a point and a light.
 *
 * <p>For a point P and a light inside a ball, every shadow ray runs inside the cone with apex P around the ball. A
 * primitive whose bounding ball keeps clear of that cone can block none of them. Bounds are conservative: a candidate
 * too many costs a test, one too few would be a wrong picture. See docs/occluders.md.
 *
 * <p>A rectangle that has everything on one side (a wall of the room) can never stand between two things in the room and
 * is left out from the start.
 */
final class OccluderSet {
    /** What {@link #gather} returns where one ball hides the whole light, so that no ray is needed to know it. */
    static final int ALL_BLOCKED = -1;

    private final int[] ids;

    /** By id: centre and radius of a ball around the primitive; radius −1 for a wall. */
    private final double[] balls;

    /** By id: whether the primitive is that ball, so that it blocks what the ball blocks. */
    private final boolean[] isBall;

    private final Bvh bvh;

    OccluderSet(Primitive[] primitives, CompiledLight[] lights, Bvh bvh) {
        this.bvh = bvh;
        Bounds everything = everything(primitives, lights);
        int[] candidates = new int[primitives.length];
        balls = new double[4 * primitives.length];
        isBall = new boolean[primitives.length];
        int n = 0;
        for (int id = 0; id < primitives.length; id++) {
            setBall(primitives[id], id);
            if (isWall(primitives[id], everything)) {
                balls[4 * id + 3] = -1;
            } else {
                candidates[n++] = id;
            }
        }
        ids = Arrays.copyOf(candidates, n);
    }

    private static Bounds everything(Primitive[] primitives, CompiledLight[] lights) {
        Bounds all = null;
        for (Primitive p : primitives) {
            all = all == null ? p.bounds() : all.union(p.bounds());
        }
        for (CompiledLight light : lights) {
            all = all == null ? light.bounds() : all.union(light.bounds());
        }
        return all;
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

    /** Whether a rectangle parallel to two axes has everything on one side or in its plane. */
    private static boolean isWall(Primitive p, Bounds everything) {
        if (!(p instanceof RectanglePrimitive)) {
            return false;
        }
        Bounds box = p.bounds();
        for (int axis = 0; axis < 3; axis++) {
            double at = box.min().component(axis);
            boolean flat = box.max().component(axis) == at;
            boolean outermost =
                    everything.min().component(axis) >= at || everything.max().component(axis) <= at;
            if (flat && outermost) {
                return true;
            }
        }
        return false;
    }

    /** The number of primitives that are no walls. */
    int size() {
        return ids.length;
    }

    /**
     * Collects the primitives that may stand between the cone's apex and the light.
     *
     * @param cone how the light is seen
     * @param self a primitive that is known not to, or -1
     * @param query receives their ids
     * @return how many there are, or {@link #ALL_BLOCKED}
     */
    int gather(LightCone cone, int self, BvhQuery query) {
        query.clear();
        if (bvh == null) {
            for (int id : ids) {
                if (id != self && add(cone, id, query)) {
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
            if (id != self && balls[4 * id + 3] >= 0 && add(cone, id, query)) {
                return ALL_BLOCKED;
            }
        }
        return query.size();
    }

    /** Adds a primitive if it may stand in the way; true if it hides the light wholly. */
    private boolean add(LightCone cone, int id, BvhQuery query) {
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
