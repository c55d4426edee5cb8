package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * The faces that a light lies on: a lamp in the plane of a ceiling, a bulb on a wall. A shadow ray that ends on the light ends on
 * them too, and they do not occlude it there, just as the surface it starts on does not: whether rounding puts their crossing
 * before the light or behind it means nothing. A crossing anywhere else occludes. Faces are added while a scene is compiled;
 * later it is read only.
 */
public final class EndFaces {
    private Primitive[] primitives = {};
    private int[] ids = {};
    private int[] faces = {};
    private boolean[] isFlat = {};
    private double[] tolerances = {};

    /** No faces yet. */
    public EndFaces() {}

    /**
     * Adds a face while a scene is compiled.
     *
     * @param primitive the face's primitive
     * @param id its number
     * @param face which of its faces
     * @param tolerance bounds the distance between face and light that rounding may cause: a length in the frame
     */
    public void add(Primitive primitive, int id, int face, double tolerance) {
        int n = ids.length;
        primitives = Arrays.copyOf(primitives, n + 1);
        ids = Arrays.copyOf(ids, n + 1);
        faces = Arrays.copyOf(faces, n + 1);
        isFlat = Arrays.copyOf(isFlat, n + 1);
        tolerances = Arrays.copyOf(tolerances, n + 1);
        primitives[n] = primitive;
        ids[n] = id;
        faces[n] = face;
        isFlat[n] = primitive.support(face).isFlat();
        tolerances[n] = tolerance;
    }

    /** Whether there are none. */
    public boolean isEmpty() {
        return ids.length == 0;
    }

    /** Whether a face of a primitive is one of these. */
    public boolean has(int id, int face) {
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == id && faces[k] == face) {
                return true;
            }
        }
        return false;
    }

    /**
     * Lets a ray that leaves the light start on these faces as well.
     *
     * @param side the side of the light's own surface that it travels on
     */
    public void startOn(Ray ray, int side) {
        for (int k = 0; k < ids.length; k++) {
            int there = side;
            if (primitives[k].support(faces[k]) instanceof SupportSurface.Plane plane) {
                Vec3 n = plane.unitNormal();
                there = n.x() * ray.dx + n.y() * ray.dy + n.z() * ray.dz > 0 ? Ray.OUTSIDE : Ray.INSIDE;
            }
            ray.alsoFrom(primitives[k], there);
        }
    }

    /** Whether any face of the primitive is one of these. */
    boolean concerns(Primitive p) {
        for (Primitive q : primitives) {
            if (q == p) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a crossing is the end of the segment rather than an occluder.
     *
     * @param ray the segment's ray, which ends at {@link Ray#tEnd}
     * @param hit the crossing, completed
     */
    boolean isEnd(Ray ray, Hit hit) {
        for (int k = 0; k < faces.length; k++) {
            if (primitives[k] == hit.primitive && faces[k] == hit.face) {
                return isEnd(k, ray, hit, ray.tEnd - hit.t);
            }
        }
        return false;
    }

    private boolean isEnd(int k, Ray ray, Hit hit, double left) {
        // A line meets a plane once, and this one in the light; it may meet a curved face earlier as well.
        double across = Math.abs(hit.nx * ray.dx + hit.ny * ray.dy + hit.nz * ray.dz);
        return isFlat[k] || left * across <= tolerances[k];
    }

    /**
     * Whether a hit is where a ray that goes to the light ends.
     *
     * @param id the number of the primitive that it hits
     * @param left how far behind the hit the light is, in lengths of the ray's direction
     */
    public boolean isEnd(Ray ray, int id, Hit hit, double left) {
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == id && faces[k] == hit.face) {
                return isEnd(k, ray, hit, left);
            }
        }
        return false;
    }
}
