package enlightenment.emitter;

import enlightenment.frame.BallCone;

/** Irradiance bounds of any light by its bounding ball. */
final class Horizon {
    private Horizon() {}

    /** 0 if no point of the ball is above the horizon of a receiver with the unit normal n; else NaN. */
    static double irradianceIfBelow(BallCone cone, double nx, double ny, double nz) {
        double k = nx * cone.wx + ny * cone.wy + nz * cone.wz;
        return !cone.inside && k <= -cone.sine ? 0 : Double.NaN;
    }
}
