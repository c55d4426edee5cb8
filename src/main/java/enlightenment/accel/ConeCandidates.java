package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;

/**
 * Primitives that may block rays from the apex of a cone; the one that blocked a ray is tested first for the next. A mutable work object,
 * one per thread.
 */
final class ConeCandidates {
    /** The number of candidates at which the search for more ends. */
    static final int MAX = 16;

    /** The capacity: a visit to a node adds at most two leaves; and blockers found later are added. */
    private static final int CAPACITY = MAX + 32;

    private final Primitive[] primitives = new Primitive[CAPACITY];
    private final int[] ids = new int[CAPACITY];
    private final ApexBalls balls = new ApexBalls(CAPACITY);
    private boolean open;
    private int size;

    /** Empties the list, for rays from a cone's apex. */
    void start(BallCone cone) {
        size = 0;
        open = true;
        balls.startAt(cone);
    }

    /** Empties the list and keeps it empty until the next start. */
    void close() {
        size = 0;
        open = false;
    }

    int size() {
        return size;
    }

    void add(Primitive p, int id) {
        primitives[size] = p;
        ids[size] = id;
        if (p instanceof SpherePrimitive s) {
            balls.set(size, s.x(), s.y(), s.z(), s.radius() * s.radius());
        } else {
            balls.setAny(size);
        }
        size++;
    }

    /** Adds a primitive that was found to block a ray. */
    void addBlocker(Primitive p, int id) {
        if (open && size < CAPACITY) {
            add(p, id);
            toFront(size - 1);
        }
    }

    /** Whether a candidate has a crossing with tMin ≤ t ≤ tMax. The ray starts at the apex. */
    boolean block(Ray ray, double tMax, BvhQuery query) {
        for (int k = 0; k < size; k++) {
            Primitive p = primitives[k];
            // A ray that starts on a primitive may cross it beside its line, by rounding.
            if (balls.misses(k, ray) && !ray.extreme && ray.sideOf(p) == 0) {
                continue;
            }
            if (query.blocks(p, ids[k], ray, tMax)) {
                toFront(k);
                return true;
            }
        }
        return false;
    }

    private void toFront(int k) {
        if (k == 0) {
            return;
        }
        Primitive p = primitives[k];
        primitives[k] = primitives[0];
        primitives[0] = p;
        int id = ids[k];
        ids[k] = ids[0];
        ids[0] = id;
        balls.swap(k, 0);
    }
}
