package enlightenment.emitter;

import enlightenment.math.Vec3;

/**
 * A cone that encloses normals.
 *
 * @param angle between the axis and its side, 0..π; π encloses all
 */
record NormalCone(Vec3 axis, double angle) {
    static final NormalCone ALL = new NormalCone(Vec3.Y, Math.PI);

    private static final double MEASURE_OF_ALL = new NormalCone(ALL.axis, ALL.angle).measure();

    /** A bound of the rounding of an angle between unit vectors, in radians. */
    static final double SLACK = 0x1p-24;

    /** A cone around both cones, as small as possible. */
    NormalCone union(NormalCone o) {
        if (this == ALL && o == ALL) {
            return ALL;
        }
        double between = StrictMath.acos(Math.min(Math.max(axis.dot(o.axis), -1), 1));
        if (between + o.angle <= angle) {
            return this;
        }
        if (between + angle <= o.angle) {
            return o;
        }
        double half = 0.5 * (angle + between + o.angle) + SLACK;
        Vec3 across = o.axis.minus(axis.times(axis.dot(o.axis)));
        if (half >= Math.PI || across.maxAbs() == 0) {
            return between < SLACK ? new NormalCone(axis, Math.max(angle, o.angle) + SLACK) : ALL;
        }
        double turn = half - angle;
        Vec3 middle = axis.times(StrictMath.cos(turn)).plus(across.normalized().times(StrictMath.sin(turn)));
        return new NormalCone(middle.normalized(), half);
    }

    /** The measure of directions into which surfaces with these normals emit, weighted by the cosine: Conty and Kulla, section 4.3. */
    double measure() {
        // Most lights emit in all directions, and building a large tree calls this often.
        if (this == ALL) {
            return MEASURE_OF_ALL;
        }
        double w = Math.min(angle + 0.5 * Math.PI, Math.PI);
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        return 2 * Math.PI * (1 - cos)
                + 0.5 * Math.PI * (2 * w * sin - StrictMath.cos(angle - 2 * w) - 2 * angle * sin + cos);
    }
}
