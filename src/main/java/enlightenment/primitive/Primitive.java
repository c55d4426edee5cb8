package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/**
 * A shape placed in a frame: plain doubles, ready to be intersected. Immutable, safe for any number of threads.
 *
 * <p>Subclasses implement the core of each operation for ordinary magnitudes. This class guards them: where a ray or a
 * primitive is so large or so small that intermediate results could overflow or underflow, both are first multiplied by
 * powers of two, which is exact. The cores are built from operations that commute with powers of two, so the guard is
 * invisible.
 *
 * <p>Rules of a crossing (numerics, "leaving a surface without an offset"): a crossing counts if its t is at least
 * {@link Ray#tMin}. A ray that starts on this primitive ({@link Ray#start}) never meets it again if it is planar, nor if
 * it is convex and the ray travels outside; if the ray travels inside a convex primitive it meets the far end of its
 * interval, always.
 */
public abstract sealed class Primitive
        permits SpherePrimitive,
                RectanglePrimitive,
                DiskPrimitive,
                AxialPrimitive,
                TorusPrimitive,
                BoxPrimitive,
                CubePrimitive,
                TrianglePrimitive,
                MeshPrimitive {

    /** The t of no crossing. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    private final boolean extreme;

    /**
     * @param reach the largest absolute coordinate of any point of the primitive
     * @param size its smallest characteristic length: a radius, an edge
     */
    Primitive(double reach, double size) {
        extreme = Scale.exponent(reach) >= Ray.ORDINARY_EXPONENT || Scale.exponent(size) <= -Ray.ORDINARY_EXPONENT;
    }

    /** Whether the primitive is so large or so small that tests rescale it. */
    public final boolean isExtreme() {
        return extreme;
    }

    /** The t of the nearest crossing with tMin ≤ t ≤ tMax, or {@link #MISS}; for rays and primitives of any size. */
    public final double nearest(Ray ray, double tMax) {
        if (isSpecial(ray)) {
            return nearestSpecial(ray, tMax);
        }
        return nearestOrdinary(ray, tMax);
    }

    /**
     * Whether the ray meets this primitive. If so, fills the hit completely, except for texture coordinates. With a direction of
     * extreme length the hit's t may overflow; its point is accurate all the same.
     */
    public final boolean intersect(Ray ray, Hit hit) {
        if (extreme || ray.special) {
            return intersectSpecial(ray, hit);
        }
        return intersectOrdinary(ray, hit);
    }

    /** Fills the hit at a crossing that {@link #nearest} found: t, point, normal, side, face, primitive. */
    public final void complete(Ray ray, double t, Hit hit) {
        if (extreme || ray.special) {
            intersectSpecial(ray, hit);
            return;
        }
        hit.t = t;
        hit.primitive = this;
        completeOrdinary(ray, t, hit);
    }

    /** The side that the ray arrives on at the crossing t that {@link #nearest} found. */
    public final int side(Ray ray, double t) {
        Hit hit = new Hit();
        complete(ray, t, hit);
        return hit.side;
    }

    /** Whether there is a crossing with tMin ≤ t ≤ tMax that is not the end of the ray. */
    public final boolean blocks(Ray ray, double tMax) {
        // A primitive with elements finds those that the ray starts on itself, and no ray ends on it: any crossing
        // counts.
        boolean isOrdinary = !isSpecial(ray) || hasElements() && !extreme && !ray.extreme;
        return isOrdinary ? blocksOrdinary(ray, tMax) : nearestSpecial(ray, tMax) <= tMax;
    }

    /** Whether the ray or this primitive is extreme, or the ray starts or ends on several primitives, this one among them. */
    private boolean isSpecial(Ray ray) {
        return extreme || ray.special && (ray.extreme || ray.concerns(this));
    }

    /** As {@link #blocks}, for ordinary magnitudes. */
    boolean blocksOrdinary(Ray ray, double tMax) {
        return nearestOrdinary(ray, tMax) <= tMax;
    }

    /** As {@link #nearest}, for ordinary magnitudes. */
    abstract double nearestOrdinary(Ray ray, double tMax);

    /** As {@link #complete}, for ordinary magnitudes: point, normal, side and face. */
    abstract void completeOrdinary(Ray ray, double t, Hit hit);

    /** Sets the texture coordinates of a hit on this primitive. */
    public abstract void textureCoordinates(Hit hit);

    /**
     * Sets the hit's shading normal {@link Hit#sx} and so on: on the same side as the geometric one.
     *
     * @return false if it is the geometric normal; then nothing is set
     */
    public boolean shadingNormal(Hit hit) {
        return false;
    }

    /**
     * Sets the directions in which texture coordinates grow at a hit.
     *
     * @return false if the primitive has none there
     */
    public boolean textureDirections(Hit hit) {
        return false;
    }

    /** Whether textures can turn normals: {@link #textureDirections} exist wherever textures have coordinates. */
    public boolean hasTextureDirections() {
        return false;
    }

    /**
     * Writes the offset from a hit to the surface that the shading normals suggest, on the side that the ray arrived on (J. Hanika,
     * "Hacking the shadow terminator", Ray Tracing Gems II, 2021, chapter 4).
     *
     * @return false if there is none
     */
    public boolean bulge(Hit hit, double[] offset) {
        return false;
    }

    /** Whether u is periodic: 0 and 1 are the same column of a texture, without a seam. */
    public boolean repeatsTextures() {
        return false;
    }

    /** A box that encloses the primitive, rounded outwards. */
    public abstract Bounds bounds();

    /** The largest number of crossings of a line; a torus is of the fourth degree. */
    public int crossings() {
        return 4;
    }

    /** Whether the primitive encloses a volume. */
    public boolean isSolid() {
        return false;
    }

    /**
     * The volume that the primitive encloses, independent of rotation: 0 if none. Rounded, and 0 or infinite where it is no ordinary
     * number; equal for equal lengths.
     */
    public double volume() {
        return 0;
    }

    /** Whether a ray that leaves the outside of the surface can never meet it again. */
    public boolean isConvex() {
        return true;
    }

    /** Whether the point lies in the closed volume; false for a primitive that encloses none. */
    public boolean contains(double x, double y, double z) {
        return false;
    }

    /** Whether it has many elements, such as triangles, of which rays carry the one that they start on ({@link Hit#element}). */
    public boolean hasElements() {
        return false;
    }

    /** Whether the primitive is a part of a plane: a ray that leaves it never meets it again, on either side. */
    public boolean isFlat() {
        return false;
    }

    /** Whether the primitive is one whole surface, with no face cut out of it: it coincides only with its equal. */
    public boolean isWhole() {
        return false;
    }

    /** The surface that a face is part of; face is in 0..{@link #faceCount}−1. */
    public abstract SupportSurface support(int face);

    /** The number of faces: {@link Hit#face} is in 0..faceCount−1. */
    public int faceCount() {
        return 1;
    }

    /** This primitive with every coordinate and length times 2^k. */
    abstract Primitive scaledBy(int k);

    /** The primitive for code on another device; null if that does not support it. */
    public FlatForm flatForm() {
        return null;
    }

    /** The numbers that define the primitive, in a fixed order: equal arrays and classes mean equal primitives. */
    public abstract double[] parameters();

    /** The first of the {@link #parameters}. */
    public double firstParameter() {
        return parameters()[0];
    }

    private boolean intersectOrdinary(Ray ray, Hit hit) {
        double t = nearestOrdinary(ray, Double.MAX_VALUE);
        if (t == MISS) {
            return false;
        }
        hit.t = t;
        hit.primitive = this;
        completeOrdinary(ray, t, hit);
        return true;
    }

    /** As {@link #nearest}, for an extreme ray or primitive, and for a ray that starts or ends on several primitives. */
    private double nearestSpecial(Ray ray, double tMax) {
        Primitive start = ray.start;
        int element = ray.startElement;
        int side = ray.startSide;
        startHere(ray);
        double t = extreme || ray.extreme ? nearestExtreme(ray, tMax) : nearestOrdinary(ray, tMax);
        boolean ends = ray.endsOn(this, t);
        ray.from(start, element, side);
        // If the nearest crossing is the end of the ray, this primitive does not occlude it.
        return ends ? MISS : t;
    }

    private boolean intersectSpecial(Ray ray, Hit hit) {
        Primitive start = ray.start;
        int element = ray.startElement;
        int side = ray.startSide;
        startHere(ray);
        boolean met = extreme || ray.extreme ? intersectExtreme(ray, hit) : intersectOrdinary(ray, hit);
        ray.from(start, element, side);
        return met;
    }

    private void startHere(Ray ray) {
        int side = ray.sideOf(this);
        if (side != 0 && !hasElements()) {
            ray.from(this, side);
        }
    }

    private double nearestExtreme(Ray ray, double tMax) {
        Rescaled r = new Rescaled(ray);
        double t = r.primitive.nearestOrdinary(
                r.ray, tMax == Double.MAX_VALUE ? tMax : Math.scalb(tMax, r.lengths - r.directions));
        ray.element = r.ray.element;
        return t == MISS ? MISS : Math.min(Math.scalb(t, r.directions - r.lengths), Double.MAX_VALUE);
    }

    private boolean intersectExtreme(Ray ray, Hit hit) {
        Rescaled r = new Rescaled(ray);
        double t = r.primitive.nearestOrdinary(r.ray, Double.MAX_VALUE);
        if (t == MISS) {
            return false;
        }
        r.primitive.completeOrdinary(r.ray, t, hit);
        hit.t = Math.scalb(t, r.directions - r.lengths);
        hit.primitive = this;
        ray.element = r.ray.element;
        hit.setPoint(Scale.scalb(hit.px, -r.lengths), Scale.scalb(hit.py, -r.lengths), Scale.scalb(hit.pz, -r.lengths));
        return true;
    }

    /** This primitive and a ray, lengths times one power of two and directions times another, so that both are ordinary. */
    private final class Rescaled {
        final int lengths;
        final int directions;
        final Primitive primitive;
        final Ray ray;

        Rescaled(Ray original) {
            lengths = -Math.max(Scale.exponent(bounds().maxAbs()), Scale.exponent(original.maxAbsOrigin()));
            directions = -Scale.exponent(original.maxAbsDirection());
            primitive = scaledBy(lengths);
            ray = original.scaledBy(lengths, directions);
            if (original.start == Primitive.this) {
                ray.from(primitive, original.startElement, original.startSide);
            }
        }
    }

    static double[] concat(Vec3... vs) {
        double[] r = new double[3 * vs.length];
        for (int i = 0; i < vs.length; i++) {
            r[3 * i] = vs[i].x();
            r[3 * i + 1] = vs[i].y();
            r[3 * i + 2] = vs[i].z();
        }
        return r;
    }
}
