package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Ray;

/** Leaves of accelerators. Each is searched with scratch memory of its own, because the outer search is not at its end. */
final class NestedLeaves extends Leaves {
    private final Accelerator[] parts;

    NestedLeaves(Accelerator[] original, int[] order) {
        parts = new Accelerator[original.length];
        for (int i = 0; i < parts.length; i++) {
            parts[i] = original[order[i]];
        }
    }

    @Override
    void offer(Ray ray, int from, int to, Closest state) {
        Closest inner = state.inner();
        for (int i = from; i < to; i++) {
            inner.continueFrom(state);
            parts[i].search(ray, inner);
            state.continueFrom(inner);
        }
    }

    @Override
    boolean block(Ray ray, int from, int to, double tMax, BvhQuery query) {
        BvhQuery inner = query.inner();
        for (int i = from; i < to; i++) {
            if (parts[i].occluded(ray, tMax, inner)) {
                return true;
            }
        }
        return false;
    }

    /** Parts are not looked into: rays decide. */
    @Override
    int judge(int from, int to, ConeJudge judge) {
        return to > from ? ConeJudge.MAY_BLOCK : ConeJudge.CLEAR;
    }

    @Override
    boolean blocksAll(BallCone cone, int from, int to, ConeJudge judge, BvhQuery query) {
        BvhQuery inner = query.inner();
        for (int i = from; i < to; i++) {
            if (parts[i].blocksAll(cone, judge, inner)) {
                return true;
            }
        }
        return false;
    }

    @Override
    void collect(Bounds box, int from, int to, BvhQuery query) {
        for (int i = from; i < to; i++) {
            parts[i].overlapping(box, query);
        }
    }

    @Override
    Bounds bounds(int place) {
        return parts[place].bounds();
    }
}
