package enlightenment.accel;

import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.Nodes;
import enlightenment.primitive.Hit;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/**
 * The closest crossing so far, with the one rule for ties: at equal t a crossing that leaves a solid comes before one that enters, then the
 * lower id wins. So the result does not depend on the order of tests. A mutable work object, one per thread.
 */
public final class Closest {
    private double t;
    private int id;
    private int element;
    private Primitive primitive;
    private final int[] kinds;
    private final long[] tests;

    private final Hit scratch = new Hit();

    /** The current ray, prepared for box tests. */
    final SlabTest slabs = new SlabTest();

    final FloatSlabs floatSlabs = new FloatSlabs();

    /** The traversal stack of a search: links to follow later. */
    final int[] stack = new int[Nodes.MAX_DEPTH];

    /** By place on the stack: the t at which the ray enters the box. */
    final double[] entries = new double[Nodes.MAX_DEPTH];

    /** By place on the stack: the t at which the ray enters the box, as bits of a float. */
    final int[] floatEntries = new int[Nodes.MAX_DEPTH];

    /**
     * Makes a search, to be {@link #reset} before use.
     *
     * @param kinds by id: the kind of primitive
     * @param tests by kind: counts the tests
     */
    public Closest(int[] kinds, long[] tests) {
        this.kinds = kinds;
        this.tests = tests;
    }

    /** Starts a search for crossings with t up to this limit. */
    public void reset(double limit) {
        t = limit;
        id = -1;
        primitive = null;
    }

    /** Tests a primitive and keeps its crossing if it is the closest. */
    public void offer(Ray ray, Primitive p, int candidate) {
        tests[kinds[candidate]]++;
        offerCounted(ray, p, candidate);
    }

    /** Tests a union of meshes and keeps its crossing if it is the closest. */
    void offer(Ray ray, MeshUnion union) {
        if (!union.suits(ray)) {
            for (int k = 0; k < union.size(); k++) {
                offer(ray, union.member(k), union.id(k));
            }
            return;
        }
        tests[kinds[union.id(0)]]++;
        double s = union.nearest(ray, t);
        if (s <= t) {
            take(ray, union.member(ray.member), union.id(ray.member), s);
        }
    }

    /** Counts tests of primitives of a kind. */
    void count(int kind, int number) {
        tests[kind] += number;
    }

    /** As {@link #offer}, for callers that count tests themselves. */
    void offerCounted(Ray ray, Primitive p, int candidate) {
        take(ray, p, candidate, p.nearest(ray, t));
    }

    /** Keeps a crossing of a primitive, if it is the closest. */
    void take(Ray ray, Primitive p, int candidate, double s) {
        if (s < t || s == t && wins(ray, p, candidate)) {
            t = s;
            id = candidate;
            element = ray.element;
            primitive = p;
        }
    }

    private boolean wins(Ray ray, Primitive p, int candidate) {
        if (primitive == null) {
            return true;
        }
        int own = ray.element;
        boolean leaves = leaves(ray, p);
        ray.element = element;
        boolean known = leaves(ray, primitive);
        ray.element = own;
        return leaves == known ? candidate < id : leaves;
    }

    private boolean leaves(Ray ray, Primitive p) {
        p.complete(ray, t, scratch);
        return scratch.side == Ray.INSIDE;
    }

    /** Fills the hit at the closest crossing, if there is one. */
    public void complete(Ray ray, Hit hit) {
        ray.element = element;
        primitive.complete(ray, t, hit);
    }

    /** The t of the closest crossing, or the limit. */
    public double t() {
        return t;
    }

    /** The id of the primitive with the closest crossing, or -1. */
    public int id() {
        return id;
    }
}
