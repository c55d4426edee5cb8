package enlightenment.emitter;

import enlightenment.frame.BallCone;
import enlightenment.frame.Basis;

/** An emitter as it is seen from a point, and one point of it that was sampled. A mutable work object, one per thread. */
public sealed class EmitterView permits LightSample {
    /** The viewer and the cone of directions that the emitter lies in: that of the ball around it. */
    public final BallCone cone;

    /** The direction to the last point sampled, of length 1. */
    public double dx;

    public double dy;
    public double dz;

    /** The distance to that point. */
    public double length;

    final double[] disk = new double[3];

    /** Half of the chord that the last direction cuts off a ball that is seen from outside. */
    double half;

    /** The normal in the cone's basis: its component along the axis, the length of the rest, and the direction of the rest. */
    double normalAlong;

    double normalAcross;
    double normalA;
    double normalB;

    private final Basis basis = new Basis();
    private boolean hasBasis;

    /** @param cone is set by whoever aims the view, before {@link #aim} */
    public EmitterView(BallCone cone) {
        this.cone = cone;
    }

    /** Tells that the cone has been set anew. */
    public final void aim() {
        hasBasis = false;
    }

    /** Two unit vectors that complete the cone's axis. */
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
