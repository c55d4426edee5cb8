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
 * The surfaces that coincide where a ray hits one of them. Surfaces that are the same in a scene's description (the wall of a glass and
 * that of the water in it, a table's top and the cloth on it) differ by a few units in the last place when they are hit; their order is an
 * artefact of rounding, so they are treated as one event. A mutable work object, one per thread.
 */
public final class CoincidentHits {
    private static final int NONE = -1;

    /** Surfaces whose normals have a smaller cosine than this meet in an edge only. */
    private static final double SAME_DIRECTION = 0.5;

    private final Primitive[] primitives;
    private final FaceMaterials materials;
    private final CoincidentSurfaces coincident;

    /** By id: rank of a solid of glass where an overlap belongs to one medium; null in classic shading. */
    private final int[] mediumRank;

    private final Ray probe = new Ray();
    private final Hit own = new Hit();
    private final Hit leftHit = new Hit();
    private final double[] scratch = new double[3];

    /** The pairs of coincident faces that count at the hit. */
    private final IntList near = new IntList();

    private int[] ids = new int[4];
    private Hit[] hits = {new Hit(), new Hit(), new Hit(), new Hit()};
    private int size;

    /** The ids of coincident surfaces that the ray has left at its start, on its way to the first surface. */
    private int[] left = new int[2];

    private int[] leftSides = new int[2];
    private int leftCount;

    /** Whether the ray has left interfaces of solids of glass at its start, on its way to the first surface. */
    private boolean leftGlass;

    /** The last opaque surface that the ray has left at its start, or -1. */
    private int leftOpaque = NONE;

    /**
     * @param isPhysical whether the interface of two media is the same from both sides
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

    /** Finds the surfaces that coincide with a hit; the surface of the hit itself comes first. */
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

    /** Whether a hit is where the ray starts, up to rounding: within this distance of the surface's tangent plane. */
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
     * The coincident opaque surface that the ray has left at its start, or -1: light reflected by the first surface hits it again, as if
     * there were a thin gap between them.
     *
     * @param out receives the hit on it, if there is one
     */
    public int left(Hit out) {
        if (leftOpaque != NONE) {
            out.set(leftHit);
        }
        return leftOpaque;
    }

    /** Whether the ray has left a coincident opaque surface at its start: a ray that stays on its side hits it again at once. */
    public boolean hasLeftOpaque() {
        return leftOpaque != NONE;
    }

    /** Whether the ray has left coincident solids of glass at its start: a ray that stays on its side enters them again at once. */
    public boolean hasLeftGlass() {
        return leftGlass;
    }

    /**
     * Replaces a hit on an opaque surface by that on the coincident surface that is visible.
     *
     * @return the id of the visible primitive
     */
    public int choose(Ray ray, int id, Hit hit) {
        findNear(id, hit);
        if (near.size() == 0 || materials.of(id, hit.face).isGlass) {
            return id;
        }
        find(ray, id, hit, near);
        int best = seen();
        Hit chosen = hits[best];
        // The crossing is the ray's own, to the last bit, as if the other surfaces did not exist.
        if (best > 0) {
            boolean same = primitives[ids[best]].intersect(ray, own) && own.face == chosen.face;
            hit.set(same ? own : chosen);
        }
        return ids[best];
    }

    /** The index of the visible opaque surface; -1 if none is opaque. */
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

    /** Whether the ray starts on the primitive and cannot hit it again. */
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
     * The index of the surface that is the interface of two media. It is that of the only medium with a surface here. If both have one: in
     * physical shading that of the medium that fills overlaps, from either side, so that light paths are reversible and contact is the
     * limit of overlaps; in classic shading that of the medium that is entered. Painted faces do not count: the ray may have been inside of
     * their solid all along, in a part that another medium filled.
     */
    public int boundary(int entered, int left) {
        int of = surfaceOf(entered);
        int other = surfaceOf(left);
        if (of == NONE || other == NONE) {
            return Math.max(Math.max(of, other), 0);
        }
        boolean isOfLeft = mediumRank != null && mediumRank[left] < mediumRank[entered];
        return isOfLeft ? other : of;
    }

    /** The index of the first glass surface of a primitive; -1 if there is none. */
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

    /** The scattering function of surface k at its hit. */
    public Bsdf bsdf(int k) {
        SurfaceMaterial there = material(k);
        while (there.detail != null) {
            there = there.detail.at(hits[k], scratch);
        }
        return there.bsdf;
    }

    /** The hit on surface k; its side is the one that the ray arrives on. */
    public Hit hit(int k) {
        return hits[k];
    }

    /** Whether surface k is of glass. */
    public boolean isGlass(int k) {
        return material(k).isGlass;
    }

    /** Whether surface k is the interface of a solid of glass. */
    public boolean isGlassSolid(int k) {
        return primitives[ids[k]].isSolid() && isGlass(k);
    }

    /** Whether surface k is a thin slab: glass that encloses no volume. */
    public boolean isPane(int k) {
        return !primitives[ids[k]].isSolid() && isGlass(k);
    }

    /** The index of the first thin slab, or -1: of several that coincide one reflects. */
    public int pane() {
        for (int k = 0; k < size; k++) {
            if (isPane(k)) {
                return k;
            }
        }
        return -1;
    }

    /**
     * Starts a ray behind the glass surfaces that it passes, and on the surfaces that it had left before.
     *
     * @param covered whether an opaque surface comes next, so that the ray enters no solid
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
