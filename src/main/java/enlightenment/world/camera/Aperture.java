package enlightenment.world.camera;

import enlightenment.frame.Rotation;
import enlightenment.sampling.Warp;
import java.util.Arrays;

/** Samples the aperture of a thin lens uniformly by area: a disk or a regular polygon in the circle of radius 1. Immutable. */
final class Aperture {
    static final Aperture ROUND = new Aperture(0, 0);

    /** The polygon's corners, of which the first stands again behind the last; empty for a disk. */
    private final double[] x;

    private final double[] y;

    /**
     * @param blades the number of corners; 0 for a disk
     * @param rotation the angle of a corner in degrees, from +x towards +y
     */
    Aperture(int blades, double rotation) {
        int n = blades == 0 ? 0 : blades + 1;
        x = new double[n];
        y = new double[n];
        for (int k = 0; k < blades; k++) {
            double angle = rotation + 360 * (double) k / blades;
            x[k] = Rotation.cos(angle);
            y[k] = Rotation.sin(angle);
        }
        if (blades > 0) {
            x[blades] = x[0];
            y[blades] = y[0];
        }
    }

    /**
     * Maps the unit square to the aperture, preserving area.
     *
     * @param out receives x and y; has three elements
     */
    void sample(double u, double v, double[] out) {
        if (x.length == 0) {
            Warp.toDisk(u, v, out);
            return;
        }
        int blades = x.length - 1;
        int k = Math.min((int) (u * blades), blades - 1);
        // The triangle between the centre and an edge: the square root of what is left of u is the distance from the
        // centre.
        double far = Math.sqrt(u * blades - k);
        out[0] = far * ((1 - v) * x[k] + v * x[k + 1]);
        out[1] = far * ((1 - v) * y[k] + v * y[k + 1]);
    }

    /** The x and then the y of all corners, of which the first is also the last; empty for a disk. */
    double[] corners() {
        double[] all = Arrays.copyOf(x, 2 * x.length);
        System.arraycopy(y, 0, all, x.length, x.length);
        return all;
    }
}
