package enlightenment.world.contact;

import enlightenment.accel.Accelerator;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SupportSurface;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.IntList;

/**
 * The faces of a scene that coincide, and which of two coincident faces is visible.
 *
 * <p>Coincidence is decided once, when the scene is compiled, by the faces' support surfaces, never by the t of two crossings, whose last
 * bits are noise. Faces coincide if their surfaces are no farther apart than rounding can move copies of the same surface; if they are
 * farther apart, there is a gap.
 *
 * <p>The visible face (docs/notes/geometry.md) is, of opaque faces in the same place, one that emits towards the viewer; else the one of
 * smaller {@linkplain SupportSurface#extent extent}, so that a carpet shows on the floor and a poster on the wall; at equal extents, the
 * first in alphabetical order of material. An opaque face hides one of glass.
 */
public final class CoincidentSurfaces {
    /**
     * Bounds the distance of two placed copies of the same surface, in units of the largest coordinate: hit points are within 8
     * units in the last place (16 times the unit roundoff) of it, so are corners, and a radius may be off by another ulp.
     */
    private static final double SAME_PLACE = Scale.gamma(64);

    private final CompiledPrimitives compiled;

    /** By id: the faces that coincide with those of a primitive, null where there are none; null as a whole if nothing coincides. */
    private final CoincidentFaces[] faces;

    /**
     * By id: the rank of each face; the lowest is visible among those that emit to the viewer, or among those that do not; null where
     * nothing coincides.
     */
    private final int[][] order;

    private CoincidentSurfaces(CompiledPrimitives compiled, CoincidentFaces[] faces, int[][] order) {
        this.compiled = compiled;
        this.faces = faces;
        this.order = order;
    }

    /**
     * Finds the coincident faces of a scene.
     *
     * @param poll called regularly; what it throws ends this
     */
    public static CoincidentSurfaces of(CompiledPrimitives compiled, Accelerator accelerator, Runnable poll) {
        CoincidenceFinder finder = new CoincidenceFinder(compiled, accelerator, poll);
        CoincidentFaces[] faces = finder.find();
        return new CoincidentSurfaces(compiled, faces, faces == null ? null : finder.ranks());
    }

    /** The largest distance of coincident surfaces of primitives within these boxes, in the frame. */
    public static double tolerance(Bounds a, Bounds b) {
        return tolerance(a.maxAbs(), b.maxAbs());
    }

    /** The largest distance of coincident surfaces of primitives, in the frame, given the largest absolute coordinates of their boxes. */
    public static double tolerance(double reachA, double reachB) {
        return SAME_PLACE * Math.max(reachA, reachB);
    }

    /** Whether any face of the primitive coincides with another primitive's. */
    public boolean concerns(int id) {
        return faces != null && faces[id] != null;
    }

    /** Whether a face of the primitive coincides with another primitive's. */
    public boolean concerns(int id, int face) {
        return concerns(id) && faces[id].has(face);
    }

    /** Whether a face of a primitive coincides with one of another. */
    public boolean coincide(int id, int face, int other, int otherFace) {
        if (!concerns(id) || !concerns(other)) {
            return false;
        }
        // Both have the pair: the shorter list is searched, as one may be a floor under everything.
        return faces[id].size() <= faces[other].size()
                ? faces[id].has(face, other, otherFace)
                : faces[other].has(otherFace, id, face);
    }

    /** The faces that coincide with those of a primitive; null if there are none. */
    public CoincidentFaces of(int id) {
        return faces == null ? null : faces[id];
    }

    /** The largest distance of coincident surfaces of two primitives, in the frame. */
    public double tolerance(int id, int other) {
        return faces[id].tolerance(faces[other]);
    }

    /**
     * Finds the coincidences of a face of a primitive that count at a point of it.
     *
     * @param out is cleared and receives their numbers among {@linkplain #of those of the primitive}, in ascending order
     */
    void near(int id, int face, double x, double y, double z, IntList out) {
        if (concerns(id)) {
            faces[id].near(face, x, y, z, faces, out);
        } else {
            out.clear();
        }
    }

    /**
     * The places where faces of a primitive coincide with others: seven numbers each, the face and the least and the greatest coordinates
     * of a box. Empty where nothing coincides; null where there are too many to test one by one.
     */
    public double[] boxes(int id) {
        return concerns(id) ? faces[id].boxes() : new double[0];
    }

    /**
     * Whether the first of two coincident opaque faces hides the second, given the sides that are seen: the outside of a solid or an open
     * shape comes before the inside of a solid; then a face that emits to its side.
     */
    public boolean precedes(int id, int face, int side, int other, int otherFace, int otherSide) {
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

    /** The box with every face moved outwards. */
    public static Bounds widened(Bounds box, double by) {
        Vec3 d = new Vec3(by, by, by);
        return new Bounds(box.min().minus(d), box.max().plus(d));
    }
}
