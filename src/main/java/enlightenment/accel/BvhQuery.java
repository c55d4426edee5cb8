package enlightenment.accel;

import java.util.Arrays;

/** A growing list of primitive ids, and the stack of a traversal. A mutable work object, one per thread. */
public final class BvhQuery {
    private int[] ids = new int[64];
    private int size;

    final int[] stack = new int[Bvh.MAX_DEPTH + 1];

    /** Forgets all ids. Those that were there can still be read by {@link #get} until they are overwritten. */
    public void clear() {
        size = 0;
    }

    public void add(int id) {
        if (size == ids.length) {
            ids = Arrays.copyOf(ids, 2 * size);
        }
        ids[size++] = id;
    }

    public int size() {
        return size;
    }

    public int get(int k) {
        return ids[k];
    }
}
