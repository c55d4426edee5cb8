package enlightenment.accel;

import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Ray;
import java.util.function.ToDoubleFunction;

/**
 * A cut of a hierarchy, below which lies all that certain rays may meet: they need not start at the root. A mutable work object, one per
 * thread.
 */
public final class BoxFront implements RaySearch {
    /** At most so many boxes. */
    static final int MAX = 8;

    private final Bvh bvh;

    /** Children of nodes, nearest first: 2n + s is side s of node n. */
    final int[] slots = new int[MAX + 1];

    int size;
    private final double[] depths = new double[MAX + 1];

    /** A front to be {@link #set} before use. */
    public BoxFront(Bvh bvh) {
        this.bvh = bvh;
    }

    /**
     * Opens the boxes that the rays may meet, the nearest first, as long as there are few.
     *
     * @param depth how far along the rays a box is, in any unit; infinite if none of them meets it
     */
    public void set(ToDoubleFunction<Bounds> depth) {
        size = 0;
        open(0, depth);
        int k = 0;
        while (k < size && size < MAX) {
            int link = bvh.child[slots[k]];
            if (link < 0) {
                k++;
                continue;
            }
            remove(k);
            open(link, depth);
            k = 0;
        }
    }

    private void remove(int k) {
        size--;
        for (int i = k; i < size; i++) {
            slots[i] = slots[i + 1];
            depths[i] = depths[i + 1];
        }
    }

    private void open(int node, ToDoubleFunction<Bounds> depth) {
        for (int slot = 2 * node; slot < 2 * node + 2; slot++) {
            double d = depth.applyAsDouble(bvh.box(slot));
            if (bvh.child[slot] == Nodes.EMPTY || d == Double.POSITIVE_INFINITY) {
                continue;
            }
            int i = size++;
            for (; i > 0 && depths[i - 1] > d; i--) {
                slots[i] = slots[i - 1];
                depths[i] = depths[i - 1];
            }
            slots[i] = slot;
            depths[i] = d;
        }
    }

    @Override
    public void search(Ray ray, Closest state) {
        bvh.search(ray, state, this);
    }
}
