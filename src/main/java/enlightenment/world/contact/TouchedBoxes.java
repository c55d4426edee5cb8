package enlightenment.world.contact;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import java.util.Arrays;

/**
 * Finds primitives that a light may lie on, by their boxes. An emitting mesh is as many lights as it has triangles: testing each primitive
 * for each of them would take quadratic time. A mutable work object, one per thread.
 */
public final class TouchedBoxes {
    private final Primitive[] primitives;
    private final Accelerator accelerator;
    private final BvhQuery query;

    /** An upper bound of the absolute coordinates of all primitives' boxes. */
    private final double reach;

    private int[] ids = new int[64];

    /**
     * @param kind by id: the kind of primitive
     * @param kinds the number of kinds
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
     * Finds the primitives whose boxes overlap a light's box widened by {@link CoincidentSurfaces#tolerance} of the two; the result may
     * contain others.
     *
     * @return their number: the first of {@link #ids}
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

    /** The ids found, in ascending order; further elements are undefined. Not to be changed. */
    public int[] ids() {
        return ids;
    }
}
