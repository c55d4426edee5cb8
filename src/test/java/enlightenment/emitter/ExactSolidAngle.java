package enlightenment.emitter;

import java.math.BigDecimal;
import java.math.MathContext;

/** Solid angles from the origin of what is given in doubles, in decimals of 80 digits: right to rounding wherever the light is. */
final class ExactSolidAngle {
    static final MathContext DIGITS = new MathContext(80);

    private ExactSolidAngle() {}

    static BigDecimal[] point(double x, double y, double z) {
        return new BigDecimal[] {new BigDecimal(x), new BigDecimal(y), new BigDecimal(z)};
    }

    static BigDecimal[] minus(BigDecimal[] a, BigDecimal[] b) {
        return new BigDecimal[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
    }

    /** a + t (b − a). */
    static BigDecimal[] between(BigDecimal[] a, BigDecimal[] b, BigDecimal t) {
        BigDecimal[] p = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            p[k] = a[k].add(b[k].subtract(a[k]).multiply(t)).round(DIGITS);
        }
        return p;
    }

    static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0])
                .add(a[1].multiply(b[1]))
                .add(a[2].multiply(b[2]))
                .round(DIGITS);
    }

    static BigDecimal length(BigDecimal[] a) {
        return dot(a, a).sqrt(DIGITS);
    }

    static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
        BigDecimal[] c = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3;
            int j = (k + 2) % 3;
            c[k] = a[i].multiply(b[j]).subtract(a[j].multiply(b[i])).round(DIGITS);
        }
        return c;
    }

    /** Van Oosterom's and Strackee's formula: with that many digits its differences may cancel. */
    static double ofTriangle(BigDecimal[] a, BigDecimal[] b, BigDecimal[] c) {
        BigDecimal la = length(a);
        BigDecimal lb = length(b);
        BigDecimal lc = length(c);
        BigDecimal cosines = la.multiply(lb)
                .multiply(lc)
                .add(dot(a, b).multiply(lc))
                .add(dot(b, c).multiply(la))
                .add(dot(c, a).multiply(lb));
        return 2 * angle(dot(a, cross(b, c)).abs(), cosines);
    }

    /** That of the rectangle between x0 and x1, y0 and y1, at the height z. */
    static double ofRectangle(BigDecimal x0, BigDecimal x1, BigDecimal y0, BigDecimal y1, BigDecimal z) {
        BigDecimal[] a = {x0, y0, z};
        BigDecimal[] c = {x1, y1, z};
        return ofTriangle(a, new BigDecimal[] {x1, y0, z}, c) + ofTriangle(a, new BigDecimal[] {x0, y1, z}, c);
    }

    /** The angle of the point (x, y), y ≥ 0, which loses no digit. */
    static double angle(BigDecimal y, BigDecimal x) {
        if (y.signum() == 0) {
            return x.signum() < 0 ? Math.PI : 0;
        }
        if (x.abs().compareTo(y) > 0) {
            double small = Math.atan(y.divide(x, DIGITS).doubleValue());
            return x.signum() < 0 ? Math.PI + small : small;
        }
        return Math.PI / 2 - Math.atan(x.divide(y, DIGITS).doubleValue());
    }
}
