package enlightenment.world.contact;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SupportSurface;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.Ascending;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.CompiledPrimitives;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** Finds the pairs of faces that coincide, once, when a scene is compiled: {@link CoincidentSurfaces}. */
final class CoincidenceFinder {
    private final CompiledPrimitives compiled;
    private final Primitive[] primitives;
    private final Accelerator accelerator;
    private final Runnable poll;
    private final SupportSurface[][] supports;

    /** The number of pairs examined since the last poll: there may be many more pairs than primitives. */
    private int looked;

    /** By id; null as a whole until the first pair is found. */
    private CoincidentFaces[] found;

    /**
     * @param poll called regularly; what it throws ends this
     */
    CoincidenceFinder(CompiledPrimitives compiled, Accelerator accelerator, Runnable poll) {
        this.compiled = compiled;
        this.accelerator = accelerator;
        this.poll = poll;
        primitives = compiled.primitives();
        supports = new SupportSurface[primitives.length][];
    }

    /** Finds the pairs. By id: the faces that coincide with those of a primitive, or null; null as a whole if there are none. */
    CoincidentFaces[] find() {
        int[] whole = new int[primitives.length];
        int[] others = new int[primitives.length];
        int n = 0;
        for (int id = 0; id < primitives.length; id++) {
            if (primitives[id].isWhole()) {
                whole[n++] = id;
            } else {
                others[id - n] = id;
            }
        }
        findWhole(Arrays.copyOf(whole, n));
        findByBoxes(Arrays.copyOf(others, others.length - n));
        for (int id = 0; found != null && id < found.length; id++) {
            if (found[id] != null) {
                pollPairs(found[id].size());
                found[id].end(found, this::isInterfaceOfGlass);
            }
        }
        return found;
    }

    private boolean isInterfaceOfGlass(int id, int face) {
        return compiled.materials().of(id, face).isGlass && primitives[id].isSolid();
    }

    private Bounds bounds(int id) {
        return primitives[id].bounds();
    }

    /** Polls at this primitive, counted from 0 by the caller, if a check is due. */
    private void poll(int primitive) {
        if (CancellationCheck.isDue(primitive)) {
            poll.run();
        }
    }

    private void pollPair() {
        pollPairs(1);
    }

    private void pollPairs(int pairs) {
        looked += pairs;
        if (looked >= CancellationCheck.INTERVAL) {
            looked %= CancellationCheck.INTERVAL;
            poll.run();
        }
    }

    /** Compares whole surfaces, which coincide only if their centres and their sizes do. */
    private void findWhole(int[] ids) {
        for (int i = 0; i < ids.length; i++) {
            poll(i);
        }
        // Twice the tolerance: boxes' centres are rounded once more, a torus's size is the sum of two radii.
        // And once for the rounded ends of the intervals.
        new CloseGroups(
                        this::margin,
                        this::pollPair,
                        this::sweep,
                        id -> bounds(id).center().x(),
                        id -> bounds(id).center().y(),
                        id -> bounds(id).center().z(),
                        id -> primitives[id].support(0).extent())
                .part(ids);
    }

    private double margin(int id) {
        Bounds box = bounds(id);
        return 3 * CoincidentSurfaces.tolerance(box, box);
    }

    /** Compares those whose boxes overlap along x. */
    private void sweep(int[] ids) {
        double[] x = new double[ids.length];
        double[] reach = new double[ids.length];
        for (int i = 0; i < ids.length; i++) {
            Bounds box = bounds(ids[i]);
            x[i] = box.center().x();
            reach[i] = box.maxAbs();
        }
        int[] order = Ascending.order(x);
        for (int i = 0; i < order.length; i++) {
            int a = order[i];
            for (int k = i + 1; k < order.length; k++) {
                int b = order[k];
                // Twice the tolerance, because the boxes' centres are rounded once more.
                if (x[b] - x[a] > 2 * CoincidentSurfaces.tolerance(reach[a], reach[b])) {
                    break;
                }
                pollPair();
                compare(ids[a], ids[b]);
            }
        }
    }

