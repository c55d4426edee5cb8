package enlightenment.emitter;

import enlightenment.numeric.Angles;

/**
 * A rectangle as it is seen from the origin of coordinates that are parallel to its edges, sampled evenly over its solid angle: C. Ureña,
 * M. Fajardo and A. King, "An area-preserving parametrization for spherical rectangles", EGSR 2013. Differences of nearly equal numbers
 * are written as products where that is possible. A mutable work object.
 */
final class SphericalRectangle {
    /** The last point chosen; its third coordinate is −{@link #height}. */
    double x;

    double y;

    /** The solid angle, accurate at every distance. */
    double solidAngle;

    /** The squared distances of its nearest point and of its farthest corner. */
    double nearest;

    double farthest;

    private double x0;
    private double x1;
    private double y0;
    private double y1;
    private double height;
    private double b0;
    private double a0;
    private double b1;
    private double start;

    /**
     * Places the rectangle at the distance {@code height} &gt; 0 from the origin.
     *
     * @param left its least coordinate along the first edge, whose length is {@code width}
     */
    void set(double left, double width, double low, double length, double height) {
        x0 = left;
        x1 = left + width;
        y0 = low;
        y1 = low + length;
        this.height = height;
        double zz = height * height;
        double l00 = Math.sqrt(x0 * x0 + y0 * y0 + zz);
        double l10 = Math.sqrt(x1 * x1 + y0 * y0 + zz);
        double l11 = Math.sqrt(x1 * x1 + y1 * y1 + zz);
        double l01 = Math.sqrt(x0 * x0 + y1 * y1 + zz);
        double far = Math.max(Math.max(l00, l10), Math.max(l11, l01));
        farthest = far * far;
        double nearX = Math.max(Math.max(x0, -x1), 0);
        double nearY = Math.max(Math.max(y0, -y1), 0);
        nearest = nearX * nearX + nearY * nearY + zz;
        // Two triangles by Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983.
        double numerator = height * width * length;
        double across = x0 * x1 + y0 * y1 + zz;
        double diagonal = l00 * l11;
        double lower = (x0 * x1 + y0 * y0 + zz) * l11 + (x1 * x1 + y0 * y1 + zz) * l00 + (across + diagonal) * l10;
        double upper = (x0 * x0 + y0 * y1 + zz) * l11 + (x0 * x1 + y1 * y1 + zz) * l00 + (across + diagonal) * l01;
        solidAngle = 2 * (Angles.atan2(numerator, lower) + Angles.atan2(numerator, upper));
    }

    /** Prepares {@link #choose}. */
    void prepare() {
        double zz = height * height;
        double low2 = y0 * y0 + zz;
        double right2 = x1 * x1 + zz;
        double high2 = y1 * y1 + zz;
        double left2 = x0 * x0 + zz;
        // The components of the side planes' normals along the axis, and the squares of what is left of them.
        b0 = -y0 / Math.sqrt(low2);
        a0 = zz / low2;
        b1 = y1 / Math.sqrt(high2);
        double right = x1 / Math.sqrt(right2);
        double left = -x0 / Math.sqrt(left2);
        start = 2 * Math.PI - angle(b1, zz / high2, left, zz / left2) - angle(left, zz / left2, b0, a0);
    }

    /** The angle between two side planes: acos(−pq), where 1 − p² and 1 − q² are known without cancellation. */
    private static double angle(double p, double oneMinusPp, double q, double oneMinusQq) {
        return Angles.atan2(Math.sqrt(oneMinusPp + p * p * oneMinusQq), -p * q);
    }

    /** Chooses the point for (u, v) in the unit square. */
    void choose(double u, double v) {
        double au = Math.fma(u, solidAngle, start);
        double f = Math.fma(StrictMath.cos(au), b0, -b1) / StrictMath.sin(au);
        double edge = Math.sqrt(a0);
        double rest = (Math.abs(f) - edge) * (Math.abs(f) + edge);
        // Rounding may leave nothing, or NaN, where the point is at infinity but for the rectangle's edge.
        double along = rest > 0 ? Math.copySign(height / Math.sqrt(rest), f) : Math.copySign(Double.MAX_VALUE, f);
        x = Math.min(Math.max(along, x0), x1);
        double dd = x * x + height * height;
        double less = (1 - v) * complement(y0, dd) + v * complement(y1, dd);
        double more = (1 - v) * complement(-y0, dd) + v * complement(-y1, dd);
        y = Math.min(Math.max(0.5 * (more - less) * Math.sqrt(dd / (less * more)), y0), y1);
    }

    /** 1 − y/√(d² + y²), without cancellation. */
    private static double complement(double y, double dd) {
        double hypotenuse = Math.sqrt(dd + y * y);
        return y > 0 ? dd / (hypotenuse * (hypotenuse + y)) : 1 - y / hypotenuse;
    }
}
