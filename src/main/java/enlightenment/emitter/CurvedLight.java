package enlightenment.emitter;

import enlightenment.math.Vec3;

/** A curved light that is sampled uniformly over its area. */
abstract sealed class CurvedLight extends SurfaceLight permits LateralLight, TorusLight, InnerSphereLight {
    /**
     * Makes a light within a bounding ball.
     *
     * @param center of the ball
     */
    CurvedLight(Vec3 center, double ballRadius, double area, LightSides sides) {
        super(center, ballRadius, area, sides);
    }

    @Override
    public final void sample(LightSample s, double u, double v) {
        samplePoint(u, v, s.point);
        s.toPoint(area, sides);
    }

    @Override
    public final double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return LightSample.pdfOfArea(area, sides, distance, cosine);
    }

    @Override
    public final double irradiance(LightSample s, double nx, double ny, double nz) {
        return Horizon.irradianceIfBelow(s.cone, nx, ny, nz);
    }

    @Override
    public final Vec3 flatNormal() {
        return Vec3.ZERO;
    }
}