    private void findByBoxes(int[] ids) {
        BvhQuery query =
                new BvhQuery(compiled.kind(), new long[compiled.kindNames().size()]);
        for (int i = 0; i < ids.length; i++) {
            poll(i);
            int id = ids[i];
            Bounds box = bounds(id);
            query.clear();
            accelerator.overlapping(CoincidentSurfaces.widened(box, CoincidentSurfaces.tolerance(box, box)), query);
            for (int k = 0; k < query.size(); k++) {
                int other = query.get(k);
                if (other == id || primitives[other].isWhole()) {
                    continue;
                }
                pollPair();
                if (other > id) {
                    compare(id, other);
                } else if (other < id && !isReached(other, box)) {
                    compare(other, id);
                }
            }
        }
    }

    /**
     * Whether the box is within the primitive's own tolerance. If not, this primitive's search may miss it, since the other's tolerance is
     * larger: both are then compared in the other's search.
     */
    private boolean isReached(int id, Bounds box) {
        Bounds own = bounds(id);
        return CoincidentSurfaces.widened(own, CoincidentSurfaces.tolerance(own, own))
                .overlaps(box);
    }

    private void compare(int a, int b) {
        Bounds box = bounds(a);
        Bounds other = bounds(b);
        double tolerance = CoincidentSurfaces.tolerance(box, other);
        if (!CoincidentSurfaces.widened(box, tolerance).overlaps(other)) {
            return;
        }
        SupportSurface[] p = supports(a);
        SupportSurface[] q = supports(b);
        for (int i = 0; i < p.length; i++) {
            for (int k = 0; k < q.length; k++) {
                if (p[i].coincides(q[k], tolerance) && p[i].overlaps(q[k], tolerance)) {
                    add(a, i, b, k);
                    add(b, k, a, i);
                }
            }
        }
    }

    private SupportSurface[] supports(int id) {
        if (supports[id] == null) {
            SupportSurface[] all = new SupportSurface[primitives[id].faceCount()];
            for (int face = 0; face < all.length; face++) {
                all[face] = primitives[id].support(face);
            }
            supports[id] = all;
        }
        return supports[id];
    }

    private void add(int id, int face, int other, int otherFace) {
        if (found == null) {
            found = new CoincidentFaces[primitives.length];
        }
        if (found[id] == null) {
            found[id] = new CoincidentFaces(bounds(id));
        }
        found[id].add(face, other, otherFace);
    }

    /** By id: the rank of each face, the lowest being visible; null where nothing coincides. */
    int[][] ranks() {
        List<Face> faces = new ArrayList<>();
        for (int id = 0; id < found.length; id++) {
            for (int face = 0; found[id] != null && face < primitives[id].faceCount(); face++) {
                faces.add(new Face(
                        id,
                        face,
                        supports(id)[face].extent(),
                        compiled.materials().of(id, face)));
            }
        }
        faces.sort(Comparator.comparingDouble(f -> f.extent));
        int size = 0;
        double last = 0;
        for (Face f : faces) {
            // Extents that differ only by rounding are equal: a chain of them is one size.
            double same = Face.ROUNDINGS * CoincidentSurfaces.tolerance(bounds(f.id), bounds(f.id));
            size += f.extent - last > same ? 1 : 0;
            last = f.extent;
            f.size = size;
        }
        faces.sort(Face.SEEN_FIRST);
        int[][] order = new int[primitives.length][];
        for (int k = 0; k < faces.size(); k++) {
            Face f = faces.get(k);
            if (order[f.id] == null) {
                order[f.id] = new int[primitives[f.id].faceCount()];
            }
            order[f.id][f.face] = k;
        }
        return order;
    }

    private static final class Face {
        /** A bound of the roundings accumulated in an extent, in tolerances. */
        static final int ROUNDINGS = 16;

        static final Comparator<Face> SEEN_FIRST = Comparator.<Face, Boolean>comparing(f -> f.isGlass)
                .thenComparingInt(f -> f.size)
                .thenComparing(f -> f.appearance)
                .thenComparingInt(f -> f.id)
                .thenComparingInt(f -> f.face);

        final int id;
        final int face;
        final double extent;
        final boolean isGlass;
        final String appearance;
        int size;

        Face(int id, int face, double extent, SurfaceMaterial material) {
            this.id = id;
            this.face = face;
            this.extent = extent;
            isGlass = material.isGlass;
            appearance = material.appearance();
        }
    }
}
