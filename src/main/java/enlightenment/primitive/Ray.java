package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.mesh.tree.MeshRay;
import enlightenment.numeric.Scale;
import java.util.Arrays;

/**
 * A ray o + t·d with t in [tMin, ∞), with the surfaces that it starts on.
 *
 * <p>A mutable work object: hot loops reuse one instance and read its fields directly. The direction may have any length; t is measured in
 * multiples of it. The origin of a ray that leaves a surface is never moved away from it: instead the ray carries the primitive that it
 * starts on and the side that it travels on (numerics: "leaving a surface without an offset").
 */
public final class Ray {
    /** The side of a surface that its outward normal points to. */
    public static final int OUTSIDE = 1;

    /** The side of a surface that its outward normal points away from. */
    public static final int INSIDE = -1;

    /** Beyond this binary exponent of a direction or a coordinate the slow, rescaling tests are used. */
    static final int ORDINARY_EXPONENT = 120;

    /** The largest squared length for the fast tests. */
    private static final double ORDINARY_MAX = 0x1p240;

    static final double ORDINARY_MIN = 0x1p-240;

    private static final Primitive[] NONE = {};

    /** The origin. */
    public double ox;

    public double oy;
    public double oz;

    /** The direction, of any length but 0. */
    public double dx;

    public double dy;
    public double dz;

    /** 1/dx, 1/dy, 1/dz, infinite where a component is zero; valid after {@link #invert}. */
    public double invX;

    public double invY;
    public double invZ;

    /** The squared length of the direction. */
    public double dd;

    /** Crossings before this t do not count. */
    public double tMin;

    /** The primitive that the origin lies on, or null. */
    public Primitive start;

    /** The element of {@link #start} that the origin lies on, if that has many. */
    public int startElement;

    /** The element that the last test found, if the primitive has many. */
    public int element;

    /** The member that the last test of a {@link MeshUnion} found. */
    public int member;

    /** The side of {@link #start} that the ray travels on: {@link #OUTSIDE} or {@link #INSIDE}. */
    public int startSide;

    /** Other primitives that the origin lies on as well, and the sides that the ray travels on. */
    private Primitive[] alsoStarts = NONE;

    private int[] alsoElements = new int[0];
    private int[] alsoSides = new int[0];
    private int alsoCount;

    /** The faces that the ray ends on, or null; they do not occlude it at its end. */
    EndFaces end;

    /** The t at which the ray ends on {@link #end}. */
    double tEnd;

    private Hit endHit;

    /** Whether tests take the slow path: the ray is {@link #extreme}, starts on several primitives, or ends on some. */
    boolean special;

    /** Whether the direction or the origin is so large or small that squares could leave the range of doubles. */
    public boolean extreme;

    private boolean inverted;
    private boolean sheared;
    int kx;
    int ky;
    int kz;
    double shearX;
    double shearY;

    /** Scratch of the torus test: made at the first torus that the ray comes near, then kept. */
    TorusLine torusLine;

    private MeshRay meshRay;

    /** Makes a ray, to be {@link #set} before use. */
    public Ray() {}

