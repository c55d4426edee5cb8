package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;

/**
 * A box parallel to the axes. Faces: 0 = -x, 1 = +x, 2 = -y, 3 = +y, 4 = -z, 5 = +z. The face that is hit is the one
 * whose plane bounds the interval, so edges have no holes, and its coordinate is assigned, not computed.
 */
public final class BoxPrimitive extends Primitive {
    private static final int FACES = 6;

    private final double x0;
    private final double y0;
    private final double z0;
    private final double x1;
    private final double y1;
    private final double z1;

    BoxPrimitive(Vec3 min, Vec3 max) {
        // Slabs take no squares, so a box may have any thickness as long as its coordinates are ordinary.
        super(Math.max(min.maxAbs(), max.maxAbs()), Math.max(min.maxAbs(), max.maxAbs()));
        x0 = min.x();
        y0 = min.y();
        z0 = min.z();
        x1 = max.x();
        y1 = max.y();
        z1 = max.z();
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        return nearest(ray, tMax, ray.start == this);
    }

    /** As {@link #nearest}, for a caller that knows whether the ray starts on this box. */
    double nearest(Ray ray, double tMax, boolean own) {
        if (own && ray.startSide == Ray.OUTSIDE) {
            return MISS;
        }
        double far = Slabs.min(
                Slabs.exit(ray.ox, ray.dx, x0, x1),
                Slabs.exit(ray.oy, ray.dy, y0, y1),
                Slabs.exit(ray.oz, ray.dz, z0, z1));
        if (own) {
            double t = far >= ray.tMin ? far : ray.tMin;
            return t <= tMax ? t : MISS;
        }
        double near = entry(ray);
        if (!Slabs.meet(near, far)) {
            return MISS;
        }
        double t = near >= ray.tMin ? near : far;
        return t >= ray.tMin && t <= tMax ? t : MISS;
    }

    private double entry(Ray ray) {
        return Slabs.max(
                Slabs.entry(ray.ox, ray.dx, x0, x1),
                Slabs.entry(ray.oy, ray.dy, y0, y1),
                Slabs.entry(ray.oz, ray.dz, z0, z1));
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        complete(ray, t, hit, ray.start == this);
    }

    /** As {@link #complete}, for a caller that knows whether the ray starts on this box. */
    void complete(Ray ray, double t, Hit hit, boolean own) {
        boolean entering = !own && entry(ray) >= ray.tMin;
        int axis = entering
                ? Slabs.last(
                        Slabs.entry(ray.ox, ray.dx, x0, x1),
                        Slabs.entry(ray.oy, ray.dy, y0, y1),
                        Slabs.entry(ray.oz, ray.dz, z0, z1))
                : Slabs.first(
                        Slabs.exit(ray.ox, ray.dx, x0, x1),
                        Slabs.exit(ray.oy, ray.dy, y0, y1),
                        Slabs.exit(ray.oz, ray.dz, z0, z1));
        // A ray that travels along -x enters through the face +x; one that travels along +x leaves through it.
        boolean upper = entering ? ray.d(axis) < 0 : ray.d(axis) > 0;
        double sign = upper ? 1 : -1;
        hit.face = 2 * axis + (upper ? 1 : 0);
        hit.side = entering ? Ray.OUTSIDE : Ray.INSIDE;
        hit.nx = axis == 0 ? sign : 0;
        hit.ny = axis == 1 ? sign : 0;
        hit.nz = axis == 2 ? sign : 0;
        hit.setPoint(
                axis == 0 ? (upper ? x1 : x0) : Slabs.clamp(Math.fma(t, ray.dx, ray.ox), x0, x1),
                axis == 1 ? (upper ? y1 : y0) : Slabs.clamp(Math.fma(t, ray.dy, ray.oy), y0, y1),
                axis == 2 ? (upper ? z1 : z0) : Slabs.clamp(Math.fma(t, ray.dz, ray.oz), z0, z1));
    }

    @Override
    public void textureCoordinates(Hit hit) {
        Slabs.textureCoordinates(hit, fractionX(hit), fractionY(hit), fractionZ(hit));
    }

    /** The position of the hit between the faces -x and +x, 0..1. */
    double fractionX(Hit hit) {
        return fraction(hit.px, x0, x1);
    }

    double fractionY(Hit hit) {
        return fraction(hit.py, y0, y1);
    }

    double fractionZ(Hit hit) {
        return fraction(hit.pz, z0, z1);
    }

    private static double fraction(double v, double lo, double hi) {
        return hi > lo ? (v - lo) / (hi - lo) : 0;
    }

    @Override
    public Bounds bounds() {
        return new Bounds(new Vec3(x0, y0, z0), new Vec3(x1, y1, z1));
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public double volume() {
        return (x1 - x0) * (y1 - y0) * (z1 - z0);
    }

    @Override
    public boolean contains(double x, double y, double z) {
        return x >= x0 && x <= x1 && y >= y0 && y <= y1 && z >= z0 && z <= z1;
    }

    @Override
    public int faceCount() {
        return FACES;
    }

    @Override
    public SupportSurface support(int face) {
        double at = face % 2 == 1 ? 1 : 0;
        Vec3[] corners = new Vec3[4];
        for (int k = 0; k < corners.length; k++) {
            // Around the face: 00, 10, 11, 01.
            int p = (k + 1) / 2 % 2;
            int q = k / 2;
            corners[k] = switch (face / 2) {
                case 0 -> corner(at, p, q);
                case 1 -> corner(p, at, q);
                default -> corner(p, q, at);
            };
        }
        Vec3 axis = face / 2 == 0 ? Vec3.X : face / 2 == 1 ? Vec3.Y : Vec3.Z;
        return SupportSurface.Plane.of(at > 0 ? axis : axis.negated(), corners);
    }

    private Vec3 corner(double x, double y, double z) {
        return new Vec3(x > 0 ? x1 : x0, y > 0 ? y1 : y0, z > 0 ? z1 : z0);
    }

    @Override
    public FlatForm flatForm() {
        return FlatForm.of(FlatForm.Kind.BOX, parameters());
    }

    @Override
    Primitive scaledBy(int k) {
        return new BoxPrimitive(new Vec3(x0, y0, z0).scaledBy(k), new Vec3(x1, y1, z1).scaledBy(k));
    }

    @Override
    public double[] parameters() {
        return new double[] {x0, y0, z0, x1, y1, z1};
    }
}
