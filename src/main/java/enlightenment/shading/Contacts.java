package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.geometry.Hit;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * The surfaces that lie in one another where a ray hits one of them. Surfaces that are the same in a scene's description
 * (the wall of a glass and that of the water in it) differ by a few units in the last place when they are hit; which of
 * them is hit first means nothing, so they are treated as one.
 */
final class Contacts {
    /**
     * Bounds the distance of two hit points on the same surface, in units of the largest coordinate: each is within 8
     * units in the last place (16 times the unit roundoff) of it, and so is a radius that is written with an ulp more.
     */
    private static final double SAME_PLACE = Scale.gamma(64);

    /** Cosine of the angle beyond which two surfaces merely meet in an edge. */
    private static final double SAME_DIRECTION = 0.5;

    private final CompiledScene scene;
    private final Ray probe = new Ray();
    private int[] ids = new int[4];
    private Hit[] hits = {new Hit(), new Hit(), new Hit(), new Hit()};
    private int size;

    Contacts(CompiledScene scene) {
        this.scene = scene;
    }

    /** Finds what coincides with a hit: that primitive comes first. */
    void find(Ray ray, int id, Hit hit) {
        size = 0;
        add(id, hit);
        Vec3 point = hit.point();
        for (int other : scene.neighboursOf(id)) {
            if (scene.boundsOf(other).contains(point) && !leaves(ray, scene.primitives[other])) {
                probe(other, hit);
            }
        }
    }

    /** Whether the ray has just left the primitive for good. */
    private static boolean leaves(Ray ray, Primitive p) {
        int side = ray.sideOf(p);
        return side == Ray.OUTSIDE && p.isConvex() || side != 0 && !p.isSolid();
    }

    private void probe(int id, Hit hit) {
        Primitive p = scene.primitives[id];
        double magnitude = Math.max(
                Math.max(Math.abs(hit.px), Math.max(Math.abs(hit.py), Math.abs(hit.pz))),
                scene.boundsOf(id).maxAbs());
        double reach = SAME_PLACE * magnitude;
        probe.set(hit.px, hit.py, hit.pz, hit.nx, hit.ny, hit.nz, -reach);
        double t = p.nearest(probe, reach);
        if (t == Primitive.MISS) {
            return;
        }
        int k = makeRoom();
        Hit other = hits[k];
        p.complete(probe, t, other);
        double cosine = other.nx * hit.nx + other.ny * hit.ny + other.nz * hit.nz;
        if (Math.abs(cosine) > SAME_DIRECTION) {
            other.side = cosine > 0 ? hit.side : -hit.side;
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

    int size() {
        return size;
    }

    int id(int k) {
        return ids[k];
    }

    /** Where the ray meets that surface: its side is the one that the ray arrives on. */
    Hit hit(int k) {
        return hits[k];
    }
}
