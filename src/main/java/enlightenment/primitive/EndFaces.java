package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.Arrays;

/**
 * The faces that a light lies on: a lamp in the plane of a ceiling, a bulb on a wall. A shadow ray that ends on the light ends on them too,
 * and they do not occlude it there, just as the surface it starts on does not: whether rounding puts their crossing before the light or
 * behind it means nothing. A crossing anywhere else occludes. Faces are added while a scene is compiled; later it is read only.
 *
 * <p>Some faces are interfaces of solids that light enters. A light that lies on one is outside of the solid, as if there were a thin gap
 * between them: a ray from within crosses the interface first, wherever rounding puts it, and light sent inwards enters the solid there.
 *
 * <p>Other faces cover the light on one side or on both, as a small lamp does that lies on a large one: a ray from that side hits the face
 * first, and light sent to that side is lost.
 */
public final class EndFaces {
    /** The distance, in tolerances, within which a face is searched for: enough never to miss it. */
    public static final double REACH = 4;

    private Primitive[] primitives = {};
    private int[] ids = {};
    private int[] faces = {};
    private boolean[] isFlat = {};
    private double[] tolerances = {};
    private boolean[] isInterface = {};

    /** The sides of each face, as {@link #bit}s, from which the light is hidden. */
    private int[] hiding = {};

    private boolean hasInterfaces;
    private boolean hides;
    private boolean hasCovers;

    /** Makes an empty set. */
    public EndFaces() {}

    /**
     * Adds a face while a scene is compiled.
     *
     * @param primitive the face's primitive
     * @param id the primitive's number
     * @param face of the primitive
     * @param tolerance bounds the distance between face and light that rounding may cause: a length in the frame
     * @param isEntered whether light enters the primitive there
     * @param covered the sides of the face, as {@link #bit}s, on which it covers the light; 0 for an interface
     */
    public void add(Primitive primitive, int id, int face, double tolerance, boolean isEntered, int covered) {
        int n = ids.length;
        primitives = Arrays.copyOf(primitives, n + 1);
        ids = Arrays.copyOf(ids, n + 1);
        faces = Arrays.copyOf(faces, n + 1);
        isFlat = Arrays.copyOf(isFlat, n + 1);
        tolerances = Arrays.copyOf(tolerances, n + 1);
        isInterface = Arrays.copyOf(isInterface, n + 1);
        hiding = Arrays.copyOf(hiding, n + 1);
        primitives[n] = primitive;
        ids[n] = id;
        faces[n] = face;
        isFlat[n] = primitive.support(face).isFlat();
        tolerances[n] = tolerance;
        isInterface[n] = isEntered;
        hiding[n] = isEntered ? bit(Ray.INSIDE) : covered;
        hasInterfaces |= isEntered;
        hides |= hiding[n] != 0;
        hasCovers |= covered != 0;
    }

    /** A side of a surface ({@link Hit#side}) as one of a set of sides. */
    public static int bit(int side) {
        return side == Ray.INSIDE ? 2 : 1;
    }

    /** Whether a side is one of a set. */
    private static boolean contains(int sides, int side) {
        return (sides & bit(side)) != 0;
    }

    /**
     * If these are one face of a primitive and nothing else, and it hides nothing, the distance between it and the light that rounding may
     * cause; else −1.
     */
    public double toleranceIfOnly(int id, int face) {
        boolean isOnly = ids.length == 1 && ids[0] == id && faces[0] == face && !hides;
        return isOnly ? tolerances[0] : -1;
    }

    /** Whether the light lies on no face. */
    public boolean isEmpty() {
        return ids.length == 0;
    }

    /** Whether any face is the interface of a solid. */
    public boolean hasInterfaces() {
        return hasInterfaces;
    }

    /** Whether some face covers the light, or a part of it, on a side. */
    public boolean hasCovers() {
        return hasCovers;
    }

