package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Ray;

/**
 * Ray queries on a set of primitives. Whatever the structure, the results are those of a loop over all primitives, bit for bit. Immutable,
 * safe for any number of threads, each with its own {@link Closest} and {@link BvhQuery}; a {@link PrimitiveList} that is refilled belongs
 * to one thread.
 */
public interface Accelerator extends RaySearch {
    /** The result of {@link #narrow} if one primitive blocks every segment. */
    int BLOCKED = -1;

    /**
     * Finds the closest crossing with t at least {@link Ray#tMin}.
     *
     * @return the id of the primitive, or -1; t is in the state
     */
    default int closest(Ray ray, Closest state) {
        state.reset(Double.MAX_VALUE);
        search(ray, state);
        return state.id();
    }

    /** Whether any primitive has a crossing with tMin ≤ t ≤ tMax. */
    boolean occluded(Ray ray, double tMax, BvhQuery query);

    /**
     * Prepares {@link #occludedWithin} for rays from the cone's apex to its ball.
     *
     * @param cone of the rays
     * @param judge returns the verdict on single primitives
     * @param rays roughly the number of rays to come: for few of them a search may not pay
     * @param query receives the remaining candidates
     * @return 0 if the judge cleared all primitives, {@link #BLOCKED} if one was found to block everything; else a positive number: rays
     *     must be tested. A primitive that blocks everything may then still exist
     */
    int narrow(BallCone cone, ConeJudge judge, int rays, BvhQuery query);

    /** As {@link #occluded}, for a ray from the apex of the cone that the query was narrowed to by {@link #narrow}, to its ball. */
    boolean occludedWithin(Ray ray, double tMax, BvhQuery query);

    /** The meshes with a common hierarchy; null if each has its own. */
    default MeshUnion union() {
        return null;
    }

    /** Adds the ids of primitives to the query's list, among them all whose boxes overlap a box. */
    void overlapping(Bounds box, BvhQuery query);

    /** A box around all primitives. */
    Bounds bounds();
}
