package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A triangle, sampled evenly over the solid angle that it covers as a {@link SphericalTriangle}, or over its area if that is far or nearly a
 * half space. Its normal, which points to its front, is (b − a) × (c − a).
 */
public final class TriangleLight implements AreaLight {
    private final Vec3 a;
    private final Vec3 toB;
    private final Vec3 toC;
    private final boolean twoSided;
    private final Vec3 normal;
    private final double area;
    private final Vec3 center;
    private final double radius;

    /**
     * A triangle that spans an area.
     *
     * @param twoSided whether its back shines as well
     */
    public TriangleLight(Vec3 a, Vec3 b, Vec3 c, boolean twoSided) {
        this.a = a;
        this.twoSided = twoSided;
        toB = b.minus(a);
        toC = c.minus(a);
        Vec3 product = toB.cross(toC);
        normal = product.normalized();
        area = 0.5 * product.length();
        Vec3 middle = toB.plus(toC).times(1.0 / 3);
        center = a.plus(middle);
        double far = Math.max(
                middle.length(),
                Math.max(toB.minus(middle).length(), toC.minus(middle).length()));
        radius = far * (1 + Scale.gamma(16)) + Scale.gamma(4) * center.maxAbs();
    }

    @Override
    public void aim(LightSample s, double x, double y, double z) {
        s.aim(center.x(), center.y(), center.z(), radius, x, y, z);
        s.height = -Products.dot(normal.x(), normal.y(), normal.z(), a.x() - x, a.y() - y, a.z() - z);
    }

    private SamplingChoice choice(LightSample s) {
        if (s.choice == SamplingChoice.UNDECIDED) {
            s.choice = decide(s);
        }
        return s.choice;
    }

    private SamplingChoice decide(LightSample s) {
        if (!(twoSided ? s.height != 0 : s.height > 0)) {
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
        if (!(t.solidAngle >= ParallelogramLight.LEAST_SOLID_ANGLE
                && t.solidAngle <= ParallelogramLight.LARGEST_SOLID_ANGLE)) {
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
                ParallelogramLight.onPlane(s, s.triangle, normal, 1 / s.triangle.solidAngle);
            }
            case AREA -> {
                double root = Math.sqrt(u);
                double p = root * (1 - v);
                double q = root * v;
                double x = Math.fma(p, toB.x(), Math.fma(q, toC.x(), a.x() - s.cone.x));
                double y = Math.fma(p, toB.y(), Math.fma(q, toC.y(), a.y() - s.cone.y));
                double z = Math.fma(p, toB.z(), Math.fma(q, toC.z(), a.z() - s.cone.z));
                s.toOffset(x, y, z);
                s.cosine = s.height / s.length;
                s.pdf = LightSample.pdfOfArea(area, twoSided, s.length, s.cosine);
            }
            default -> s.absent();
        }
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return switch (choice(s)) {
            case SOLID_ANGLE -> 1 / s.triangle.solidAngle;
            case AREA -> LightSample.pdfOfArea(area, twoSided, distance, cosine);
            default -> 0;
        };
    }

    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        if (!(twoSided ? s.height != 0 : s.height > 0)) {
            return 0;
        }
        HorizonPolygon p = s.polygon;
        p.begin(a.x() - s.cone.x, a.y() - s.cone.y, a.z() - s.cone.z);
        p.add(toB.x(), toB.y(), toB.z());
        p.add(toC.x(), toC.y(), toC.z());
        return p.irradiance(nx, ny, nz, Math.abs(s.height), 2 * radius < HorizonPolygon.FAR * s.cone.distance);
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public boolean isTwoSided() {
        return twoSided;
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
    public Vec3 ballCenter() {
        return center;
    }

    @Override
    public double ballRadius() {
        return radius;
    }

    @Override
    public Vec3 flatNormal() {
        return normal;
    }

    @Override
    public double[] parameters() {
        return Numbers.of(twoSided, a, toB, toC);
    }
}
