package enlightenment.importer.gltf;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The rotation of a node about one axis, by angles that go on beyond a full turn: linear angles are spherical interpolation. */
final class Spin {
    /** Quaternions are of floats: within this of an axis is on it. Four units in the last place. */
    private static final double FLOAT_ROUNDING = 0x1p-21;

    private final Vec3 axis;
    private final SampledProperty angles;

    private Spin(Vec3 axis, SampledProperty angles) {
        this.axis = axis;
        this.angles = angles;
    }

    /** The axis, of length 1. */
    Vec3 axis() {
        return axis;
    }

    /** Degrees, one number for each frame. */
    SampledProperty angles() {
        return angles;
    }

    /** The spin of quaternions of length 1; empty if they have more than one axis. */
    static Optional<Spin> of(SampledProperty quaternions) {
        Vec3 axis = Vec3.ZERO;
        for (double[] q : quaternions.values()) {
            Vec3 v = new Vec3(q[0], q[1], q[2]);
            axis = v.lengthSquared() > axis.lengthSquared() ? v : axis;
        }
        Vec3 unit = axis.equals(Vec3.ZERO) ? Vec3.Y : axis.normalized();
        for (double[] q : quaternions.values()) {
            if (new Vec3(q[0], q[1], q[2]).cross(unit).length() > FLOAT_ROUNDING) {
                return Optional.empty();
            }
        }
        return Optional.of(
                new Spin(unit, new SampledProperty(quaternions.frames(), angles(quaternions.values(), unit))));
    }

    private static List<double[]> angles(List<double[]> quaternions, Vec3 axis) {
        List<double[]> angles = new ArrayList<>();
        double half = 0;
        for (int i = 0; i < quaternions.size(); i++) {
            double[] q = quaternions.get(i);
            double next = StrictMath.atan2(new Vec3(q[0], q[1], q[2]).dot(axis), q[3]);
            double step = next - half;
            if (i > 0) {
                step -= 2 * StrictMath.PI * StrictMath.rint(step / (2 * StrictMath.PI));
                // q and −q are one rotation: the shorter arc, as Quaternions.slerp takes it.
                if (Quaternions.dot(quaternions.get(i - 1), q) < 0) {
                    step -= StrictMath.copySign(StrictMath.PI, step);
                }
            }
            half += step;
            angles.add(new double[] {2 * StrictMath.toDegrees(half)});
        }
        return angles;
    }
}
