package enlightenment.emitter;

import enlightenment.frame.BallCone;
import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.sampling.Warp;

/**
 * A ball, sampled uniformly over the solid angle that it subtends; from inside, over all directions. It is its own bounding ball, so the
 * view's cone is exactly that of the directions that hit it.
 */
public final class SphereEmitter implements Emitter {
    private final Vec3 center;
    private final double radius;

    /** Makes a ball. */
    public SphereEmitter(Vec3 center, double radius) {
        this.center = center;
        this.radius = radius;
    }

    @Override
    public Vec3 ballCenter() {
        return center;
    }

    @Override
    public double ballRadius() {
        return radius;
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    private static double toCenter(BallCone cone, double nx, double ny, double nz) {
        return nx * cone.wx + ny * cone.wy + nz * cone.wz;
    }

    /** Over the cone around w it is (n·w)(1 + cosθmax)/2. */
    @Override
    public double meanCosine(EmitterView view, double nx, double ny, double nz) {
        if (view.cone.inside) {
            return Double.NaN;
        }
        double toCenter = toCenter(view.cone, nx, ny, nz);
        double sine = view.cone.sine;
        if (toCenter >= sine) {
            return toCenter * (1 - view.cone.oneMinusCosine() / 2);
        }
        return toCenter <= -sine ? 0 : Double.NaN;
    }

    @Override
    public void sample(EmitterView view, double u, double v) {
        Warp.toDisk(u, v, view.disk);
        if (view.cone.inside) {
            sampleAround(view);
        } else {
            sampleCone(view);
        }
    }

    private void sampleCone(EmitterView view) {
        double down = view.disk[2] * view.cone.oneMinusCosine();
        double cos = 1 - down;
        // sinθ over the distance from the disk's centre: the disk's x and y need no division by it.
        double spread = Math.sqrt(view.cone.oneMinusCosine() * (2 - down));
        double s = view.disk[0] * spread;
        double t = view.disk[1] * spread;
        setOffset(view, cos, s, t, down * (2 - down));
    }

    /** Uniform over all directions: the disk mapped to the sphere by Lambert's equal-area projection. */
    private void sampleAround(EmitterView view) {
        BallCone cone = view.cone;
        double q = view.disk[2];
        double spread = 2 * Math.sqrt(Math.max(1 - q, 0));
        double x = view.disk[0] * spread;
        double y = view.disk[1] * spread;
        double z = 1 - 2 * q;
        double distance = cone.distance;
        double along = toCenter(cone, x, y, z) * distance;
        double half = Math.sqrt(Math.max(radius * radius - distance * distance + along * along, 0));
        view.set(x, y, z, along + half);
    }

    @Override
    public double pdf(EmitterView view) {
        return view.cone.inside ? 1 / (4 * Math.PI) : 1 / (2 * Math.PI * view.cone.oneMinusCosine());
    }

    @Override
    public double pdf(EmitterView view, double x, double y, double z) {
        BallCone cone = view.cone;
        if (!cone.inside) {
            double sx = y * cone.wz - z * cone.wy;
            double sy = z * cone.wx - x * cone.wz;
            double sz = x * cone.wy - y * cone.wx;
            if (toCenter(cone, x, y, z) <= 0 || sx * sx + sy * sy + sz * sz > cone.sine * cone.sine) {
                return 0;
            }
        }
        return pdf(view);
    }

    @Override
    public void prepareByCosine(EmitterView view, double nx, double ny, double nz) {
        Basis basis = view.basis();
        double na = nx * basis.ax + ny * basis.ay + nz * basis.az;
        double nb = nx * basis.bx + ny * basis.by + nz * basis.bz;
        view.normalAlong = toCenter(view.cone, nx, ny, nz);
        view.normalAcross = Math.sqrt(na * na + nb * nb);
        view.normalA = view.normalAcross > 0 ? na / view.normalAcross : 1;
        view.normalB = view.normalAcross > 0 ? nb / view.normalAcross : 0;
    }

    /**
     * Projected along the normal, directions whose density is proportional to the cosine are uniform in an ellipse: its centre is
     * cosθmax times the axis, its semi-axes are sinθmax and sinθmax·(n·w). With (a, b) in the unit disk, the component of a direction
     * along the normal is c·cosθmax + δ, where δ is computed without cancellation, so that small lights keep their digits.
     */
    @Override
    public void sampleByCosine(EmitterView view, double u, double v) {
        Warp.toDisk(u, v, view.disk);
        mapDisk(view, view.disk[0], view.disk[1]);
    }

    @Override
    public void sampleDisk(EmitterView view, double p, double q) {
        mapDisk(view, Math.fma(p, view.normalA, q * view.normalB), Math.fma(q, view.normalA, -p * view.normalB));
    }

    private void mapDisk(EmitterView view, double x, double y) {
        BallCone cone = view.cone;
        double normalAlong = view.normalAlong;
        double normalAcross = view.normalAcross;
        double a = normalAlong * x;
        double least = normalAlong * cone.cosine;
        double excess = cone.sine * Math.fma(2 * cone.cosine * normalAcross, a, cone.sine * (1 - a * a - y * y));
        double square = least * least + excess;
        double sum = square > 0 ? least + Math.sqrt(square) : least;
        double delta = sum > 0 ? excess / sum : 0;
        double p = Math.fma(normalAcross, delta, cone.sine * normalAlong * a);
        double q = cone.sine * y;
        double middle = Math.fma(cone.cosine, normalAcross, -cone.sine * a);
        double along = Math.fma(middle, normalAcross, (least + delta) * normalAlong);
        double s = p * view.normalA - q * view.normalB;
        double t = p * view.normalB + q * view.normalA;
        setOffset(view, along, s, t, s * s + t * t);
    }

    /** Sets the direction with the component cos along the cone's axis, s and t across it, and sin2 = s² + t². */
    private void setOffset(EmitterView view, double cos, double s, double t, double sin2) {
        BallCone cone = view.cone;
        Basis basis = view.basis();
        double distance = cone.distance;
        double half2 = radius * radius - distance * distance * sin2;
        double half = half2 > 0 ? Math.sqrt(half2) : 0;
        view.half = half;
        view.set(
                Math.fma(cos, cone.wx, Math.fma(s, basis.ax, t * basis.bx)),
                Math.fma(cos, cone.wy, Math.fma(s, basis.ay, t * basis.by)),
                Math.fma(cos, cone.wz, Math.fma(s, basis.az, t * basis.bz)),
                distance * cos - half);
    }
}
