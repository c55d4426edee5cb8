package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Leaves of primitives; a union of meshes takes one place. */
final class PrimitiveLeaves extends Leaves {
    /** By place: the primitive; null for the union. */
    private final Primitive[] primitives;

    private final int[] ids;
    private final MeshUnion union;

    /**
     * @param all the scene's primitives
     * @param items by item: the id
     * @param union the item after those, or null
     * @param order by place: the item
     */
    PrimitiveLeaves(Primitive[] all, int[] items, MeshUnion union, int[] order) {
        this.union = union;
        ids = new int[order.length];
        primitives = new Primitive[order.length];
        for (int i = 0; i < order.length; i++) {
            if (order[i] < items.length) {
                ids[i] = items[order[i]];
                primitives[i] = all[ids[i]];
            }
        }
    }

    @Override
    void offer(Ray ray, int from, int to, Closest state) {
        for (int i = from; i < to; i++) {
            if (primitives[i] == null) {
                state.offer(ray, union);
            } else {
                state.offer(ray, primitives[i], ids[i]);
            }
        }
    }

    @Override
    boolean block(Ray ray, int from, int to, double tMax, BvhQuery query) {
        for (int i = from; i < to; i++) {
            if (primitives[i] == null) {
                if (query.blocks(union, ray, tMax)) {
                    return true;
                }
            } else if (query.blocks(primitives[i], ids[i], ray, tMax)) {
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
            int verdict = primitives[i] == null ? judge(judge) : judge.judge(ids[i]);
            if (verdict == ConeJudge.BLOCKS_ALL) {
                return verdict;
            }
            strongest |= verdict;
        }
        return strongest;
    }

    /** The verdict on the union: that of the first member that is not clear; no mesh blocks everything. */
    private int judge(ConeJudge judge) {
        for (int k = 0; k < union.size(); k++) {
            int verdict = judge.judge(union.id(k));
            if (verdict != ConeJudge.CLEAR) {
                return verdict;
            }
        }
        return ConeJudge.CLEAR;
    }

    /** The union is not judged, but narrowed where that pays: judging all its members would take longer than a ray. */
    @Override
    int gather(int from, int to, ConeJudge judge, BvhQuery query) {
        int left = ConeJudge.CLEAR;
        for (int i = from; i < to; i++) {
            if (primitives[i] == null) {
                if (!query.narrowing.clears(union)) {
                    left = ConeJudge.MAY_BLOCK;
                }
                continue;
            }
            int verdict = judge.judge(ids[i]);
            if (verdict == ConeJudge.BLOCKS_ALL) {
                return verdict;
            }
            if (verdict == ConeJudge.MAY_BLOCK) {
                query.candidates.add(primitives[i], ids[i]);
            }
        }
        return left;
    }

    @Override
    boolean blocksAll(BallCone cone, int from, int to, ConeJudge judge, BvhQuery query) {
        for (int i = from; i < to; i++) {
            if (primitives[i] != null && judge.judge(ids[i]) == ConeJudge.BLOCKS_ALL) {
                return true;
            }
        }
        return false;
    }

    @Override
    void collect(Bounds box, int from, int to, BvhQuery query) {
        for (int i = from; i < to; i++) {
            if (primitives[i] == null) {
                for (int k = 0; k < union.size(); k++) {
                    if (union.member(k).bounds().overlaps(box)) {
                        query.add(union.id(k));
                    }
                }
            } else {
                query.add(ids[i]);
            }
        }
    }

    @Override
    MeshUnion union() {
        return union;
    }

    @Override
    Bounds bounds(int place) {
        return primitives[place] == null ? union.bounds() : primitives[place].bounds();
    }
}
