package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.primitive.Ray;

/**
 * A hierarchy with boxes of floats, rounded outwards: 56 bytes for two children. Numbers of a node: lower x of the left child and of the
 * right one, lower y of both, lower z, upper x, upper y, upper z.
 */
final class FloatBvh extends Bvh {
    private final float[] boxes;

    FloatBvh(BvhBuilder builder, Leaves leaves) {
        super(builder.child(), leaves, builder.reach());
        boxes = builder.floats();
    }

    @Override
    double entry(SlabTest slabs, int node, int side, double limit) {
        return slabs.entry(boxes, NODE * node + side, limit);
    }

    @Override
    double bound(int node, int side, boolean upper, int axis) {
        return boxes[NODE * node + (upper ? 6 : 0) + 2 * axis + side];
    }

    @Override
    public void search(Ray ray, Closest state) {
        FloatSlabs slabs = state.floatSlabs;
        if (!slabs.set(ray, reach)) {
            super.search(ray, state);
            return;
        }
        int[] stack = state.stack;
        int[] entries = state.floatEntries;
        int limit = FloatSlabs.limit(state.t());
        int depth = 0;
        int node = 0;
        while (true) {
            if (node < 0) {
                leaves.offer(ray, first(node), end(node), state);
                limit = FloatSlabs.limit(state.t());
            } else {
                int l = slabs.entry(boxes, NODE * node, limit);
                int r = slabs.entry(boxes, NODE * node + 1, limit);
                int nearer = l <= r ? 0 : 1;
                int later = Math.max(l, r);
                int link = 2 * node;
                if (later < FloatSlabs.MISS) {
                    entries[depth] = later;
                    stack[depth++] = child[link + 1 - nearer];
                    node = child[link + nearer];
                    continue;
                }
                if (Math.min(l, r) < FloatSlabs.MISS) {
                    node = child[link + nearer];
                    continue;
                }
            }
            // A box entered exactly where the best crossing lies may hold one that wins the tie.
            do {
                if (depth == 0) {
                    return;
                }
            } while (entries[--depth] > limit);
            node = stack[depth];
        }
    }

    @Override
    public boolean occludedWithin(Ray ray, double tMax, BvhQuery query) {
        FloatSlabs slabs = query.floatSlabs;
        if (!slabs.set(ray, reach)) {
            return super.occludedWithin(ray, tMax, query);
        }
        int limit = FloatSlabs.limit(tMax);
        int[] stack = query.stack();
        int depth = query.pushFront();
        int node = stack[--depth];
        while (true) {
            if (node < 0) {
                if (leaves.block(ray, first(node), end(node), tMax, query)) {
                    return true;
                }
            } else {
                boolean l = slabs.entry(boxes, NODE * node, limit) < FloatSlabs.MISS;
                boolean r = slabs.entry(boxes, NODE * node + 1, limit) < FloatSlabs.MISS;
                int link = 2 * node;
                if (l) {
                    if (r) {
                        stack[depth++] = child[link + 1];
                    }
                    node = child[link];
                    continue;
                }
                if (r) {
                    node = child[link + 1];
                    continue;
                }
            }
            if (depth == 0) {
                return false;
            }
            node = stack[--depth];
        }
    }

    /**
     * Opens nodes breadth first until {@link BvhQuery#MAX_FRONT} links are pending or none can be opened; leaves stay if the judge
     * lets one of their primitives pass.
     */
    @Override
    public int narrow(BallCone cone, ConeJudge judge, int rays, BvhQuery query) {
        FloatShaft shaft = query.shaft;
        if (rays < 2 || !shaft.set(cone, reach)) {
            return super.narrow(cone, judge, rays, query);
        }
        int[] queue = query.queue;
        int[] front = query.front;
        int kept = 0;
        int head = 0;
        int tail = 1;
        queue[0] = 0;
        while (head != tail && tail - head + kept < BvhQuery.MAX_FRONT) {
            int node = queue[head++ & BvhQuery.QUEUE_MASK];
            for (int side = 0; side < 2; side++) {
                if (!shaft.meets(boxes, NODE * node + side)) {
                    continue;
                }
                int link = child[2 * node + side];
                if (link >= 0) {
                    queue[tail++ & BvhQuery.QUEUE_MASK] = link;
                    continue;
                }
                int verdict = leaves.judge(first(link), end(link), judge);
                if (verdict == ConeJudge.BLOCKS_ALL) {
                    return BLOCKED;
                }
                if (verdict == ConeJudge.MAY_BLOCK) {
                    front[kept++] = link;
                }
            }
        }
        while (head != tail) {
            front[kept++] = queue[head++ & BvhQuery.QUEUE_MASK];
        }
        query.frontSize = kept;
        return kept;
    }
}
