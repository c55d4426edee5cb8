package enlightenment.emitter;

import enlightenment.math.Vec3;

/** A light with a surface that may emit from one of its sides or from both, with a bounding ball. */
abstract sealed class SurfaceLight implements AreaLight permits FlatLight, CurvedLight {
    /** The centre of the bounding ball. */
    private final Vec3 ballCenter;

    private final double ballRadius;
    final double area;
    final LightSides sides;

    SurfaceLight(Vec3 ballCenter, double ballRadius, double area, LightSides sides) {
        this.ballCenter = ballCenter;
        this.ballRadius = ballRadius;
        this.area = area;
        this.sides = sides;
    }

    @Override
    public void aim(LightSample s, double x, double y, double z) {
        s.aim(ballCenter.x(), ballCenter.y(), ballCenter.z(), ballRadius, x, y, z);
    }

    @Override
    public final double area() {
        return area;
    }

    @Override
    public final boolean isTwoSided() {
        return sides == LightSides.BOTH;
    }

    @Override
    public final Vec3 ballCenter() {
        return ballCenter;
    }

    @Override
    public final double ballRadius() {
        return ballRadius;
    }
}
