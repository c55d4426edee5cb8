package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A parallelogram. Near ones are sampled uniformly over solid angle, rectangles as a {@link SphericalRectangle}, others as two
 * {@link SphericalTriangle}s; far ones uniformly over the area. The normal, up × right, is on the front: the side from which its edges
 * {@code up} and {@code right} point as they are named.
 */
public final class ParallelogramLight extends FlatLight {
    /**
     * Below this solid angle, in steradians, the density of samples by area is nearly constant over the light, except at grazing angles.
     */
    static final double LEAST_SOLID_ANGLE = 1e-3;

    /**
     * Where the squared distances of a rectangle's points differ by less than this factor, the density of samples by area is nearly
     * constant.
     */
    private static final double EVEN = 1.25;

    /** From this solid angle on, the rounding of an angle of 180° leaves the shares u of a spherical rectangle right to 2^-20. */
    private static final double LEAST_PRECISE = 1e-9;

    private static final double RIGHT_ANGLE_ERROR = Scale.gamma(64);

    private final Vec3 corner;
    private final Vec3 right;
    private final Vec3 up;
    private final Vec3 unitRight;
    private final Vec3 unitUp;
    private final double width;
    private final double length;
    private final boolean rectangular;

    /** Makes a surface that emits from its front, or from both sides. */
    public ParallelogramLight(Vec3 corner, Vec3 right, Vec3 up, boolean twoSided) {
        this(corner, right, up, LightSides.of(twoSided));
    }

    /**
     * Makes a parallelogram.
     *
     * @param corner its lower left corner
     * @param right the edge from there to the lower right one
     * @param up the edge to the upper left one
     * @param sides that emit
     */
    public ParallelogramLight(Vec3 corner, Vec3 right, Vec3 up, LightSides sides) {
        this(corner, right, up, sides, up.cross(right));
    }

    private ParallelogramLight(Vec3 corner, Vec3 right, Vec3 up, LightSides sides, Vec3 product) {
        super(
                corner,
                product.normalized(),
                product.length(),
                sides,
                corner.plus(right.plus(up).times(0.5)),
                0.5 * diagonal(right, up) * (1 + Scale.gamma(16)));
        this.corner = corner;
        this.right = right;
        this.up = up;
        width = right.length();
        length = up.length();
        unitRight = right.normalized();
        unitUp = up.normalized();
        rectangular = Math.abs(unitRight.dot(unitUp)) <= RIGHT_ANGLE_ERROR;
    }

    private static double diagonal(Vec3 right, Vec3 up) {
        return Math.max(right.plus(up).length(), right.minus(up).length());
    }

    private SamplingChoice choice(LightSample s) {
        if (s.choice == SamplingChoice.UNDECIDED) {
            s.choice = decide(s);
        }
        return s.choice;
    }

    private SamplingChoice decide(LightSample s) {
        if (!faces(s)) {
            return SamplingChoice.ABSENT;
        }
        return rectangular ? decideRectangle(s) : decideTriangles(s);
    }

    private SamplingChoice decideRectangle(LightSample s) {
        SphericalRectangle r = s.rectangle;
        r.set(least(unitRight, s), width, least(unitUp, s), length, Math.abs(s.height));
        double nearest = r.nearest();
        double farthest = r.farthest();
        if (farthest <= EVEN * nearest) {
            return SamplingChoice.AREA;
        }
        r.measure();
        boolean uneven = farthest > 2 * nearest && r.solidAngle > LEAST_PRECISE;
        if (r.solidAngle < LEAST_SOLID_ANGLE && !uneven) {
            return SamplingChoice.AREA;
        }
        r.prepare();
        return SamplingChoice.SOLID_ANGLE;
    }

    /** The least coordinate of the rectangle along one of its edges, from the receiver. */
    private double least(Vec3 unitEdge, LightSample s) {
        return Products.dot(
                unitEdge.x(),
                unitEdge.y(),
                unitEdge.z(),
                corner.x() - s.cone.x,
                corner.y() - s.cone.y,
                corner.z() - s.cone.z);
    }

    private SamplingChoice decideTriangles(LightSample s) {
        double x = corner.x() - s.cone.x;
        double y = corner.y() - s.cone.y;
        double z = corner.z() - s.cone.z;
        double across = Math.abs(s.height) * area;
        double length0 = s.triangle.corner(0, x, y, z);
        double length1 = s.triangle.corner(1, x + right.x(), y + right.y(), z + right.z());
        double length2 = s.triangle.corner(2, x + up.x(), y + up.y(), z + up.z());
        s.triangle.measure(across / (length0 * length1 * length2));
        Vec3 diagonal = right.plus(up);
        length0 = s.secondTriangle.corner(0, x + diagonal.x(), y + diagonal.y(), z + diagonal.z());
        s.secondTriangle.corner(1, x + up.x(), y + up.y(), z + up.z());
        s.secondTriangle.corner(2, x + right.x(), y + right.y(), z + right.z());
        s.secondTriangle.measure(across / (length0 * length1 * length2));
        double solidAngle = s.triangle.solidAngle + s.secondTriangle.solidAngle;
        if (!(solidAngle >= LEAST_SOLID_ANGLE)) {
            return SamplingChoice.AREA;
        }
        s.triangle.prepare();
        s.secondTriangle.prepare();
        return SamplingChoice.SOLID_ANGLE;
    }

