package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * The faces that a light lies on: a lamp in the plane of a ceiling, a bulb on a wall. A shadow ray that ends on the light ends on
 * them too, and they do not occlude it there, just as the surface it starts on does not: whether rounding puts their crossing
 * before the light or behind it means nothing. A crossing anywhere else occludes. Faces are added while a scene is compiled;
 * later it is read only.
 *
 * <p>Some faces are borders of solids that light enters. A light that lies on a border is outside of the solid, as if a hair of air were
 * between: what comes from within crosses the border first, wherever rounding puts it, and what the light sends inwards enters there.
 */
public final class EndFaces {
    /** How far to search for a face, in tolerances: enough never to miss it. */
    public static final double REACH = 4;

    private Primitive[] primitives = {};
    private int[] ids = {};
    private int[] faces = {};
    private boolean[] isFlat = {};
    private double[] tolerances = {};
    private boolean[] isBorder = {};
    private boolean hasBorders;

    /** No faces yet. */
    public EndFaces() {}

    /**
     * Adds a face while a scene is compiled.
     *
     * @param primitive the face's primitive
     * @param id its number
     * @param face which of its faces
     * @param tolerance bounds the distance between face and light that rounding may cause: a length in the frame
     * @param border whether light enters the primitive there
     */
    public void add(Primitive primitive, int id, int face, double tolerance, boolean border) {
        int n = ids.length;
        primitives = Arrays.copyOf(primitives, n + 1);
        ids = Arrays.copyOf(ids, n + 1);
        faces = Arrays.copyOf(faces, n + 1);
        isFlat = Arrays.copyOf(isFlat, n + 1);
        tolerances = Arrays.copyOf(tolerances, n + 1);
        isBorder = Arrays.copyOf(isBorder, n + 1);
        primitives[n] = primitive;
        ids[n] = id;
        faces[n] = face;
        isFlat[n] = primitive.support(face).isFlat();
        tolerances[n] = tolerance;
        isBorder[n] = border;
        hasBorders |= border;
    }

    /** Whether there are none. */
    public boolean isEmpty() {
        return ids.length == 0;
    }

    /** Whether any of them is the border of a solid. */
    public boolean hasBorders() {
        return hasBorders;
    }

    /** Whether one of them is the border of this solid. */
    public boolean hasBorderOf(int id) {
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == id && isBorder[k]) {
                return true;
            }
        }
        return false;
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
     * Lets a ray that leaves the light start on these faces as well, but for borders that it crosses to the inside. It is inside of an
     * opaque solid only where the face covers the light.
     *
     * @param side the side of the light's own surface that it travels on
     * @param scratch is overwritten
     */
    public void startOn(Ray ray, int side, Ray scratch) {
        for (int k = 0; k < ids.length; k++) {
            int there = side;
            if (primitives[k].support(faces[k]) instanceof SupportSurface.Plane plane) {
                Vec3 n = plane.unitNormal();
                there = n.x() * ray.dx + n.y() * ray.dy + n.z() * ray.dz > 0 ? Ray.OUTSIDE : Ray.INSIDE;
            }
            if (there == Ray.OUTSIDE || !isBorder[k] && covers(k, ray, scratch)) {
                ray.alsoFrom(primitives[k], there);
            }
        }
    }

    /** Whether a face is where the ray starts. A light may be larger than what it lies on. */
    private boolean covers(int k, Ray ray, Ray scratch) {
        if (!primitives[k].isSolid() || !(primitives[k].support(faces[k]) instanceof SupportSurface.Plane plane)) {
            return true;
        }
        Vec3 n = plane.unitNormal();
        double reach = REACH * tolerances[k];
        scratch.set(
                Math.fma(reach, n.x(), ray.ox),
                Math.fma(reach, n.y(), ray.oy),
                Math.fma(reach, n.z(), ray.oz),
                -n.x(),
                -n.y(),
                -n.z(),
                0);
        return primitives[k].nearest(scratch, 2 * reach) != Primitive.MISS;
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
        return !(isBorder[k] && hit.side == Ray.INSIDE) && isAtEnd(ray, hit, left, isFlat[k], tolerances[k]);
    }

    /**
     * Whether a crossing of a face that coincides with the end of a segment is that end.
     *
     * @param left how far behind the crossing the segment ends, in lengths of its direction
     * @param isFlat whether the face is
     * @param tolerance bounds the distance between the face and the end that rounding may cause
     */
    public static boolean isAtEnd(Ray ray, Hit hit, double left, boolean isFlat, double tolerance) {
        // A line meets a plane once, and this one in the end; it may meet a curved face earlier as well.
        double across = Math.abs(hit.nx * ray.dx + hit.ny * ray.dy + hit.nz * ray.dz);
        return isFlat || left * across <= tolerance;
    }

    /**
     * Whether a ray comes out of a solid by a face that coincides with its end: there is a border before that.
     *
     * @param tEnd the t at which the ray ends
     * @param scratch is overwritten
     */
    public static boolean leavesAtEnd(
            Ray ray, double tEnd, Primitive solid, int face, boolean isFlat, double tolerance, Hit scratch) {
        return solid.intersect(ray, scratch)
                && scratch.face == face
                && scratch.side == Ray.INSIDE
                && isAtEnd(ray, scratch, Math.abs(tEnd - scratch.t), isFlat, tolerance);
    }

    /**
     * Whether a ray comes to the light out of a solid that this lies on.
     *
     * @param tMax the t at which the ray ends on the light
     * @param scratch is overwritten
     */
    public boolean isLeftAtEnd(Ray ray, double tMax, Hit scratch) {
        for (int k = 0; hasBorders && k < ids.length; k++) {
            if (isBorder[k] && leavesAtEnd(ray, tMax, primitives[k], faces[k], isFlat[k], tolerances[k], scratch)) {
                return true;
            }
        }
        return false;
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
