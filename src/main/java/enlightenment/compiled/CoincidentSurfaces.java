package enlightenment.compiled;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SupportSurface;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Which faces of a scene coincide, and which of two coincident faces is seen.
 *
 * <p>Whether two faces coincide is decided once, when the scene is compiled, by their support surfaces: never by the t of two
 * crossings, whose last bits are noise. Faces coincide if their surfaces are no farther apart than rounding can move copies of
 * the same surface; if they are farther apart, there is a gap.
 *
 * <p>What is seen (docs/geometry.md): of opaque faces in the same place one that glows to the side where one looks from; else the one of
 * smaller {@linkplain SupportSurface#extent extent}, so that a carpet shows on the floor and a poster on the wall; at equal extents, the
 * first in alphabetical order of material. An opaque face hides one of glass.
 */
public final class CoincidentSurfaces {
    /**
     * Bounds the distance of two placed copies of the same surface, in units of the largest coordinate: hit points are within 8
     * units in the last place (16 times the unit roundoff) of it, so are corners, and a radius may be off by another ulp.
     */
    private static final double SAME_PLACE = Scale.gamma(64);

    private static final int[] NONE = {};

    /** Numbers per entry: this primitive's face, the other primitive, that one's face. */
    static final int ENTRY = 3;

    /** Numbers per box. */
    private static final int BOX = 6;

    private final CompiledPrimitives compiled;

    /** By id: entries of the faces that coincide with its own, in no order; null as a whole if there are none. */
    private int[][] entries;

    /** By id: for each entry, how far apart the two surfaces may be. */
    private double[][] tolerances;

    /** By id: for each entry, a box outside of which no point of this surface has the other one within {@link CoincidentHits#REACH}. */
    private double[][] places;

    /** By id: the rank of each face, the lowest is seen of those that glow to the viewer, or do not; null where nothing coincides. */
    private int[][] order;

    private CoincidentSurfaces(CompiledPrimitives compiled) {
        this.compiled = compiled;
    }

    /** @param poll called now and then; ends this by what it throws */
    static CoincidentSurfaces of(CompiledPrimitives compiled, Accelerator accelerator, Runnable poll) {
        CoincidentSurfaces result = new CoincidentSurfaces(compiled);
        result.new Finder(accelerator, poll).find();
        return result;
    }

    /** The tolerance for surfaces of primitives that lie within these boxes. */
    static double tolerance(Bounds a, Bounds b) {
        return tolerance(a.maxAbs(), b.maxAbs());
    }

    /** The same for boxes of these largest absolute coordinates. */
    static double tolerance(double reachA, double reachB) {
        return SAME_PLACE * Math.max(reachA, reachB);
    }

    /** Whether any face of the primitive coincides with another primitive's. */
    public boolean concerns(int id) {
        return entries != null && entries[id] != null;
    }

    /** Whether a face of a primitive coincides with one of another. */
    boolean coincide(int id, int face, int other, int otherFace) {
        int[] all = of(id);
        for (int k = 0; k < all.length; k += ENTRY) {
            if (all[k] == face && all[k + 1] == other && all[k + 2] == otherFace) {
                return true;
            }
        }
        return false;
    }

    /** For each coincidence of the primitive, three numbers: its face, the other primitive, that one's face. */
    int[] of(int id) {
        return concerns(id) ? entries[id] : NONE;
    }

    /** For each coincidence of the primitive, how far apart the two surfaces may be: a length in the frame. */
    double[] tolerancesOf(int id) {
        return tolerances[id];
    }

    /** Whether the entry k of a primitive counts at a point of it: false if that certainly is away from the other surface. */
    boolean isNear(int id, int k, double x, double y, double z) {
        double[] p = places[id];
        int at = BOX * k;
        return x >= p[at] && x <= p[at + 3] && y >= p[at + 1] && y <= p[at + 4] && z >= p[at + 2] && z <= p[at + 5];
    }

    /**
     * Whether the first of two coincident opaque faces is seen rather than the second, by who sees these sides of them: one from outside, or
     * of an open shape, before the inside of a solid; then one that glows to its side.
     */
    boolean precedes(int id, int face, int side, int other, int otherFace, int otherSide) {
        boolean inside = isInside(id, side);
        if (inside != isInside(other, otherSide)) {
            return !inside;
        }
        boolean glows = glows(id, face, side);
        if (glows != glows(other, otherFace, otherSide)) {
            return glows;
        }
        return rank(id, face) < rank(other, otherFace);
    }

    private boolean isInside(int id, int side) {
        return side == Ray.INSIDE && compiled.primitives()[id].isSolid();
    }

    private boolean glows(int id, int face, int side) {
        SurfaceMaterial m = compiled.materials().of(id, face);
        return m.glows && m.glowsTo(side);
    }

    private int rank(int id, int face) {
        return order == null || order[id] == null ? 0 : order[id][face];
    }

    /** Finds the pairs. */
    private final class Finder {
        private final Primitive[] primitives = compiled.primitives();
        private final Accelerator accelerator;
        private final Runnable poll;
        private final SupportSurface[][] supports = new SupportSurface[primitives.length][];

        Finder(Accelerator accelerator, Runnable poll) {
            this.accelerator = accelerator;
            this.poll = poll;
        }

        private Bounds bounds(int id) {
            return primitives[id].bounds();
        }

        void find() {
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
            if (entries != null) {
                rank();
            }
        }

        private void poll(int i) {
            if (SceneCompiler.isPolled(i)) {
                poll.run();
            }
        }

        /** Whole surfaces coincide only if their centres do: a sweep along x. */
        private void findWhole(int[] ids) {
            double[] x = new double[ids.length];
            double[] reach = new double[ids.length];
            for (int i = 0; i < ids.length; i++) {
                Bounds box = bounds(ids[i]);
                x[i] = box.center().x();
                reach[i] = box.maxAbs();
            }
            int[] order = Ascending.order(x);
            for (int i = 0; i < order.length; i++) {
                poll(i);
                int a = order[i];
                for (int k = i + 1; k < order.length; k++) {
                    int b = order[k];
                    // Twice the tolerance, because the boxes' centres are rounded once more.
                    if (x[b] - x[a] > 2 * tolerance(reach[a], reach[b])) {
                        break;
                    }
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
                accelerator.overlapping(widened(box, tolerance(box, box)), query);
                for (int k = 0; k < query.size(); k++) {
                    int other = query.get(k);
                    if (primitives[other].isWhole()) {
                        continue;
                    }
                    if (other > id) {
                        compare(id, other);
                    } else if (other < id && !isReached(other, box)) {
                        compare(other, id);
                    }
                }
            }
        }

        /**
         * Whether the box is within the primitive's own tolerance. If not, its search may have missed what lies there, since that may
         * reach farther: then both are compared when the other one searches.
         */
        private boolean isReached(int id, Bounds box) {
            Bounds own = bounds(id);
            return widened(own, tolerance(own, own)).overlaps(box);
        }

        private void compare(int a, int b) {
            Bounds box = bounds(a);
            Bounds other = bounds(b);
            double tolerance = tolerance(box, other);
            if (!widened(box, tolerance).overlaps(other)) {
                return;
            }
            SupportSurface[] p = supports(a);
            SupportSurface[] q = supports(b);
            for (int i = 0; i < p.length; i++) {
                for (int k = 0; k < q.length; k++) {
                    if (p[i].coincides(q[k], tolerance) && p[i].overlaps(q[k], tolerance)) {
                        add(a, i, b, k, tolerance);
                        add(b, k, a, i, tolerance);
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

        private void add(int id, int face, int other, int otherFace, double tolerance) {
            if (entries == null) {
                entries = new int[primitives.length][];
                tolerances = new double[primitives.length][];
                places = new double[primitives.length][];
            }
            double[] known = tolerances[id] == null ? new double[0] : tolerances[id];
            tolerances[id] = Arrays.copyOf(known, known.length + 1);
            tolerances[id][known.length] = tolerance;
            addPlace(id, known.length, bounds(other), tolerance);
            int[] old = of(id);
            int[] now = Arrays.copyOf(old, old.length + ENTRY);
            now[old.length] = face;
            now[old.length + 1] = other;
            now[old.length + 2] = otherFace;
            entries[id] = now;
        }

        /** Twice the reach of the search: for the roundings of hit points and of boxes. */
        private void addPlace(int id, int k, Bounds other, double tolerance) {
            Bounds box = widened(other, 2 * CoincidentHits.REACH * tolerance);
            places[id] = Arrays.copyOf(k == 0 ? new double[0] : places[id], BOX * (k + 1));
            for (int c = 0; c < 3; c++) {
                places[id][BOX * k + c] = box.min().component(c);
                places[id][BOX * k + 3 + c] = box.max().component(c);
            }
        }

        private void rank() {
            List<Face> faces = new ArrayList<>();
            for (int id = 0; id < entries.length; id++) {
                for (int face = 0; concerns(id) && face < primitives[id].faceCount(); face++) {
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
                double same = Face.ROUNDINGS * tolerance(bounds(f.id), bounds(f.id));
                size += f.extent - last > same ? 1 : 0;
                last = f.extent;
                f.size = size;
            }
            faces.sort(Face.SEEN_FIRST);
            order = new int[primitives.length][];
            for (int k = 0; k < faces.size(); k++) {
                Face f = faces.get(k);
                if (order[f.id] == null) {
                    order[f.id] = new int[primitives[f.id].faceCount()];
                }
                order[f.id][f.face] = k;
            }
        }
    }

    /** The box with every face moved outwards. */
    static Bounds widened(Bounds box, double by) {
        Vec3 d = new Vec3(by, by, by);
        return new Bounds(box.min().minus(d), box.max().plus(d));
    }

    private static final class Face {
        /** Bounds the roundings accumulated in an extent, in tolerances. */
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
