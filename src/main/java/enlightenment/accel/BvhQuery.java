package enlightenment.accel;

import enlightenment.bvh.FloatShaft;
import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import java.util.Arrays;

/**
 * A growing list of primitive ids, a front, and the scratch memory of a traversal. A mutable work object, one per thread.
 *
 * <p>A <em>front</em> is a cut of a hierarchy: links to nodes and leaves which, with the candidates, contain everything that rays of a cone
 * may hit.
 */
public final class BvhQuery {
    /** A front has at most this many links; a power of two. */
    static final int MAX_FRONT = 16;

    static final int QUEUE_MASK = 2 * MAX_FRONT - 1;

    private int[] ids = new int[64];
    private int size;
    private final int[] kinds;
    private final long[] tests;

    /** The current ray, prepared for box tests. */
    final SlabTest slabs = new SlabTest();

    final FloatSlabs floatSlabs = new FloatSlabs();

    final FloatShaft shaft = new FloatShaft();

    /** The box around the ends of the segments of the current cone: least, then largest coordinates. */
    final double[] ends = new double[ItemBoxes.BOX];

    final UnionNarrowing narrowing = new UnionNarrowing(ends);

    /** The axis of the current cone. */
    final Ray axis = new Ray();

    /** The links that rays start with; expanding one may add one before the size is checked. */
    final int[] front = new int[MAX_FRONT + 1];

    /** Primitives tested before the front. */
    final ConeCandidates candidates = new ConeCandidates();

    /** By place in the front: the ball around a node's box. */
    final ApexBalls frontBalls = new ApexBalls(MAX_FRONT + 1);

    int frontSize;

    /** Nodes to be expanded, a ring buffer. */
    final int[] queue = new int[QUEUE_MASK + 1];

    private final int[] stack = new int[Nodes.MAX_DEPTH + MAX_FRONT + 2];

    /** A box, as scratch. */
    final double[] box = new double[ItemBoxes.BOX];

    /**
     * Makes an empty list.
     *
     * @param kinds by id: the kind of primitive
     * @param tests by kind: counts the tests
     */
    public BvhQuery(int[] kinds, long[] tests) {
        this.kinds = kinds;
        this.tests = tests;
    }

    int[] stack() {
        return stack;
    }

    /** Sets the front to the root of the hierarchy. */
    void startAtRoot() {
        front[0] = 0;
        frontSize = 1;
        frontBalls.setAny(0);
        candidates.close();
        narrowing.end();
    }

    /** Fills the stack with the links of the front whose balls the ray may hit; returns its depth. */
    int pushFront(Ray ray) {
        int depth = 0;
        for (int i = 0; i < frontSize; i++) {
            if (!frontBalls.misses(i, ray) || ray.extreme) {
                stack[depth++] = front[i];
            }
        }
        return depth;
    }

    /** Whether a primitive has a crossing with tMin ≤ t ≤ tMax. */
    public boolean blocks(Primitive p, int id, Ray ray, double tMax) {
        tests[kinds[id]]++;
        return p.blocks(ray, tMax);
    }

    /** Whether any mesh of a union has a crossing with tMin ≤ t ≤ tMax. */
    boolean blocks(MeshUnion union, Ray ray, double tMax) {
        if (!union.suits(ray)) {
            for (int k = 0; k < union.size(); k++) {
                if (blocks(union.member(k), union.id(k), ray, tMax)) {
                    return true;
                }
            }
            return false;
        }
        tests[kinds[union.id(0)]]++;
        return narrowing.blocks(union, ray, tMax);
    }

    /** Empties the list. */
    public void clear() {
        size = 0;
    }

    /** Appends an id. */
    public void add(int id) {
        if (size == ids.length) {
            ids = Arrays.copyOf(ids, 2 * size);
        }
        ids[size++] = id;
    }

    /** The number of ids. */
    public int size() {
        return size;
    }

    /** The id at an index. */
    public int get(int k) {
        return ids[k];
    }
}
