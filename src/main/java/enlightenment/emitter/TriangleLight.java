package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/**
 * A triangle, sampled uniformly over its solid angle as a {@link SphericalTriangle}, or over its area if it is far. Its normal, on its
 * front, is (b − a) × (c − a).
 */
public final class TriangleLight extends FlatLight {
    private final Vec3 a;
    private final Vec3 toB;
    private final Vec3 toC;

    /** Makes a surface that emits from its front, or from both sides. */
    public TriangleLight(Vec3 a, Vec3 b, Vec3 c, boolean twoSided) {
        this(a, b, c, LightSides.of(twoSided));
    }

    /**
     * Makes a triangle with an area.
     *
     * @param sides that emit
     */
    public TriangleLight(Vec3 a, Vec3 b, Vec3 c, LightSides sides) {
        this(a, b.minus(a), c.minus(a), b.minus(a).cross(c.minus(a)), sides);
    }

    private TriangleLight(Vec3 a, Vec3 toB, Vec3 toC, Vec3 product, LightSides sides) {
        super(a, product.normalized(), 0.5 * product.length(), sides, a.plus(middle(toB, toC)), radius(a, toB, toC));
        this.a = a;
        this.toB = toB;
        this.toC = toC;
    }

    private static Vec3 middle(Vec3 toB, Vec3 toC) {
        return toB.plus(toC).times(1.0 / 3);
    }

    private static double radius(Vec3 a, Vec3 toB, Vec3 toC) {
        Vec3 middle = middle(toB, toC);
        double far = Math.max(
                middle.length(),
                Math.max(toB.minus(middle).length(), toC.minus(middle).length()));
        return far * (1 + Scale.gamma(16)) + Scale.gamma(4) * a.plus(middle).maxAbs();
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
        double x = a.x() - s.cone.x;
        double y = a.y() - s.cone.y;
        double z = a.z() - s.cone.z;
        SphericalTriangle t = s.triangle;
        double lengths = t.corner(0, x, y, z)
                * t.corner(1, x + toB.x(), y + toB.y(), z + toB.z())
                * t.corner(2, x + toC.x(), y + toC.y(), z + toC.z());
        t.measure(2 * area * Math.abs(s.height) / lengths);
        if (!(t.solidAngle >= ParallelogramLight.LEAST_SOLID_ANGLE)) {
            return SamplingChoice.AREA;
        }
        t.prepare();
        return SamplingChoice.SOLID_ANGLE;
    }

    @Override
    public void sample(LightSample s, double u, double v) {
        switch (choice(s)) {
            case SOLID_ANGLE -> {
                s.triangle.choose(u, v);
                choose(s, s.triangle, 1 / s.triangle.solidAngle);
            }
            case AREA -> {
                double root = Math.sqrt(u);
                double p = root * (1 - v);
                double q = root * v;
                double x = Math.fma(p, toB.x(), Math.fma(q, toC.x(), a.x() - s.cone.x));
                double y = Math.fma(p, toB.y(), Math.fma(q, toC.y(), a.y() - s.cone.y));
                double z = Math.fma(p, toB.z(), Math.fma(q, toC.z(), a.z() - s.cone.z));
                choose(s, x, y, z);
            }
            default -> s.absent();
        }
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return switch (choice(s)) {
            case SOLID_ANGLE -> 1 / s.triangle.solidAngle;
            case AREA -> density(distance, cosine);
            default -> 0;
        };
    }

    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        if (!faces(s)) {
            return 0;
        }
        HorizonPolygon p = s.polygon;
        p.begin(a.x() - s.cone.x, a.y() - s.cone.y, a.z() - s.cone.z);
        p.add(toB.x(), toB.y(), toB.z());
        p.add(toC.x(), toC.y(), toC.z());
        return irradianceOfPolygon(s, nx, ny, nz);
    }

    @Override
    public boolean reaches(LightSample s, double nx, double ny, double nz) {
        if (!faces(s)) {
            return false;
        }
        double base = nx * (a.x() - s.cone.x) + ny * (a.y() - s.cone.y) + nz * (a.z() - s.cone.z);
        double ofB = nx * toB.x() + ny * toB.y() + nz * toB.z();
        double ofC = nx * toC.x() + ny * toC.y() + nz * toC.z();
        return base + Math.max(Math.max(ofB, ofC), 0) > 0;
    }

    @Override
    public boolean hasClosedForm() {
        return true;
    }

    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        double root = Math.sqrt(u);
        double p = root * (1 - v);
        double q = root * v;
        point.set(
                Math.fma(p, toB.x(), Math.fma(q, toC.x(), a.x())),
                Math.fma(p, toB.y(), Math.fma(q, toC.y(), a.y())),
                Math.fma(p, toB.z(), Math.fma(q, toC.z(), a.z())));
        point.setNormal(normal.x(), normal.y(), normal.z());
    }

    @Override
    public double[] parameters() {
        return Numbers.of(sides, a, toB, toC);
    }
}
