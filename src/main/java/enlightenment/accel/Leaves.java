package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Ray;

/**
 * The content of a hierarchy's leaves, in the order of the leaves: a leaf is a range of places. All hierarchies of a scene use one class of
 * leaves, so that calls are monomorphic.
 */
abstract class Leaves {
    /** Offers the primitives at the places from..to−1. */
    abstract void offer(Ray ray, int from, int to, Closest state);

    /** Whether any primitive at the places from..to−1 has a crossing with tMin ≤ t ≤ tMax. */
    abstract boolean block(Ray ray, int from, int to, double tMax, BvhQuery query);

    /** The strongest verdict on the places from..to−1. */
    abstract int judge(int from, int to, ConeJudge judge);

    /**
     * The strongest verdict on the places from..to−1; if the leaves are primitives, those that may block are added to the query's
     * candidates instead, and the verdict is {@link ConeJudge#CLEAR}.
     */
    int gather(int from, int to, ConeJudge judge, BvhQuery query) {
        return judge(from, to, judge);
    }

    /** Whether a primitive at the places from..to−1 blocks every segment of the cone. */
    abstract boolean blocksAll(BallCone cone, int from, int to, ConeJudge judge, BvhQuery query);

    /** Adds the ids at the places from..to−1. */
    abstract void collect(Bounds box, int from, int to, BvhQuery query);

    /** The meshes with a common hierarchy, or null. */
    abstract MeshUnion union();

    /** The box of the content of a place. */
    abstract Bounds bounds(int place);
}