    @Override
    public void sample(LightSample s, double u, double v) {
        switch (choice(s)) {
            case SOLID_ANGLE -> sampleSolidAngle(s, u, v);
            case AREA -> {
                double x = Math.fma(u, right.x(), Math.fma(v, up.x(), corner.x() - s.cone.x));
                double y = Math.fma(u, right.y(), Math.fma(v, up.y(), corner.y() - s.cone.y));
                double z = Math.fma(u, right.z(), Math.fma(v, up.z(), corner.z() - s.cone.z));
                choose(s, x, y, z);
            }
            default -> s.absent();
        }
    }

    private void sampleSolidAngle(LightSample s, double u, double v) {
        if (rectangular) {
            SphericalRectangle r = s.rectangle;
            r.choose(u, v);
            double down = -s.height;
            s.toOffset(
                    Products.dot(unitRight.x(), unitUp.x(), normal.x(), r.x, r.y, down),
                    Products.dot(unitRight.y(), unitUp.y(), normal.y(), r.x, r.y, down),
                    Products.dot(unitRight.z(), unitUp.z(), normal.z(), r.x, r.y, down));
            s.cosine = s.height / s.length;
            s.pdf = 1 / r.solidAngle;
            return;
        }
        double both = s.triangle.solidAngle + s.secondTriangle.solidAngle;
        double share = s.triangle.solidAngle / both;
        boolean first = u < share;
        SphericalTriangle t = first ? s.triangle : s.secondTriangle;
        t.choose(first ? u / share : Math.min((u - share) / (1 - share), 1), v);
        choose(s, t, 1 / both);
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return switch (choice(s)) {
            case SOLID_ANGLE ->
                1 / (rectangular ? s.rectangle.solidAngle : s.triangle.solidAngle + s.secondTriangle.solidAngle);
            case AREA -> density(distance, cosine);
            default -> 0;
        };
    }

    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        if (!faces(s)) {
            return 0;
        }
        if (rectangular && !isFar(s)) {
            double e = whole(s, nx, ny, nz);
            if (e == e) {
                return e;
            }
        }
        HorizonPolygon p = s.polygon;
        p.begin(corner.x() - s.cone.x, corner.y() - s.cone.y, corner.z() - s.cone.z);
        p.add(right.x(), right.y(), right.z());
        p.add(right.x() + up.x(), right.y() + up.y(), right.z() + up.z());
        p.add(up.x(), up.y(), up.z());
        return irradianceOfPolygon(s, nx, ny, nz);
    }

    /** The irradiance of a rectangle above the horizon; NaN for others. */
    private double whole(LightSample s, double nx, double ny, double nz) {
        return LambertRectangle.irradiance(
                least(unitRight, s),
                width,
                least(unitUp, s),
                length,
                -s.height,
                Products.dot(unitRight.x(), unitRight.y(), unitRight.z(), nx, ny, nz),
                Products.dot(unitUp.x(), unitUp.y(), unitUp.z(), nx, ny, nz),
                Products.dot(normal.x(), normal.y(), normal.z(), nx, ny, nz));
    }

    @Override
    public boolean reaches(LightSample s, double nx, double ny, double nz) {
        if (!faces(s)) {
            return false;
        }
        double base = nx * (corner.x() - s.cone.x) + ny * (corner.y() - s.cone.y) + nz * (corner.z() - s.cone.z);
        double across = nx * right.x() + ny * right.y() + nz * right.z();
        double along = nx * up.x() + ny * up.y() + nz * up.z();
        return base + Math.max(across, 0) + Math.max(along, 0) > 0;
    }

    @Override
    public boolean hasClosedForm() {
        return true;
    }

    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        point.set(
                Math.fma(u, right.x(), Math.fma(v, up.x(), corner.x())),
                Math.fma(u, right.y(), Math.fma(v, up.y(), corner.y())),
                Math.fma(u, right.z(), Math.fma(v, up.z(), corner.z())));
        point.setNormal(normal.x(), normal.y(), normal.z());
    }

    /**
     * The numbers that code on another device computes with: corner, both edges, these as unit vectors, the normal, the lengths of the edges,
     * and the area; null unless it is a rectangle.
     */
    public double[] flatForm() {
        if (!rectangular) {
            return null;
        }
        double[] all = new double[21];
        int at = 0;
        for (Vec3 v : new Vec3[] {corner, right, up, unitRight, unitUp, normal}) {
            all[at++] = v.x();
            all[at++] = v.y();
            all[at++] = v.z();
        }
        all[at++] = width;
        all[at++] = length;
        all[at] = area;
        return all;
    }

    /** The sides that shine. */
    public LightSides sides() {
        return sides;
    }

    @Override
    public double[] parameters() {
        return Numbers.of(sides, corner, right, up);
    }
}