    /** Whether a face is the interface of this solid. */
    public boolean hasInterfaceOf(int id) {
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == id && isInterface[k]) {
                return true;
            }
        }
        return false;
    }

    /** Whether the light lies on this face of a primitive. */
    public boolean has(int id, int face) {
        for (int k = 0; k < ids.length; k++) {
            if (ids[k] == id && faces[k] == face) {
                return true;
            }
        }
        return false;
    }

    /**
     * Lets a ray that leaves the light start on these faces as well, except for interfaces that it crosses inwards. It starts inside of an
     * opaque solid only where the face covers the light.
     *
     * @param side the side of the light's own surface that it travels on
     * @param nx the light's unit normal there: nx, ny, nz; zero for a point
     * @param scratch is overwritten
     */
    public void startOn(Ray ray, int side, double nx, double ny, double nz, Ray scratch) {
        for (int k = 0; k < ids.length; k++) {
            int there = sideOf(k, ray, side);
            if (there == Ray.OUTSIDE || !isInterface[k] && covers(k, ray, nx, ny, nz, scratch)) {
                ray.alsoFrom(primitives[k], there);
            }
        }
    }

    /** The side of a face that a ray from the light travels on. */
    private int sideOf(int k, Ray ray, int side) {
        if (primitives[k].support(faces[k]) instanceof SupportSurface.Plane plane) {
            Vec3 n = plane.unitNormal();
            return n.x() * ray.dx + n.y() * ray.dy + n.z() * ray.dz > 0 ? Ray.OUTSIDE : Ray.INSIDE;
        }
        return side;
    }

    /** Whether a face covers the ray's origin; a light may be larger than the face it lies on. */
    private boolean covers(int k, Ray ray, double nx, double ny, double nz, Ray scratch) {
        if (!primitives[k].isSolid()) {
            return true;
        }
        if (primitives[k].support(faces[k]) instanceof SupportSurface.Plane plane) {
            Vec3 n = plane.unitNormal();
            return isAt(k, ray, n.x(), n.y(), n.z(), scratch);
        }
        return nx == 0 && ny == 0 && nz == 0 || isAt(k, ray, nx, ny, nz, scratch);
    }

    private boolean isAt(int k, Ray ray, double nx, double ny, double nz, Ray scratch) {
        double reach = REACH * tolerances[k];
        scratch.set(
                Math.fma(reach, nx, ray.ox),
                Math.fma(reach, ny, ray.oy),
                Math.fma(reach, nz, ray.oz),
                -nx,
                -ny,
                -nz,
                0);
        return primitives[k].nearest(scratch, 2 * reach) != Primitive.MISS;
    }

    /**
     * Whether a face covers the light where a ray leaves it.
     *
     * @param side the side of the light's own surface that it travels on
     * @param nx the light's unit normal there: nx, ny, nz
     * @param scratch is overwritten
     */
    public boolean isCovered(Ray ray, int side, double nx, double ny, double nz, Ray scratch) {
        for (int k = 0; hasCovers && k < ids.length; k++) {
            if (!isInterface[k] && contains(hiding[k], sideOf(k, ray, side)) && isAt(k, ray, nx, ny, nz, scratch)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the light lies on any face of the primitive. */
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
        return !contains(hiding[k], hit.side) && isAtEnd(ray, hit, left, isFlat[k], tolerances[k]);
    }

    /**
     * Whether a crossing of a face that coincides with the end of a segment is that end.
     *
     * @param left the distance of the end behind the crossing, in lengths of the ray's direction
     * @param isFlat whether the face is flat
     * @param tolerance bounds the distance between the face and the end that rounding may cause
     */
    public static boolean isAtEnd(Ray ray, Hit hit, double left, boolean isFlat, double tolerance) {
        // A line crosses a plane once, and this one at the end; it may cross a curved face earlier as well.
        double across = Math.abs(hit.nx * ray.dx + hit.ny * ray.dy + hit.nz * ray.dz);
        return isFlat || left * across <= tolerance;
    }

    /**
     * Whether a ray crosses a face that coincides with its end from one of some sides: the interface of a solid that it leaves, or a face
     * that covers a light. Such a crossing comes before the end.
     *
     * @param tEnd the t at which the ray ends
     * @param sides as {@link #bit}s
     * @param scratch is overwritten
     */
    public static boolean crossesAtEnd(
            Ray ray, double tEnd, Primitive p, int face, int sides, boolean isFlat, double tolerance, Hit scratch) {
        return p.intersect(ray, scratch)
                && scratch.face == face
                && contains(sides, scratch.side)
                && isAtEnd(ray, scratch, Math.abs(tEnd - scratch.t), isFlat, tolerance);
    }

    /**
     * Whether a ray reaches the light out of a solid that the light lies on, or where the light is covered.
     *
     * @param tMax the t at which the ray ends on the light
     * @param scratch is overwritten
     */
    public boolean isHiddenAtEnd(Ray ray, double tMax, Hit scratch) {
        for (int k = 0; hides && k < ids.length; k++) {
            int sides = hiding[k];
            if (sides != 0
                    && crossesAtEnd(ray, tMax, primitives[k], faces[k], sides, isFlat[k], tolerances[k], scratch)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a hit is the end of a ray that goes to the light.
     *
     * @param id the number of the primitive that it hits
     * @param left the distance of the light behind the hit, in lengths of the ray's direction
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
