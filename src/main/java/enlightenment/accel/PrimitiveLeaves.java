package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Leaves of primitives. */
final class PrimitiveLeaves extends Leaves {
    private final Primitive[] primitives;
    private final int[] ids;

    PrimitiveLeaves(Primitive[] original, int[] ids) {
        this.ids = ids;
        primitives = new Primitive[original.length];
        for (int i = 0; i < primitives.length; i++) {
            primitives[i] = original[ids[i]];
        }
    }

    @Override
    void offer(Ray ray, int from, int to, Closest state) {
        for (int i = from; i < to; i++) {
            state.offer(ray, primitives[i], ids[i]);
        }
    }

    @Override
    boolean block(Ray ray, int from, int to, double tMax, BvhQuery query) {
        for (int i = from; i < to; i++) {
            if (query.blocks(primitives[i], ids[i], ray, tMax)) {
                return true;
            }
        }
        return false;
    }

    @Override
    int judge(int from, int to, ConeJudge judge) {
        int strongest = ConeJudge.CLEAR;
        for (int i = from; i < to; i++) {
            int verdict = judge.judge(ids[i]);
            if (verdict == ConeJudge.BLOCKS_ALL) {
                return verdict;
            }
            strongest |= verdict;
        }
        return strongest;
    }

    @Override
    boolean blocksAll(BallCone cone, int from, int to, ConeJudge judge, BvhQuery query) {
        return judge(from, to, judge) == ConeJudge.BLOCKS_ALL;
    }

    @Override
    void collect(Bounds box, int from, int to, BvhQuery query) {
        for (int i = from; i < to; i++) {
            query.add(ids[i]);
        }
    }

    @Override
    Bounds bounds(int place) {
        return primitives[place].bounds();
    }
}
