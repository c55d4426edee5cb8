package enlightenment.emitter;

import enlightenment.numeric.Angles;
import enlightenment.numeric.Arcs;

/**
 * Samples x by the same distribution as {@link SphericalRectangle}, for rectangles that are seen at a grazing angle or cover a small solid
 * angle: every number is a sum, a product or a quotient of positive ones, so that nothing cancels.
 *
 * <p>The infinite strip between y0 and y1 along x covers the solid angle ψ∞ = e0 − e1 on each side of x = 0, e being the angles above the
 * plane at which its edges stand there. Of it ψ lies between 0 and x, and δ = ψ∞ − ψ beyond. With the sine s of the angle at which x is
 * seen and the sines b of those of y0 and y1, ψ = asin(s b1) − asin(s b0), whose inverse is
 *
 * <p>x = h sin ψ / √(4 sin(δ/2) sin(ψ∞ − δ/2) sin(e1 + δ/2) sin(e0 − δ/2)).
 *
 * <p>Where ψ∞ or e0 is obtuse its supplement is known just as well. A mutable work object.
 */
final class GrazingRectangle {
    private double x0;
    private double x1;

    /** The edges' coordinates along y, mirrored where needed for y0 + y1 ≥ 0. */
    private double y0;

    private double y1;
    private double length;
    private double height;
    private double zz;

    /** The solid angles to the left of x = 0 and to the right of it. */
    private double left;

    private double right;
    private double solidAngle;

    /** The solid angle between x = 0 and the rectangle. */
    private double before;

    /** The solid angles beyond its left and its right edge, where they count. */
    private double beyondLeft;

    private double beyondRight;

    private double e0;
    private double e1;

    /** ψ∞, or π less that. */
    private double strip;

    private boolean obtuseStrip;
    private boolean obtuseEdge;

    private void set(double left, double width, double low, double length, double height) {
        x0 = left;
        x1 = left + width;
        boolean mirrored = low + (low + length) < 0;
        y0 = mirrored ? -(low + length) : low;
        y1 = mirrored ? -low : low + length;
        this.length = length;
        this.height = height;
        zz = height * height;
    }

    /** Sets the rectangle as {@link SphericalRectangle#set} does, and computes its solid angle. */
    double measure(double least, double width, double low, double length, double height) {
        set(least, width, low, length, height);
        if (x0 >= 0) {
            left = 0;
            right = side(x0, x1, width);
        } else if (x1 <= 0) {
            left = side(-x1, -x0, width);
            right = 0;
        } else {
            left = side(0, -x0, -x0);
            right = side(0, x1, x1);
        }
        solidAngle = left + right;
        return solidAngle;
    }

    /** The solid angle of the part between the distances p and q from x = 0. */
    private double side(double p, double q, double width) {
        return y0 < 0
                ? quarter(p, q, width, 0, y1, y1) + quarter(p, q, width, 0, -y0, -y0)
                : quarter(p, q, width, y0, y1, length);
    }

    /**
     * The solid angle of a rectangle without negative coordinates: as in {@link SphericalRectangle#measure}, where nothing cancels then.
     */
    private double quarter(double left, double right, double width, double low, double high, double length) {
        double low2 = low * low + zz;
        double high2 = high * high + zz;
        double l00 = Math.sqrt(left * left + low2);
        double l10 = Math.sqrt(right * right + low2);
        double l11 = Math.sqrt(right * right + high2);
        double l01 = Math.sqrt(left * left + high2);
        double across = left * right + low * high + zz;
        double diagonal = l00 * l11;
        double lower =
                (left * right + low2) * l11 + (right * right + zz + low * high) * l00 + (across + diagonal) * l10;
        double upper = (left * left + zz + low * high) * l11 + (left * right + high2) * l00 + (across + diagonal) * l01;
        double numerator = height * width * length;
        return 2 * Angles.atan2(numerator * (lower + upper), lower * upper - numerator * numerator);
    }

    /** The solid angle of the strip beyond the distance p from x = 0. */
    private double beyond(double p) {
        return y0 < 0 ? beyond(p, 0, y1, y1) + beyond(p, 0, -y0, -y0) : beyond(p, y0, y1, length);
    }

    /** The solid angle of a strip without negative coordinates: a spherical triangle, as the ends of its edges coincide. */
    private double beyond(double p, double low, double high, double length) {
        double r0 = Math.sqrt(p * p + low * low + zz);
        double r1 = Math.sqrt(p * p + high * high + zz);
        return 2 * Angles.atan2(height * length, (r0 + p) * (r1 + p) + low * high + zz);
    }

    /** Prepares {@link #choose}; call after {@link #measure}. */
    void prepare() {
        e1 = Angles.atan2(height, y1);
        obtuseEdge = y0 < 0;
        e0 = Angles.atan2(height, Math.abs(y0));
        double cosine = Math.fma(y0, y1, zz);
        obtuseStrip = cosine < 0;
        strip = obtuseStrip ? e1 + e0 : Angles.atan2(height * length, cosine);
        double nearest = Math.max(Math.max(x0, -x1), 0);
        before = nearest > 0 ? side(0, nearest, nearest) : 0;
        beyondLeft = left > 0 ? beyond(-x0) : 0;
        beyondRight = right > 0 ? beyond(x1) : 0;
    }

    /** The x below which the share u of the solid angle lies. */
    double choose(double u) {
        double turn = u * solidAngle;
        double rest = (1 - u) * solidAngle;
        if (turn < left || !(right > 0)) {
            double inner = right > 0 ? left - turn : rest;
            return Math.min(Math.max(-distance(before + inner, beyondLeft + turn), x0), x1);
        }
        double inner = left > 0 ? turn - left : turn;
        return Math.min(Math.max(distance(before + inner, beyondRight + rest), x0), x1);
    }

    /** The distance from x = 0 with the solid angle ψ before it and δ beyond. */
    private double distance(double psi, double delta) {
        double half = 0.5 * delta;
        double ofStrip = Arcs.sine(obtuseStrip ? strip + half : strip - half);
        double ofEdge = Arcs.sine(obtuseEdge ? e0 + half : e0 - half);
        double ofPsi = Arcs.sine(obtuseStrip && delta < psi ? strip + delta : psi);
        double product = Arcs.sine(half) * ofStrip;
        double edges = Arcs.sine(e1 + half) * ofEdge;
        // Where rounding leaves 0 the point is at infinity, and is limited by the rectangle's edge.
        return product > 0 && edges > 0
                ? 0.5 * height * ofPsi / (Math.sqrt(product) * Math.sqrt(edges))
                : Double.MAX_VALUE;
    }
}
