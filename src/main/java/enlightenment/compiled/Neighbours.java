package enlightenment.compiled;

import enlightenment.math.Bounds;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;

/** By primitive: which others it may touch, as far as glass is concerned. */
final class Neighbours {
    static final int[] NONE = {};

    /** How far boxes are widened, in units of the largest coordinate: more than two surfaces' roundings together. */
    private static final double WIDER = Scale.gamma(128);

    private final Bounds[] bounds;
    private final int[][] ids;

    private Neighbours(int count) {
        bounds = new Bounds[count];
        ids = new int[count][];
    }

    /** The neighbours in a scene, or null if nothing in it is glass. */
    static Neighbours of(CompiledScene scene) {
        int count = scene.primitives.length;
        List<Integer> glass = new ArrayList<>();
        for (int id = 0; id < count; id++) {
            if (scene.isGlass(id)) {
                glass.add(id);
            }
        }
        if (glass.isEmpty()) {
            return null;
        }
        Neighbours result = new Neighbours(count);
        for (int id = 0; id < count; id++) {
            result.bounds[id] = widened(scene.primitives[id].bounds());
        }
        for (int id = 0; id < count; id++) {
            result.ids[id] = scene.isGlass(id) ? result.overlapping(id) : result.overlapping(id, glass);
        }
        return result;
    }

    private static Bounds widened(Bounds box) {
        double by = WIDER * box.maxAbs();
        return Bounds.around(box.center(), box.extent().times(0.5).plus(new Vec3(by, by, by)));
    }

    private int[] overlapping(int id) {
        List<Integer> all = new ArrayList<>();
        for (int other = 0; other < bounds.length; other++) {
            all.add(other);
        }
        return overlapping(id, all);
    }

    private int[] overlapping(int id, List<Integer> candidates) {
        return candidates.stream()
                .mapToInt(Integer::intValue)
                .filter(other -> other != id && bounds[other].overlaps(bounds[id]))
                .toArray();
    }

    /** A box around a primitive, a little wider than it. */
    Bounds bounds(int id) {
        return bounds[id];
    }

    /** Ascending ids. */
    int[] of(int id) {
        return ids[id];
    }
}
