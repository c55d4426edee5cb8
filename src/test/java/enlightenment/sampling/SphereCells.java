package enlightenment.sampling;

import enlightenment.math.Vec3;

/**
 * Integrals of functions of a direction over cells of the sphere: rings around an axis, cut by sectors. Rings may be fine next to the
 * axis, where a function has a peak. By Simpson's rule, which is refined where it has not converged.
 */
public final class SphereCells {
    /** A function of a direction, per steradian. */
    @FunctionalInterface
    public interface Density {
        double at(double x, double y, double z);
    }

    private static final int DEPTH = 6;

    private final Vec3 axis;
    private final Vec3 e;
    private final Vec3 f;
    private final double focus;
    private final int rings;
    private final int sectors;

    /**
     * Cells around an axis.
     *
     * @param axis a unit vector
     * @param focus 1 for rings of equal area; with p the k-th of n rings ends where 1 − cosθ is 2(k/n)^p
     * @param rings how many, from the axis to its opposite
     * @param sectors of each ring
     */
    public SphereCells(Vec3 axis, double focus, int rings, int sectors) {
        this.axis = axis;
        this.focus = focus;
        this.rings = rings;
        this.sectors = sectors;
        e = (Math.abs(axis.x()) < 0.9 ? Vec3.X : Vec3.Y).cross(axis).normalized();
        f = axis.cross(e);
    }

    /** How many cells there are. */
    public int count() {
        return rings * sectors;
    }

    /** The cell of a direction, a unit vector. */
    public int cell(double x, double y, double z) {
        double dx = x - axis.x();
        double dy = y - axis.y();
        double dz = z - axis.z();
        double t = Math.pow(Math.min((dx * dx + dy * dy + dz * dz) / 4, 1), 1 / focus);
        double turn = Math.atan2(x * f.x() + y * f.y() + z * f.z(), x * e.x() + y * e.y() + z * e.z()) / (2 * Math.PI);
        int ring = Math.min((int) (rings * t), rings - 1);
        return ring * sectors + Math.min((int) (sectors * (turn < 0 ? turn + 1 : turn)), sectors - 1);
    }

    /** The integrals over all cells, each with about this absolute error. */
    public double[] integrals(Density density, double tolerance) {
        double[] all = new double[count()];
        for (int k = 0; k < all.length; k++) {
            double t = (double) (k / sectors) / rings;
            double turn = (double) (k % sectors) / sectors;
            all[k] = refined(density, t, turn, 1.0 / rings, 1.0 / sectors, tolerance, DEPTH);
        }
        return all;
    }

    /** The integral over the sphere. */
    public double integral(Density density, double tolerance) {
        double sum = 0;
        for (double part : integrals(density, tolerance)) {
            sum += part;
        }
        return sum;
    }

    private double refined(Density g, double t, double turn, double dt, double dTurn, double tolerance, int depth) {
        double whole = simpson(g, t, turn, dt, dTurn);
        double ht = dt / 2;
        double hTurn = dTurn / 2;
        double parts = simpson(g, t, turn, ht, hTurn)
                + simpson(g, t + ht, turn, ht, hTurn)
                + simpson(g, t, turn + hTurn, ht, hTurn)
                + simpson(g, t + ht, turn + hTurn, ht, hTurn);
        if (Math.abs(parts - whole) <= tolerance || depth == 0) {
            return parts;
        }
        return refined(g, t, turn, ht, hTurn, tolerance / 2, depth - 1)
                + refined(g, t + ht, turn, ht, hTurn, tolerance / 2, depth - 1)
                + refined(g, t, turn + hTurn, ht, hTurn, tolerance / 2, depth - 1)
                + refined(g, t + ht, turn + hTurn, ht, hTurn, tolerance / 2, depth - 1);
    }

    private double simpson(Density g, double t, double turn, double dt, double dTurn) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                double weight = (i == 1 ? 4 : 1) * (j == 1 ? 4 : 1);
                sum += weight * at(g, t + dt * i / 2, turn + dTurn * j / 2);
            }
        }
        return sum * dt * dTurn / 36;
    }

    /** The function times the solid angle per unit of t and turn. */
    private double at(Density g, double t, double turn) {
        double below = 2 * Math.pow(t, focus);
        double phi = 2 * Math.PI * turn;
        double r = Math.sqrt(Math.max(below * (2 - below), 0));
        double c = r * Math.cos(phi);
        double s = r * Math.sin(phi);
        double h = 1 - below;
        double value = g.at(
                Math.fma(h, axis.x(), c * e.x() + s * f.x()),
                Math.fma(h, axis.y(), c * e.y() + s * f.y()),
                Math.fma(h, axis.z(), c * e.z() + s * f.z()));
        return value * 2 * focus * Math.pow(t, focus - 1) * 2 * Math.PI;
    }
}
