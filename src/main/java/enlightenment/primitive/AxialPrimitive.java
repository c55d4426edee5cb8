package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A cylinder, a cone or a frustum: what lies between two planes and within one lateral surface around an axis.
 *
 * <p>Everything is measured from the foot of the perpendicular from a reference point (the centre of the narrower end)
 * to the ray's line, not from the ray's origin: with f = o − reference and m = f × d, the foot is F = (d × m)/d², so
 * that no error grows with the distance of the origin, except for the one rounding of f. The parts of the line between the
 * two planes and within the lateral surface are intervals of the same parameter; their intersection is the solid, and the
 * face that is hit is the one that bounds it. So there is no hole at a rim, and inside and outside are the same code.
 *
 * <p>This class and its subclasses find the crossing; {@link AxialSurface} says where on the surface it is. Faces:
 * {@link #LATERAL}, {@link #BASE}, {@link #TOP}.
 */
public abstract sealed class AxialPrimitive extends Primitive permits CylinderPrimitive, ConePrimitive {
    /** The face around the axis. */
    public static final int LATERAL = 0;

    /** The face that closes the base. */
    public static final int BASE = 1;

    /** The face that closes the end opposite to the base. */
    public static final int TOP = 2;

    /** Bounds the roundings of a squared reach and of what is compared with it. */
    private static final double PADDING = 1 + Scale.gamma(16);

    private final Vec3 base;
    private final Vec3 top;
    private final double baseRadius;
    private final double topRadius;
    private final boolean capped;

    /** The reference point: the centre of the narrower end. */
    final double cx;

    final double cy;
    final double cz;

    /** The axis from the reference point to the centre of the wider end, times a power of two. */
    final double ax;

    final double ay;
    final double az;

    /** The inverse of that power of two. */
    final double unit;

    /** The length of the axis with that power of two. */
    final double length;

    /** The axis without the power of two, dotted with the axis with it: F·A of a point at the wider end. */
    final double extent;

    final double narrowRadius;
    final double wideRadius;

    /** The growth of the radius per unit of length along the axis: at least 0. */
    final double slope;

    /** The squared distance of the farthest point from the reference point, as an upper bound. */
    final double reachSquared;

    final boolean narrowIsTop;

    /** The coordinate axis that the axis is parallel to, or -1. */
    private final int aligned;

    /** The axis without a power of two, and with length 1. */
    final Vec3 axis;

    final Vec3 unitAxis;
    private final AxialSurface surface;

    /** @param towardsTop from base to top, more accurate than the difference of the two */
    AxialPrimitive(Vec3 base, Vec3 top, Vec3 towardsTop, double baseRadius, double topRadius, boolean capped) {
        super(
                Math.max(base.maxAbs(), top.maxAbs()) + Math.max(baseRadius, topRadius),
                Math.min(Math.max(baseRadius, topRadius), towardsTop.maxAbs()));
        this.base = base;
        this.top = top;
        this.baseRadius = baseRadius;
        this.topRadius = topRadius;
        this.capped = capped;
        narrowIsTop = topRadius < baseRadius;
        Vec3 narrow = narrowIsTop ? top : base;
        // A difference, so that no zero becomes negative.
        axis = narrowIsTop ? Vec3.ZERO.minus(towardsTop) : towardsTop;
        narrowRadius = Math.min(baseRadius, topRadius);
        wideRadius = Math.max(baseRadius, topRadius);
        double gain = wideRadius - narrowRadius;
        // The forms are homogeneous in the axis; this scale keeps them in range for needles and for wafers.
        int exponent = Math.max(axis.exponent(), Scale.exponent(gain));
        Vec3 scaled = axis.scaledBy(-exponent);
        unit = Math.scalb(1.0, exponent);
        cx = narrow.x();
        cy = narrow.y();
        cz = narrow.z();
        ax = scaled.x();
        ay = scaled.y();
        az = scaled.z();
        length = scaled.length();
        extent = axis.dot(scaled);
        slope = gain / axis.length();
        reachSquared = (axis.lengthSquared() + wideRadius * wideRadius) * PADDING;
        aligned = Disks.alignedAxis(axis);
        unitAxis = Disks.unit(axis);
        surface = new AxialSurface(this);
    }

    /** The centre of the base. */
    public Vec3 base() {
        return base;
    }

    /** The centre of the other end; a cone's apex. */
    public Vec3 top() {
        return top;
    }

    /** The radius at the base. */
    public double baseRadius() {
        return baseRadius;
    }

    /** The radius at the other end. */
    public double topRadius() {
        return topRadius;
    }

    /** From base to top. */
    final Vec3 towardsTop() {
        return narrowIsTop ? Vec3.ZERO.minus(axis) : axis;
    }

    /** Whether disks close the ends. */
    public boolean isCapped() {
        return capped;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        return crossing(ray, tMax, null);
    }

    /**
     * The nearest crossing, or {@link #MISS}.
     *
     * @param hit gets side, face and {@link Hit#along} of the crossing, unless null
     */
    abstract double crossing(Ray ray, double tMax, Hit hit);

    /** Whether the ray starts on the outside of this primitive: then it never returns, as the primitive is convex. */
    final boolean leavesOutside(Ray ray) {
        return ray.start == this && ray.startSide == Ray.OUTSIDE;
    }

    /**
     * Intersects the interval within the lateral surface with that between the planes, and takes the first end that counts.
     *
     * @param foot the ray parameter of the foot F; the other parameters are relative to it
     * @param lo the lower end of the interval within the lateral surface
     * @param hi its upper end
     * @param h F·A
     * @param e d·A
     */
    final double cut(Ray ray, double tMax, Hit hit, double foot, double lo, double hi, double h, double e) {
        boolean started = ray.start == this;
        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        if (e > 0) {
            near = -h / e;
            far = (extent - h) / e;
        } else if (e < 0) {
            near = (extent - h) / e;
            far = -h / e;
        } else if (!started && !(h >= 0 && h <= extent)) {
            return MISS;
        }
        if (!capped) {
            return cutOpen(ray, tMax, hit, foot, lo, hi, near, far);
        }
        if (!started) {
            boolean lateral = lo >= near;
            if (!((lateral ? lo : near) <= Math.min(hi, far))) {
                return MISS;
            }
            double t = lateral ? foot + lo : planeParameter(ray, foot + near, e > 0);
            if (t >= ray.tMin) {
                return found(hit, t, tMax, lateral ? lo : Double.NaN, Ray.OUTSIDE, lateral ? LATERAL : end(e > 0));
            }
        }
        boolean lateral = hi <= far;
        double t = lateral ? foot + hi : planeParameter(ray, foot + far, e < 0);
        double along = lateral ? hi : Double.NaN;
        if (started && !(t >= ray.tMin)) {
            // The exit is never lost: where rounding puts it before the start, it is the start.
            t = ray.tMin;
            along = t - foot;
        }
        return t >= ray.tMin ? found(hit, t, tMax, along, Ray.INSIDE, lateral ? LATERAL : end(e < 0)) : MISS;
    }

    private double cutOpen(Ray ray, double tMax, Hit hit, double foot, double lo, double hi, double near, double far) {
        boolean started = ray.start == this;
        if (!started && lo >= near && lo <= far && lo <= hi && foot + lo >= ray.tMin) {
            return found(hit, foot + lo, tMax, lo, Ray.OUTSIDE, LATERAL);
        }
        double exit = started ? Math.max(hi, ray.tMin - foot) : hi;
        if (exit >= near && exit <= far && (started || lo <= hi) && (started || foot + exit >= ray.tMin)) {
            return found(hit, Math.max(foot + exit, ray.tMin), tMax, exit, Ray.INSIDE, LATERAL);
        }
        return MISS;
    }

    /** The t at which the ray meets an end's plane; for an axis-aligned plane by the same expression as in every other primitive. */
    private double planeParameter(Ray ray, double t, boolean narrow) {
        return switch (aligned) {
            case 0 -> ((narrow ? cx : wide().x()) - ray.ox) / ray.dx;
            case 1 -> ((narrow ? cy : wide().y()) - ray.oy) / ray.dy;
            case 2 -> ((narrow ? cz : wide().z()) - ray.oz) / ray.dz;
            default -> t;
        };
    }

    /** The face that closes the narrower or the wider end. */
    private int end(boolean narrow) {
        return narrow == narrowIsTop ? TOP : BASE;
    }

    /** @param along the crossing's parameter relative to the foot; NaN where the ray crosses an end's plane */
    private static double found(Hit hit, double t, double tMax, double along, int side, int face) {
        if (!(t <= tMax)) {
            return MISS;
        }
        if (hit != null) {
            hit.along = along;
            hit.side = side;
            hit.face = face;
        }
        return t;
    }

    /** The centre of the wider end. */
    final Vec3 wide() {
        return narrowIsTop ? base : top;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        crossing(ray, Double.MAX_VALUE, hit);
        surface.complete(ray, hit);
    }

    @Override
    public void textureCoordinates(Hit hit) {
        surface.textureCoordinates(hit);
    }

    @Override
    public Bounds bounds() {
        return Disks.bounds(base, unitAxis, baseRadius).union(Disks.bounds(top, unitAxis, topRadius));
    }

    @Override
    public SupportSurface support(int face) {
        return switch (face) {
            case BASE -> SupportSurface.Plane.ofDisk(base, narrowIsTop ? unitAxis : unitAxis.negated(), baseRadius);
            case TOP -> SupportSurface.Plane.ofDisk(top, narrowIsTop ? unitAxis.negated() : unitAxis, topRadius);
            default -> new SupportSurface.Lateral(base, top, towardsTop(), baseRadius, topRadius);
        };
    }

    @Override
    public boolean isSolid() {
        return capped;
    }

    @Override
    public double volume() {
        return capped
                ? Math.PI / 3 * axis.length() * (wideRadius * (wideRadius + narrowRadius) + narrowRadius * narrowRadius)
                : 0;
    }

    @Override
    public boolean contains(double x, double y, double z) {
        double px = x - cx;
        double py = y - cy;
        double pz = z - cz;
        double h = Products.accurateDot(px, py, pz, ax, ay, az);
        if (!capped || !(h >= 0 && h <= extent)) {
            return false;
        }
        double wx = Products.difference(py, az, pz, ay);
        double wy = Products.difference(pz, ax, px, az);
        double wz = Products.difference(px, ay, py, ax);
        return Products.distanceSquaredMinus(wx, wy, wz, Math.fma(slope, h, narrowRadius * length)) <= 0;
    }

    @Override
    public int faceCount() {
        return capped ? 3 : 1;
    }

    /** The numbers of a subclass for code on another device: whether it is a cone, and four that differ between cylinders and cones. */
    abstract double[] flatNumbers();

    @Override
    public FlatForm flatForm() {
        return FlatForm.of(
                FlatForm.Kind.AXIAL,
                new double[] {cx, cy, cz, ax, ay, az, unit, length, extent, narrowRadius, wideRadius, slope},
                new double[] {reachSquared, narrowIsTop ? 1 : 0, aligned},
                concat(axis, unitAxis),
                new double[] {capped ? 1 : 0},
                flatNumbers(),
                surface.flatForm(),
                concat(base, top),
                new double[] {baseRadius, topRadius});
    }

    @Override
    public double[] parameters() {
        return new double[] {
            base.x(),
            base.y(),
            base.z(),
            top.x(),
            top.y(),
            top.z(),
            baseRadius,
            topRadius,
            capped ? 1 : 0,
            towardsTop().x(),
            towardsTop().y(),
            towardsTop().z()
        };
    }
}
