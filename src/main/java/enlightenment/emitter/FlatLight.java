package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;

/** A part of a plane that emits from one of its sides or from both. */
abstract sealed class FlatLight extends SurfaceLight permits ParallelogramLight, TriangleLight, DiskLight {
    /** The unit normal, on the front. */
    final Vec3 normal;

    /** A point of the plane. */
    private final Vec3 foot;

    FlatLight(Vec3 foot, Vec3 normal, double area, LightSides sides, Vec3 center, double radius) {
        super(center, radius, area, sides);
        this.foot = foot;
        this.normal = normal;
    }

    @Override
    public final void aim(LightSample s, double x, double y, double z) {
        super.aim(s, x, y, z);
        s.height = -Products.dot(normal.x(), normal.y(), normal.z(), foot.x() - x, foot.y() - y, foot.z() - z);
    }

    /** Whether the receiver is on an emitting side. */
    final boolean faces(LightSample s) {
        return sides.shineAt(s.height);
    }

    /** Sets the sample to a point, sampled uniformly over the area, at this offset from the receiver. */
    final void choose(LightSample s, double x, double y, double z) {
        s.toOffset(x, y, z);
        s.cosine = s.height / s.length;
        s.pdf = density(s.length, s.cosine);
    }

    /** The density per solid angle of a point that is sampled uniformly over the area. */
    final double density(double distance, double cosine) {
        return LightSample.pdfOfArea(area, sides, distance, cosine);
    }

    /** Sets the sample to the point of the plane in the direction that the triangle has sampled. */
    final void choose(LightSample s, SphericalTriangle t, double density) {
        double cosine = -Products.dot(t.x, t.y, t.z, normal.x(), normal.y(), normal.z());
        double distance = s.height / cosine;
        s.set(t.x, t.y, t.z, distance);
        s.cosine = cosine;
        s.pdf = distance > 0 && distance <= Double.MAX_VALUE ? density : 0;
    }

    /** The irradiance of the sample's polygon, which is the light. */
    final double irradianceOfPolygon(LightSample s, double nx, double ny, double nz) {
        return s.polygon.irradiance(nx, ny, nz, Math.abs(s.height), isFar(s));
    }

    /** Whether Lambert's sum would cancel at the receiver's distance. */
    final boolean isFar(LightSample s) {
        return 2 * ballRadius() < HorizonPolygon.FAR * s.cone.distance;
    }

    @Override
    public final Vec3 flatNormal() {
        return sides == LightSides.BACK ? normal.negated() : normal;
    }
}
