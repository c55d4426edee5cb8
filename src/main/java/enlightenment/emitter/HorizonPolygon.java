package enlightenment.emitter;

import enlightenment.numeric.Angles;

/**
 * A flat convex light of radiance 1, clipped by the receiver's horizon, and its irradiance: Lambert's sum over its edges (Lambert 1760; D.
 * Baum, H. Rushmeier, J. Winget, "Improving radiosity solutions through the use of analytically determined form-factors", 1989). Far away
 * that sum cancels, and a quadrature over the area, exact there to rounding, is used. A mutable work object.
 */
final class HorizonPolygon {
    /** Below this ratio of size to distance the quadrature, of the fifth degree, is exact to rounding. */
    static final double FAR = 0x1p-9;

    private static final int MOST = 6;

    /** J. Radon's rule of seven points, "Zur mechanischen Kubatur", 1948: two orbits of three and the centroid. */
    private static final double NEAR_CENTRE = (6 + Math.sqrt(15)) / 21;

    private static final double NEAR_CORNER = (6 - Math.sqrt(15)) / 21;
    private static final double CENTROID_WEIGHT = 9.0 / 40;
    private static final double CENTRE_WEIGHT = (155 + Math.sqrt(15)) / 1200;
    private static final double CORNER_WEIGHT = (155 - Math.sqrt(15)) / 1200;

    private final double[] rawX = new double[MOST];
    private final double[] rawY = new double[MOST];
    private final double[] rawZ = new double[MOST];
    private final double[] x = new double[MOST];
    private final double[] y = new double[MOST];
    private final double[] z = new double[MOST];
    private int corners;
    private int count;
    private double baseX;
    private double baseY;
    private double baseZ;
    private double nx;
    private double ny;
    private double nz;

    /** Begins with the corner at this offset from the receiver. */
    void begin(double bx, double by, double bz) {
        baseX = bx;
        baseY = by;
        baseZ = bz;
        corners = 0;
        add(0, 0, 0);
    }

    /** Adds the corner at this offset from the first one: of a far polygon, offsets from the receiver would lose digits. */
    void add(double cx, double cy, double cz) {
        rawX[corners] = cx;
        rawY[corners] = cy;
        rawZ[corners++] = cz;
    }

    /**
     * The irradiance of a receiver with the unit normal n.
     *
     * @param height the receiver's distance from the polygon's plane
     * @param far whether the polygon's size is below {@link #FAR} of its distance
     */
    double irradiance(double normalX, double normalY, double normalZ, double height, boolean far) {
        nx = normalX;
        ny = normalY;
        nz = normalZ;
        clip();
        if (count < 3) {
            return 0;
        }
        if (!far) {
            return Math.min(sumOverEdges(), Math.PI);
        }
        double sum = 0;
        for (int k = 1; k + 1 < count; k++) {
            sum += overTriangle(k);
        }
        return sum * height;
    }

    /** Clips to the part above the horizon (I. Sutherland and G. Hodgman, "Reentrant polygon clipping", 1974). */
    private void clip() {
        count = 0;
        int last = corners - 1;
        double base = nx * baseX + ny * baseY + nz * baseZ;
        double before = base + (nx * rawX[last] + ny * rawY[last] + nz * rawZ[last]);
        for (int k = 0; k < corners; k++) {
            double here = base + (nx * rawX[k] + ny * rawY[k] + nz * rawZ[k]);
            if (here > 0 && before < 0 || here < 0 && before > 0) {
                double share = before / (before - here);
                put(
                        Math.fma(share, rawX[k] - rawX[last], rawX[last]),
                        Math.fma(share, rawY[k] - rawY[last], rawY[last]),
                        Math.fma(share, rawZ[k] - rawZ[last], rawZ[last]));
            }
            if (here >= 0) {
                put(rawX[k], rawY[k], rawZ[k]);
            }
            last = k;
            before = here;
        }
    }

    private void put(double px, double py, double pz) {
        x[count] = px;
        y[count] = py;
        z[count++] = pz;
    }

    private double sumOverEdges() {
        double sum = 0;
        int last = count - 1;
        double ax = baseX + x[last];
        double ay = baseY + y[last];
        double az = baseZ + z[last];
        for (int k = 0; k < count; k++) {
            double bx = baseX + x[k];
            double by = baseY + y[k];
            double bz = baseZ + z[k];
            double cx = ay * bz - az * by;
            double cy = az * bx - ax * bz;
            double cz = ax * by - ay * bx;
            double length = Math.sqrt(cx * cx + cy * cy + cz * cz);
            if (length > 0) {
                double angle = Angles.atan2(length, ax * bx + ay * by + az * bz);
                sum += angle * ((nx * cx + ny * cy + nz * cz) / length);
            }
            ax = bx;
            ay = by;
            az = bz;
        }
        return 0.5 * Math.abs(sum);
    }

    /** The integral of n·v/|v|⁴ over the triangle of the corners 0, k and k + 1. */
    private double overTriangle(int k) {
        double ax = x[k] - x[0];
        double ay = y[k] - y[0];
        double az = z[k] - z[0];
        double bx = x[k + 1] - x[0];
        double by = y[k + 1] - y[0];
        double bz = z[k + 1] - z[0];
        double cx = ay * bz - az * by;
        double cy = az * bx - ax * bz;
        double cz = ax * by - ay * bx;
        double near = 1 - 2 * NEAR_CENTRE;
        double corner = 1 - 2 * NEAR_CORNER;
        double sum = CENTROID_WEIGHT * at(k, 1.0 / 3, 1.0 / 3)
                + CENTRE_WEIGHT
                        * (at(k, NEAR_CENTRE, NEAR_CENTRE) + at(k, near, NEAR_CENTRE) + at(k, NEAR_CENTRE, near))
                + CORNER_WEIGHT
                        * (at(k, NEAR_CORNER, NEAR_CORNER) + at(k, corner, NEAR_CORNER) + at(k, NEAR_CORNER, corner));
        return 0.5 * Math.sqrt(cx * cx + cy * cy + cz * cz) * sum;
    }

    private double at(int k, double p, double q) {
        double o = 1 - p - q;
        double px = baseX + o * x[0] + p * x[k] + q * x[k + 1];
        double py = baseY + o * y[0] + p * y[k] + q * y[k + 1];
        double pz = baseZ + o * z[0] + p * z[k] + q * z[k + 1];
        double square = px * px + py * py + pz * pz;
        return Math.max(nx * px + ny * py + nz * pz, 0) / (square * square);
    }
}
