package enlightenment.accel;

import enlightenment.bvh.BvhBuilder;
import enlightenment.bvh.FloatShaft;
import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.Nodes;
import enlightenment.frame.BallCone;
import enlightenment.primitive.Ray;

/**
 * A hierarchy with boxes of floats, rounded outwards: 56 bytes for two children. Numbers of a node: the centre's x of the left child and
 * of the right one, y of both, z, then the half extents likewise.
 */
final class FloatBvh extends Bvh {
    /**
     * With fewer rays than this, fewer links are expanded: it costs more than it saves. Measured on one flake of spheres and tried on no
     * other scene; has no influence on any result.
     */
    private static final int MANY_RAYS = 12;

    private static final int FRONT_OF_FEW_RAYS = 8;

    private final float[] boxes;

    FloatBvh(BvhBuilder builder, Leaves leaves) {
        super(builder.child(), leaves, builder.reach());
        boxes = builder.floats();
    }

    @Override
    double entry(SlabTest slabs, int node, int side, double limit) {
        return slabs.entry(boxes, Nodes.NODE * node + side, limit);
    }

    @Override
    double bound(int node, int side, boolean upper, int axis) {
        int k = Nodes.NODE * node + 2 * axis + side;
        return upper ? (double) boxes[k] + boxes[k + 6] : (double) boxes[k] - boxes[k + 6];
    }

    @Override
    public void search(Ray ray, Closest state) {
        if (!isFor(state.floatSlabs, ray)) {
            super.search(ray, state);
            return;
        }
        follow(ray, state);
    }

    private boolean isFor(FloatSlabs slabs, Ray ray) {
        return slabs.set(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.dd, ray.tMin, reach);
    }

    /** Traverses from the root. */
    private void follow(Ray ray, Closest state) {
        FloatSlabs slabs = state.floatSlabs;
        int[] stack = state.stack;
        int[] entries = state.floatEntries;
        int limit = FloatSlabs.limit(state.t());
        int depth = 1;
        stack[0] = 0;
        entries[0] = 0;
        while (depth > 0) {
            // A box entered exactly at the closest crossing may contain one that wins the tie.
            if (entries[--depth] > limit) {
                continue;
            }
            int node = stack[depth];
            while (node >= 0) {
                int l = slabs.entry(boxes, Nodes.NODE * node, limit);
                int r = slabs.entry(boxes, Nodes.NODE * node + 1, limit);
                int nearer = l <= r ? 0 : 1;
                int link = 2 * node;
                node = child[link + nearer];
                if (Math.max(l, r) < FloatSlabs.MISS) {
                    entries[depth] = Math.max(l, r);
                    stack[depth++] = child[link + 1 - nearer];
                } else if (Math.min(l, r) == FloatSlabs.MISS) {
                    node = Nodes.EMPTY;
                }
            }
            if (node != Nodes.EMPTY) {
                leaves.offer(ray, Nodes.first(node), Nodes.end(node), state);
                limit = FloatSlabs.limit(state.t());
            }
        }
    }

    @Override
    public boolean occludedWithin(Ray ray, double tMax, BvhQuery query) {
        if (query.candidates.block(ray, tMax, query)) {
            return true;
        }
        int depth = query.pushFront(ray);
        if (depth == 0) {
            return false;
        }
        FloatSlabs slabs = query.floatSlabs;
        if (!isFor(slabs, ray)) {
            return super.occludedWithin(ray, tMax, query);
        }
        int limit = FloatSlabs.limit(tMax);
        int[] stack = query.stack();
        int node = stack[--depth];
        while (true) {
            if (node < 0) {
                if (leaves.block(ray, Nodes.first(node), Nodes.end(node), tMax, query)) {
                    return true;
                }
            } else {
                boolean l = slabs.entry(boxes, Nodes.NODE * node, limit) < FloatSlabs.MISS;
                boolean r = slabs.entry(boxes, Nodes.NODE * node + 1, limit) < FloatSlabs.MISS;
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
     * Expands nodes breadth first until the number of pending links pays for the number of rays, {@link ConeCandidates#MAX} primitives are
     * found or no node is left. Primitives of leaves that the judge does not clear become candidates; the remaining nodes are tested last,
     * each first by the ball around its box.
     */
    @Override
    public int narrow(BallCone cone, ConeJudge judge, int rays, BvhQuery query) {
        if (rays < 2) {
            return super.narrow(cone, judge, rays, query);
        }
        FloatShaft shaft = query.shaft;
        cone.findEnds(query.ends);
        if (!shaft.set(cone.x, cone.y, cone.z, query.ends, reach)) {
            return super.narrow(cone, judge, rays, query);
        }
        query.narrowing.begin(cone, rays);
        int most = rays < MANY_RAYS ? FRONT_OF_FEW_RAYS : BvhQuery.MAX_FRONT;
        int[] queue = query.queue;
        int[] front = query.front;
        int kept = 0;
        query.candidates.start(cone);
        query.frontBalls.startAt(cone);
        int head = 0;
        int tail = 1;
        queue[0] = 0;
        while (head != tail && tail - head + kept < most && query.candidates.size() < ConeCandidates.MAX) {
            int node = head == 0 ? 0 : child[queue[head & BvhQuery.QUEUE_MASK]];
            head++;
            for (int side = 0; side < 2; side++) {
                if (!shaft.meets(boxes, Nodes.NODE * node + side)) {
                    continue;
                }
                int link = child[2 * node + side];
                if (link >= 0) {
                    queue[tail++ & BvhQuery.QUEUE_MASK] = 2 * node + side;
                    continue;
                }
                int verdict = leaves.gather(Nodes.first(link), Nodes.end(link), judge, query);
                if (verdict == ConeJudge.BLOCKS_ALL) {
                    return BLOCKED;
                }
                if (verdict == ConeJudge.MAY_BLOCK) {
                    query.frontBalls.setAny(kept);
                    front[kept++] = link;
                }
            }
        }
        while (head != tail) {
            int slot = queue[head++ & BvhQuery.QUEUE_MASK];
            setBall(query.frontBalls, kept, slot);
            front[kept++] = child[slot];
        }
        query.frontSize = kept;
        return kept + query.candidates.size();
    }

    /** Sets the ball around a box, widened by more than the roundings here. */
    private void setBall(ApexBalls balls, int k, int slot) {
        int at = Nodes.NODE * (slot >> 1) + (slot & 1);
        double hx = boxes[at + 6];
        double hy = boxes[at + 8];
        double hz = boxes[at + 10];
        balls.set(k, boxes[at], boxes[at + 2], boxes[at + 4], hx * hx + hy * hy + hz * hz);
    }
}
