package enlightenment.emitter;

import enlightenment.numeric.Angles;
import enlightenment.numeric.Arcs;

/**
 * A rectangle as seen from the origin of coordinates parallel to its edges, sampled uniformly over its solid angle: C. Ureña, M. Fajardo
 * and A. King, "An area-preserving parametrization for spherical rectangles", EGSR 2013. Differences of nearly equal numbers are written as
 * products where possible. A mutable work object.
 */
final class SphericalRectangle {
    /**
     * Where the height is at least this part of the farthest corner's distance, cosines of angles between corners are above −1 + 2^-11: the
     * remaining differences below lose no more than 12 of 53 bits then. Other rectangles are sampled by {@link GrazingRectangle}.
     */
    private static final double LEAST_COSINE = 0x1p-6;

    /** The last sampled point; its third coordinate is −{@link #height}. */
    double x;

    double y;

    /** The solid angle, accurate at every distance; valid after {@link #measure}. */
    double solidAngle;

    private double x0;
    private double x1;
    private double y0;
    private double y1;
    private double height;
    private double width;
    private double length;
    private double area;

    /** The squares of coordinates, and those of the distances of the edges' lines. */
    private double zz;

    private double low2;
    private double high2;
    private double left2;
    private double right2;

    private double b0;
    private double a0;
    private double b1;

    /** Sine and cosine of the angle where the left edge is. */
    private double startSine;

    private double startCosine;

    private final GrazingRectangle grazing = new GrazingRectangle();
    private boolean isGrazing;

    /**
     * Sets the rectangle at the distance {@code height} &gt; 0 from the origin.
     *
     * @param left its least coordinate along the first edge, whose length is {@code width}
     * @param low its least coordinate along the second edge, whose length is {@code length}
     */
    void set(double left, double width, double low, double length, double height) {
        x0 = left;
        x1 = left + width;
        y0 = low;
        y1 = low + length;
        this.height = height;
        this.width = width;
        this.length = length;
        area = width * length;
        zz = height * height;
        low2 = y0 * y0 + zz;
        high2 = y1 * y1 + zz;
        left2 = x0 * x0 + zz;
        right2 = x1 * x1 + zz;
    }

    /** The squared distance of its nearest point. */
    double nearest() {
        double nearX = Math.max(Math.max(x0, -x1), 0);
        double nearY = Math.max(Math.max(y0, -y1), 0);
        return nearX * nearX + nearY * nearY + zz;
    }

    /** The squared distance of its farthest corner. */
    double farthest() {
        return Math.max(x0 * x0, x1 * x1) + Math.max(low2, high2);
    }

    /**
     * Computes the solid angle of two triangles by A. van Oosterom and J. Strackee, "The solid angle of a plane triangle", 1983. The angles
     * are those of two complex numbers, and their sum that of the product.
     */
    void measure() {
        isGrazing = zz < LEAST_COSINE * LEAST_COSINE * farthest();
        if (isGrazing) {
            solidAngle = grazing.measure(x0, width, y0, length, height);
            return;
        }
        double l00 = Math.sqrt(x0 * x0 + low2);
        double l10 = Math.sqrt(x1 * x1 + low2);
        double l11 = Math.sqrt(x1 * x1 + high2);
        double l01 = Math.sqrt(x0 * x0 + high2);
        double numerator = height * area;
        double across = x0 * x1 + y0 * y1 + zz;
        double diagonal = l00 * l11;
        double lower = (x0 * x1 + low2) * l11 + (right2 + y0 * y1) * l00 + (across + diagonal) * l10;
        double upper = (left2 + y0 * y1) * l11 + (x0 * x1 + high2) * l00 + (across + diagonal) * l01;
        solidAngle = 2 * Angles.atan2(numerator * (lower + upper), lower * upper - numerator * numerator);
    }

    /** Prepares {@link #choose}; call after {@link #measure}. */
    void prepare() {
        if (!isGrazing && solidAngle < ParallelogramLight.LEAST_SOLID_ANGLE) {
            isGrazing = true;
            solidAngle = grazing.measure(x0, width, y0, length, height);
        }
        if (isGrazing) {
            grazing.prepare();
            return;
        }
        // The components of the side planes' normals along the axis, and the squares of what is left of them.
        b0 = -y0 / Math.sqrt(low2);
        a0 = zz / low2;
        b1 = y1 / Math.sqrt(high2);
        double a1 = zz / high2;
        double left = -x0 / Math.sqrt(left2);
        double leftRest = zz / left2;
        // The angles between the left plane and the others, whose cosines are -b1 left and -left b0; of a turn less
        // both.
        double cosine1 = -b1 * left;
        double sine1 = Math.sqrt(a1 + b1 * b1 * leftRest);
        double cosine0 = -left * b0;
        double sine0 = Math.sqrt(leftRest + left * left * a0);
        startCosine = cosine1 * cosine0 - sine1 * sine0;
        startSine = -(sine1 * cosine0 + cosine1 * sine0);
    }

    /** Samples the point for (u, v) in the unit square. */
    void choose(double u, double v) {
        x = isGrazing ? grazing.choose(u) : across(u);
        double dd = x * x + zz;
        double low = complement(y0, dd);
        double high = complement(y1, dd);
        // 1 - h and 1 + h of h = y/sqrt(d² + y²), between those of the edges: the smaller one of each is at hand.
        double less = (1 - v) * (y0 > 0 ? low : 2 - low) + v * (y1 > 0 ? high : 2 - high);
        double more = (1 - v) * (y0 > 0 ? 2 - low : low) + v * (y1 > 0 ? 2 - high : high);
        y = Math.min(Math.max(0.5 * (more - less) * Math.sqrt(dd / (less * more)), y0), y1);
    }

    /** The x below which the share u of the solid angle lies. */
    private double across(double u) {
        double turn = u * solidAngle;
        double sine = Arcs.sine(turn);
        double cosine = Arcs.cosine(turn);
        double f =
                Math.fma(cosine * startCosine - sine * startSine, b0, -b1) / (sine * startCosine + cosine * startSine);
        double edge = Math.sqrt(a0);
        double rest = (Math.abs(f) - edge) * (Math.abs(f) + edge);
        // Where rounding leaves 0 or NaN the point is at infinity, and is limited by the rectangle's edge.
        double along = rest > 0 ? Math.copySign(height / Math.sqrt(rest), f) : Math.copySign(Double.MAX_VALUE, f);
        return Math.min(Math.max(along, x0), x1);
    }

    /** 1 − |y|/√(d² + y²), without cancellation. */
    private static double complement(double y, double dd) {
        double hypotenuse = Math.sqrt(dd + y * y);
        return dd / (hypotenuse * (hypotenuse + Math.abs(y)));
    }
}
