package enlightenment.world.contact;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.world.material.FaceMaterials;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.IntList;
import java.util.Arrays;

/**
 * The surfaces that coincide where a ray hits one of them. Surfaces that are the same in a scene's description (the wall of a
 * glass and that of the water in it, a table's top and the cloth on it) differ by a few units in the last place when they are
 * hit; which of them comes first means nothing, so they are treated as one event. A mutable work object, one per thread.
 */
public final class CoincidentHits {
    private static final int NONE = -1;

    /** Surfaces whose normals have a smaller cosine than this only meet in an edge. */
    private static final double SAME_DIRECTION = 0.5;

    private final Primitive[] primitives;
    private final FaceMaterials materials;
    private final CoincidentSurfaces coincident;

    /** By id: rank of a solid of glass where overlaps have one medium only; null in classic shading. */
    private final int[] mediumRank;

    private final Ray probe = new Ray();
    private final Hit own = new Hit();
    private final Hit leftHit = new Hit();
    private final double[] scratch = new double[3];

    /** The coincidences that count at a hit. */
    private final IntList near = new IntList();

    private int[] ids = new int[4];
    private Hit[] hits = {new Hit(), new Hit(), new Hit(), new Hit()};
    private int size;

    /** Surfaces in the same place that the ray starts on, so that it is on its way from them to the first surface: by their ids. */
    private int[] left = new int[2];

    private int[] leftSides = new int[2];
    private int leftCount;

    /** Whether the ray starts on borders of solids of glass in the same place, on its way out of them to the first surface. */
    private boolean leftGlass;

    /** The last opaque one of those, or -1. */
    private int leftOpaque = NONE;

    /**
     * No surfaces yet.
     *
     * @param isPhysical whether the border of two media is the same from both sides
     */
    public CoincidentHits(CompiledPrimitives compiled, CoincidentSurfaces coincident, boolean isPhysical) {
        primitives = compiled.primitives();
        materials = compiled.materials();
        mediumRank = isPhysical ? compiled.mediumRank() : null;
        this.coincident = coincident;
    }

    /** Removes all surfaces. */
    public void clear() {
        size = 0;
        leftCount = 0;
        leftGlass = false;
        leftOpaque = NONE;
    }

    /** Finds the surfaces that coincide with a hit; that of the hit itself comes first. */
    public void find(Ray ray, int id, Hit hit) {
        findNear(id, hit);
        find(ray, id, hit, near);
    }

    private void findNear(int id, Hit hit) {
        coincident.near(id, hit.face, hit.px, hit.py, hit.pz, near);
    }

    private void find(Ray ray, int id, Hit hit, IntList near) {
        clear();
        add(id, hit);
        for (int i = 0; i < near.size(); i++) {
            CoincidentFaces pairs = coincident.of(id);
            int k = near.get(i);
            int other = pairs.other(k);
            findOther(ray, other, pairs.otherFace(k), CoincidentFaces.REACH * coincident.tolerance(id, other), hit);
        }
    }

    private void findOther(Ray ray, int other, int face, double reach, Hit hit) {
        Primitive p = primitives[other];
        if (!leaves(ray, p) && !(ray.sideOf(p) != 0 && isAtStart(ray, reach, hit))) {
            probe(other, face, reach, hit);
            return;
        }
        boolean isGlass = materials.of(other, face).isGlass;
        if (isGlass && !p.isSolid()) {
            return;
        }
        int before = size;
        probe(other, face, reach, hit);
        if (size == before) {
            return;
        }
        size = before;
        addLeft(other, ray.sideOf(p), isGlass);
    }

    /** Whether a ray is where it starts, up to rounding: it has not risen above the surface there. */
    private static boolean isAtStart(Ray ray, double reach, Hit hit) {
        double height = (hit.px - ray.ox) * hit.nx + (hit.py - ray.oy) * hit.ny + (hit.pz - ray.oz) * hit.nz;
        return Math.abs(height) <= reach;
    }

    private void addLeft(int id, int side, boolean isGlass) {
        if (leftCount == left.length) {
            left = Arrays.copyOf(left, 2 * leftCount);
            leftSides = Arrays.copyOf(leftSides, 2 * leftCount);
        }
        left[leftCount] = id;
        leftSides[leftCount++] = side;
        if (isGlass) {
            leftGlass = true;
        } else {
            leftOpaque = id;
            hits[size].side = side;
            leftHit.set(hits[size]);
        }
    }

    /**
     * The opaque surface in the same place that the ray starts on, or -1: light that the first surface reflects comes to it again, as if
     * a hair of air were between them.
     *
     * @param out receives where that is, if there is one
     */
    public int left(Hit out) {
        if (leftOpaque != NONE) {
            out.set(leftHit);
        }
        return leftOpaque;
    }

    /** Whether the ray starts on an opaque surface in the same place: what stays on its side comes to that again at once. */
    public boolean hasLeftOpaque() {
        return leftOpaque != NONE;
    }

    /** Whether the ray left solids of glass in the same place: what stays on its side enters them again at once. */
    public boolean hasLeftGlass() {
        return leftGlass;
    }

    /**
     * Replaces a hit on an opaque surface by that on the coincident surface that is seen.
     *
     * @return the id of the primitive that is seen
     */
    public int choose(Ray ray, int id, Hit hit) {
        findNear(id, hit);
        if (near.size() == 0 || materials.of(id, hit.face).isGlass) {
            return id;
        }
        find(ray, id, hit, near);
        int best = seen();
        Hit chosen = hits[best];
        // The ray's own crossing, to the last bit, as if the other surfaces were not there.
        if (best > 0) {
            boolean same = primitives[ids[best]].intersect(ray, own) && own.face == chosen.face;
            hit.set(same ? own : chosen);
        }
        return ids[best];
    }