    /** A ray from o along d that starts on no surface. */
    public static Ray of(Vec3 o, Vec3 d) {
        return new Ray().set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), 0);
    }

    /** A ray from o along d that starts on the given side of a primitive. */
    public static Ray leaving(Vec3 o, Vec3 d, Primitive start, int side) {
        return of(o, d).from(start, side);
    }

    /** Sets origin, direction and range; the ray starts on no surface. */
    public Ray set(double x, double y, double z, double dirX, double dirY, double dirZ, double from) {
        ox = x;
        oy = y;
        oz = z;
        dx = dirX;
        dy = dirY;
        dz = dirZ;
        dd = dirX * dirX + dirY * dirY + dirZ * dirZ;
        tMin = from;
        start = null;
        startElement = 0;
        startSide = 0;
        sheared = false;
        inverted = false;
        double oo = x * x + y * y + z * z;
        extreme = !(dd <= ORDINARY_MAX && dd >= ORDINARY_MIN && oo <= ORDINARY_MAX);
        special = extreme;
        alsoCount = 0;
        end = null;
        return this;
    }

    /** Makes this the same as a ray that starts on at most one surface and ends on none. */
    public Ray set(Ray other) {
        return set(other.ox, other.oy, other.oz, other.dx, other.dy, other.dz, other.tMin)
                .from(other.start, other.startElement, other.startSide);
    }

    /** Sets the surface that the ray starts on, that of a hit, and the side that it travels on. */
    public Ray from(Hit hit, int side) {
        return from(hit.primitive, hit.element, side);
    }

    /** Sets a surface of one element that the ray starts on. */
    public Ray from(Primitive primitive, int side) {
        return from(primitive, 0, side);
    }

    /** Sets an element of a surface that the ray starts on. */
    Ray from(Primitive primitive, int part, int side) {
        start = primitive;
        startElement = part;
        startSide = side;
        return this;
    }

    /** Adds the surface of a hit that the ray starts on as well, or ends on. */
    public void alsoFrom(Hit hit, int side) {
        alsoFrom(hit.primitive, hit.element, side);
    }

    /** Adds a primitive that the ray starts on as well: its surface coincides there with that of {@link #start}. */
    public void alsoFrom(Primitive primitive, int side) {
        alsoFrom(primitive, 0, side);
    }

    private void alsoFrom(Primitive primitive, int part, int side) {
        if (alsoCount == alsoStarts.length) {
            alsoStarts = Arrays.copyOf(alsoStarts, 2 * alsoCount + 2);
            alsoElements = Arrays.copyOf(alsoElements, 2 * alsoCount + 2);
            alsoSides = Arrays.copyOf(alsoSides, 2 * alsoCount + 2);
        }
        alsoStarts[alsoCount] = primitive;
        alsoElements[alsoCount] = part;
        alsoSides[alsoCount++] = side;
        special = true;
    }

    /** Sets the t at which the ray ends and the faces that it ends on. */
    public void endsOn(EndFaces faces, double t) {
        if (!faces.isEmpty()) {
            end = faces;
            tEnd = t;
            special = true;
        }
    }

    /** Whether the crossing of the primitive at t is the end of the ray. */
    boolean endsOn(Primitive p, double t) {
        if (end == null || t == Primitive.MISS || !end.concerns(p)) {
            return false;
        }
        if (endHit == null) {
            endHit = new Hit();
        }
        p.complete(this, t, endHit);
        return end.isEnd(this, endHit);
    }

    /** Whether tests take a slow path: the ray is {@link #extreme}, starts on several primitives, or ends on some. */
    public boolean isSpecial() {
        return special;
    }

    /**
     * The number, for {@link #alsoStart} and {@link #alsoElement}, of the mesh among the other surfaces that the ray starts on; −1 if none
     * is a mesh, −2 if several are.
     */
    int otherMesh() {
        int found = -1;
        for (int k = 0; k < alsoCount; k++) {
            if (alsoStarts[k].hasElements() && !(alsoStarts[k] == start && alsoElements[k] == startElement)) {
                found = found == -1 ? k : -2;
            }
        }
        return found;
    }

    Primitive alsoStart(int k) {
        return alsoStarts[k];
    }

    int alsoElement(int k) {
        return alsoElements[k];
    }

    /** The side of the primitive that the ray starts on, or 0 if it does not start on it. */
    public int sideOf(Primitive primitive) {
        if (start == primitive) {
            return startSide;
        }
        for (int k = 0; k < alsoCount; k++) {
            if (alsoStarts[k] == primitive) {
                return alsoSides[k];
            }
        }
        return 0;
    }

    /** Whether a primitive is one of those that the ray starts on besides the first, or may end on. */
    boolean concerns(Primitive p) {
        for (int k = 0; k < alsoCount; k++) {
            if (alsoStarts[k] == p) {
                return true;
            }
        }
        // Lights lie on no meshes.
        return end != null && !p.hasElements() && end.concerns(p);
    }

    /** Another element than {@link #startElement} of a primitive that the ray starts or ends on; −1 if there is none. */
    int otherElementOf(Primitive primitive) {
        for (int k = 0; k < alsoCount; k++) {
            if (alsoStarts[k] == primitive && !(start == primitive && alsoElements[k] == startElement)) {
                return alsoElements[k];
            }
        }
        return -1;
    }

    /** The ray in the coordinates of the mesh that is being tested. */
    MeshRay meshRay() {
        if (meshRay == null) {
            meshRay = new MeshRay();
        }
        return meshRay;
    }

    /** This ray with the origin times 2^k and the direction times 2^j, both exact; t becomes t·2^(k−j). */
    Ray scaledBy(int k, int j) {
        return new Ray()
                .set(
                        Scale.scalb(ox, k),
                        Scale.scalb(oy, k),
                        Scale.scalb(oz, k),
                        Scale.scalb(dx, j),
                        Scale.scalb(dy, j),
                        Scale.scalb(dz, j),
                        Math.scalb(tMin, k - j));
    }

    double maxAbsOrigin() {
        return Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz)));
    }

    double maxAbsDirection() {
        return Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
    }

    double o(int axis) {
        return axis == 0 ? ox : axis == 1 ? oy : oz;
    }

    /** The component of the direction on an axis. */
    public double d(int axis) {
        return axis == 0 ? dx : axis == 1 ? dy : dz;
    }

    /** Makes the inverse components valid; only boxes and hierarchies need them. */
    public void invert() {
        if (!inverted) {
            invX = 1 / dx;
            invY = 1 / dy;
            invZ = 1 / dz;
            inverted = true;
        }
    }

    /**
     * Prepares the shear that maps this ray to the +z axis (Woop, Benthin and Wald, "Watertight ray/triangle
     * intersection", JCGT 2013): axis kz is the largest of the direction.
     */
    void shear() {
        if (sheared) {
            return;
        }
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        kz = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        shearX = d(kx) / d(kz);
        shearY = d(ky) / d(kz);
        sheared = true;
    }
}
