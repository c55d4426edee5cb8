package enlightenment.emitter;

import enlightenment.frame.BallCone;
import enlightenment.frame.Basis;

/** An emitter as seen from a point, with a sampled point of it. A mutable work object, one per thread. */
public sealed class EmitterView permits LightSample {
    /** The viewer as apex, and the cone of directions to the emitter's bounding ball. */
    public final BallCone cone;

    /** The unit direction to the sampled point. */
    public double dx;

    public double dy;
    public double dz;

    /** The distance to the sampled point, in the frame. */
    public double length;

    final double[] disk = new double[3];

    /** Half of the chord that the sampled direction cuts off a ball seen from outside, in the frame. */
    double half;

    /** The prepared normal in the cone's basis: its component along the axis, the length of the rest, and the direction of the rest. */
    double normalAlong;

    double normalAcross;
    double normalA;
    double normalB;

    private final Basis basis = new Basis();
    private boolean hasBasis;

    /**
     * @param cone set by the caller before each {@link #aim}
     */
    public EmitterView(BallCone cone) {
        this.cone = cone;
    }

    /** Resets what depends on the cone, after it has been set anew. */
    public final void aim() {
        hasBasis = false;
    }

    /** The two unit vectors that complete the cone's axis to a basis. */
    final Basis basis() {
        if (!hasBasis) {
            basis.around(cone.wx, cone.wy, cone.wz);
            hasBasis = true;
        }
        return basis;
    }

    final void set(double x, double y, double z, double len) {
        dx = x;
        dy = y;
        dz = z;
        length = len;
    }
}