    /**
     * Which of the opaque surfaces is seen.
     *
     * @return its index, or -1 if none is opaque
     */
    public int seen() {
        int best = -1;
        for (int k = 0; k < size; k++) {
            if (!isGlass(k) && (best < 0 || precedes(k, best))) {
                best = k;
            }
        }
        return best;
    }

    private boolean precedes(int k, int m) {
        Hit h = hits[k];
        Hit o = hits[m];
        return coincident.precedes(ids[k], h.face, h.side, ids[m], o.face, o.side);
    }

    /** Whether the ray starts on the primitive and cannot meet it again. */
    private static boolean leaves(Ray ray, Primitive p) {
        int side = ray.sideOf(p);
        return side == Ray.OUTSIDE && p.isConvex() || side != 0 && p.isFlat();
    }

    private void probe(int id, int face, double reach, Hit hit) {
        Primitive p = primitives[id];
        probe.set(hit.px, hit.py, hit.pz, hit.nx, hit.ny, hit.nz, -reach);
        double t = p.nearest(probe, reach);
        if (t == Primitive.MISS) {
            return;
        }
        int k = makeRoom();
        Hit other = hits[k];
        p.complete(probe, t, other);
        double cosine = other.nx * hit.nx + other.ny * hit.ny + other.nz * hit.nz;
        if (other.face == face && Math.abs(cosine) > SAME_DIRECTION) {
            other.side = cosine > 0 ? hit.side : -hit.side;
            other.t = hit.t;
            ids[k] = id;
            size++;
        }
    }

    private void add(int id, Hit hit) {
        int k = makeRoom();
        ids[k] = id;
        hits[k].set(hit);
        size++;
    }

    private int makeRoom() {
        if (size == ids.length) {
            ids = Arrays.copyOf(ids, 2 * size);
            hits = Arrays.copyOf(hits, 2 * size);
            for (int k = size; k < hits.length; k++) {
                hits[k] = new Hit();
            }
        }
        return size;
    }

    /** The number of surfaces. */
    public int size() {
        return size;
    }

    /**
     * The index of the surface that is the border of two media: that of the medium that has one here; where both do, in physical shading
     * that of the one that fills overlaps, from whichever side the ray comes, so that light has the same way back and contact is the limit
     * of overlaps; in classic shading that of the one that is entered. Painted faces are none: the ray may have been inside of their solid
     * all along, where another medium filled it.
     */
    public int border(int entered, int left) {
        int of = surfaceOf(entered);
        int other = surfaceOf(left);
        if (of == NONE || other == NONE) {
            return Math.max(Math.max(of, other), 0);
        }
        boolean isOfLeft = mediumRank != null && mediumRank[left] < mediumRank[entered];
        return isOfLeft ? other : of;
    }

    /** The first surface of glass of a primitive, or -1. */
    private int surfaceOf(int id) {
        for (int k = 0; k < size; k++) {
            if (ids[k] == id && isGlass(k)) {
                return k;
            }
        }
        return NONE;
    }

    /** The id of the primitive that surface k belongs to. */
    public int id(int k) {
        return ids[k];
    }

    /** The material of surface k. */
    public SurfaceMaterial material(int k) {
        return materials.of(ids[k], hits[k].face);
    }

    /** How surface k scatters light where the ray meets it. */
    public Bsdf bsdf(int k) {
        SurfaceMaterial there = material(k);
        while (there.detail != null) {
            there = there.detail.at(hits[k], scratch);
        }
        return there.bsdf;
    }

    /** Where the ray meets surface k; its side is the one that the ray arrives on. */
    public Hit hit(int k) {
        return hits[k];
    }

    /** Whether surface k is one of glass. */
    public boolean isGlass(int k) {
        return material(k).isGlass;
    }

    /** Whether it is the border of a solid of glass. */
    public boolean isGlassSolid(int k) {
        return primitives[ids[k]].isSolid() && isGlass(k);
    }

    /** Whether it is a pane: glass that encloses no volume. */
    public boolean isPane(int k) {
        return !primitives[ids[k]].isSolid() && isGlass(k);
    }

    /** The first pane among the surfaces, or -1: of several that coincide one reflects. */
    public int pane() {
        for (int k = 0; k < size; k++) {
            if (isPane(k)) {
                return k;
            }
        }
        return -1;
    }

    /**
     * Starts a ray that passes the surfaces on those of glass, behind them, and on the surfaces that it had left before.
     *
     * @param covered whether it passes no further than to an opaque surface, so that it enters no solid
     */
    public void startBehind(Ray ray, boolean covered) {
        for (int k = 0; k < size; k++) {
            Primitive p = primitives[ids[k]];
            boolean isEntered = isGlassSolid(k) && hits[k].side == Ray.OUTSIDE;
            if (p != ray.start && isGlass(k) && !(covered && isEntered)) {
                ray.alsoFrom(hits[k], -hits[k].side);
            }
        }
        for (int k = 0; k < leftCount; k++) {
            ray.alsoFrom(primitives[left[k]], leftSides[k]);
        }
    }

    /** Starts a ray that leaves one of the surfaces, on the side that it came from, on all others. */
    public void startOn(Ray ray) {
        for (int k = 0; k < size; k++) {
            Primitive p = primitives[ids[k]];
            if (p != ray.start) {
                ray.alsoFrom(hits[k], hits[k].side);
            }
        }
    }
}
