package enlightenment.emitter;

import enlightenment.math.Vec3;

/** A curved surface that is sampled evenly over its area. */
abstract sealed class CurvedLight implements AreaLight permits LateralLight, TorusLight {
    final Vec3 center;
    final double area;
    final boolean twoSided;
    private final double ballRadius;

    /**
     * A surface inside of a ball.
     *
     * @param center of the ball
     */
    CurvedLight(Vec3 center, double ballRadius, double area, boolean twoSided) {
        this.center = center;
        this.ballRadius = ballRadius;
        this.area = area;
        this.twoSided = twoSided;
    }

    @Override
    public final void aim(LightSample s, double x, double y, double z) {
        s.aim(center.x(), center.y(), center.z(), ballRadius, x, y, z);
    }

    @Override
    public final void sample(LightSample s, double u, double v) {
        samplePoint(u, v, s.point);
        s.toPoint(area, twoSided);
    }

    @Override
    public final double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return LightSample.pdfOfArea(area, twoSided, distance, cosine);
    }

    @Override
    public final double irradiance(LightSample s, double nx, double ny, double nz) {
        return Horizon.irradianceIfBelow(s.cone, nx, ny, nz);
    }

    @Override
    public final double area() {
        return area;
    }

    @Override
    public final boolean isTwoSided() {
        return twoSided;
    }

    @Override
    public final Vec3 ballCenter() {
        return center;
    }

    @Override
    public final double ballRadius() {
        return ballRadius;
    }

    @Override
    public final Vec3 flatNormal() {
        return Vec3.ZERO;
    }
}
