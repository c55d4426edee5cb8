package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Leaves of primitives. */
final class PrimitiveLeaves extends Leaves {
    private final Primitive[] primitives;
    private final int[] ids;

    /**
     * @param original the primitives
     * @param order by place: an index into them
     * @param ids by place: the id
     */
    PrimitiveLeaves(Primitive[] original, int[] order, int[] ids) {
        this.ids = ids;
        primitives = new Primitive[original.length];
        for (int i = 0; i < primitives.length; i++) {
            primitives[i] = original[order[i]];
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
                query.candidates.addBlocker(primitives[i], ids[i]);
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
    int gather(int from, int to, ConeJudge judge, BvhQuery query) {
        for (int i = from; i < to; i++) {
            int verdict = judge.judge(ids[i]);
            if (verdict == ConeJudge.BLOCKS_ALL) {
                return verdict;
            }
            if (verdict == ConeJudge.MAY_BLOCK) {
                query.candidates.add(primitives[i], ids[i]);
            }
        }
        return ConeJudge.CLEAR;
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
