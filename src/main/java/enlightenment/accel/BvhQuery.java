package enlightenment.accel;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import java.util.Arrays;

/** A growing list of primitive ids, and the scratch memory of a traversal. A mutable work object, one per thread. */
public final class BvhQuery {
    private int[] ids = new int[64];
    private int size;
    private final int[] kinds;
    private final long[] tests;

    /** The ray, prepared for boxes. */
    final SlabTest slabs = new SlabTest();

    /**
     * An empty list.
     *
     * @param kinds by id: the kind of primitive
     * @param tests by kind: counts the tests
     */
    public BvhQuery(int[] kinds, long[] tests) {
        this.kinds = kinds;
        this.tests = tests;
    }

    /** Whether a primitive has a crossing with tMin ≤ t ≤ tMax. */
    public boolean blocks(Primitive p, int id, Ray ray, double tMax) {
        tests[kinds[id]]++;
        return p.nearest(ray, tMax) <= tMax;
    }

    /** Empties the list. Its ids can still be read by {@link #get} until they are overwritten. */
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
