package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** A ball that emits inwards, sampled uniformly over its area. */
public final class InnerSphereLight extends CurvedLight {
    private final SphereLight ball;

    /** Makes the inside of a ball. */
    public InnerSphereLight(Vec3 center, double radius) {
        super(center, radius * (1 + Scale.gamma(8)), 4 * Math.PI * radius * radius, LightSides.BACK);
        ball = new SphereLight(center, radius);
    }

    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        ball.samplePoint(u, v, point);
    }

    @Override
    public double[] parameters() {
        return ball.parameters();
    }
}
