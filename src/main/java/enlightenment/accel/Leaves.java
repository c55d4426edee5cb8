package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Ray;

/**
 * What the leaves of a hierarchy hold, in the order of the leaves: a leaf is a range of places. A scene's hierarchies have leaves of
 * one class, so that the calls cost nothing.
 */
abstract class Leaves {
    /** Offers what lies at the places from..to−1. */
    abstract void offer(Ray ray, int from, int to, Closest state);

    /** Whether anything at the places from..to−1 has a crossing with tMin ≤ t ≤ tMax. */
    abstract boolean block(Ray ray, int from, int to, double tMax, BvhQuery query);

    /** The strongest verdict on the places from..to−1. */
    abstract int judge(int from, int to, ConeJudge judge);

    /**
     * The strongest verdict on the places from..to−1; but those that may block are added to the query's candidates if the leaves are
     * primitives, and then the verdict is {@link ConeJudge#CLEAR}.
     */
    int gather(int from, int to, ConeJudge judge, BvhQuery query) {
        return judge(from, to, judge);
    }

    /** Whether something at the places from..to−1 blocks every segment of the cone. */
    abstract boolean blocksAll(BallCone cone, int from, int to, ConeJudge judge, BvhQuery query);

    /** Adds the ids at the places from..to−1. */
    abstract void collect(Bounds box, int from, int to, BvhQuery query);

    /** The meshes that are searched together, or null. */
    abstract MeshUnion union();

    /** The box of what lies at a place. */
    abstract Bounds bounds(int place);
}
