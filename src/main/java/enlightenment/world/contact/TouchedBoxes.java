package enlightenment.world.contact;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import java.util.Arrays;

/**
 * Finds primitives that a light may lie on, by their boxes. A mesh that glows is as many lights as it has triangles: looking at each
 * primitive for each of them would take a time that goes by the square of their number. A mutable work object, one per thread.
 */
public final class TouchedBoxes {
    private final Primitive[] primitives;
    private final Accelerator accelerator;
    private final BvhQuery query;

    /** The largest absolute coordinate of any primitive's box, or more. */
    private final double reach;

    private int[] ids = new int[64];

    /**
     * For a scene.
     *
     * @param kind by id: the kind of primitive
     * @param kinds how many kinds there are
     * @param accelerator of these primitives
     */
    public TouchedBoxes(Primitive[] primitives, int[] kind, int kinds, Accelerator accelerator) {
        this.primitives = primitives;
        this.accelerator = accelerator;
        query = new BvhQuery(kind, new long[kinds]);
        reach = accelerator.bounds().maxAbs();
    }

    /** A primitive by its id. */
    public Primitive primitive(int id) {
        return primitives[id];
    }

    /**
     * Finds the primitives whose boxes overlap a light's box widened by {@link CoincidentSurfaces#tolerance} of the two; some others may
     * be among them.
     *
     * @return how many there are: the first of {@link #ids}
     */
    public int find(Bounds light) {
        query.clear();
        // The tolerance goes by the larger of the two boxes' coordinates: none is larger than with all of them.
        double most = CoincidentSurfaces.tolerance(light.maxAbs(), reach);
        accelerator.overlapping(CoincidentSurfaces.widened(light, most), query);
        int n = query.size();
        if (ids.length < n) {
            ids = new int[2 * n];
        }
        for (int k = 0; k < n; k++) {
            ids[k] = query.get(k);
        }
        Arrays.sort(ids, 0, n);
        return n;
    }

    /** What was found, in ascending order, then anything; not to be changed. */
    public int[] ids() {
        return ids;
    }
}
