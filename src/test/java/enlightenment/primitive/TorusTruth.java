package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/**
 * The quartic of a ray and a torus, and its roots, in decimal arithmetic: the truth that the tests compare with. The axis
 * is taken as given, of any length; so nothing here knows how the primitive works.
 */
final class TorusTruth {
    private static final MathContext DIGITS = new MathContext(64);

    /** Coefficients of the quartic, constant first, of the ray parameter relative to {@link #shift}. */
    private final BigDecimal[] quartic;

    /** The parameter (rounded) of the point closest to the centre: the roots are near it. */
    private final BigDecimal shift;

    private final BigDecimal bound;
    private final BigDecimal[] o;
    private final BigDecimal[] d;
    private final BigDecimal[] axis;
    private final BigDecimal major;
    private final BigDecimal minor;

    TorusTruth(Vec3 center, Vec3 axis, double major, double minor, Vec3 origin, Vec3 direction) {
        this.axis = exact(axis);
        this.major = new BigDecimal(major);
        this.minor = new BigDecimal(minor);
        this.d = exact(direction);
        BigDecimal[] f = difference(exact(origin), exact(center));
        BigDecimal dd = dot(d, d);
        shift = dot(f, d).negate().divide(dd, DIGITS);
        o = new BigDecimal[] {at(f, 0, shift), at(f, 1, shift), at(f, 2, shift)};
        // |p|² + R² − r² and (p·A)² as polynomials of the parameter.
        BigDecimal[] square = {
            dot(o, o).add(this.major.multiply(this.major)).subtract(this.minor.multiply(this.minor)),
            dot(o, d).multiply(BigDecimal.valueOf(2)),
            dd
        };
        BigDecimal[] height = {dot(o, this.axis), dot(d, this.axis)};
        BigDecimal aa = dot(this.axis, this.axis);
        BigDecimal four = BigDecimal.valueOf(4).multiply(this.major).multiply(this.major);
        BigDecimal[] rho = {dot(o, o), square[1], dd};
        BigDecimal[] up = product(height, height);
        quartic = product(square, square);
        for (int i = 0; i < 3; i++) {
            BigDecimal q = rho[i].subtract(up[i].divide(aa, DIGITS), DIGITS);
            quartic[i] = quartic[i].subtract(four.multiply(q), DIGITS);
        }
        // All roots lie in the bounding sphere; twice that leaves room for extrema.
        bound = this.major.add(this.minor).multiply(BigDecimal.valueOf(2)).divide(dd.sqrt(DIGITS), DIGITS);
    }

    private static BigDecimal[] exact(Vec3 v) {
        return new BigDecimal[] {new BigDecimal(v.x()), new BigDecimal(v.y()), new BigDecimal(v.z())};
    }

    private static BigDecimal[] difference(BigDecimal[] a, BigDecimal[] b) {
        return new BigDecimal[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
    }

    private BigDecimal at(BigDecimal[] from, int k, BigDecimal t) {
        return from[k].add(t.multiply(d[k]), DIGITS);
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1]), DIGITS).add(a[2].multiply(b[2]), DIGITS);
    }

    private static BigDecimal[] product(BigDecimal[] a, BigDecimal[] b) {
        BigDecimal[] r = new BigDecimal[a.length + b.length - 1];
        for (int i = 0; i < r.length; i++) {
            r[i] = BigDecimal.ZERO;
            for (int j = Math.max(0, i - b.length + 1); j < Math.min(a.length, i + 1); j++) {
                r[i] = r[i].add(a[j].multiply(b[i - j]), DIGITS);
            }
        }
        return r;
    }

    /** All crossings of the whole line, ascending, as ray parameters. */
    List<BigDecimal> crossings() {
        return parameters(roots(quartic));
    }

    /**
     * The crossings after the start of a ray that starts on the torus: the quartic minus its value at the start is divided
     * by the parameter, which removes the root that the start is.
     */
    List<BigDecimal> crossingsAfterStart() {
        // Synthetic division by (t − t₀), where t₀ = -shift is the start; the remainder is what rounding of the start
        // left.
        BigDecimal start = shift.negate();
        BigDecimal[] cubic = new BigDecimal[4];
        BigDecimal carry = BigDecimal.ZERO;
        for (int i = 3; i >= 0; i--) {
            carry = carry.multiply(start, DIGITS).add(quartic[i + 1], DIGITS);
            cubic[i] = carry;
        }
        return parameters(roots(cubic)).stream().filter(t -> t.signum() > 0).toList();
    }

    /** The sign that the quartic takes just after the start of a ray that starts on the torus. */
    int signAfterStart() {
        return evaluate(derivative(quartic), shift.negate()).signum();
    }

    /** The least distance between the surface and the line's points where the quartic has an extremum. */
    double clearance() {
        double least = Double.POSITIVE_INFINITY;
        for (BigDecimal s : roots(derivative(quartic))) {
            least = Math.min(least, Math.abs(distance(s).doubleValue()));
        }
        return least;
    }

    /** The signed distance from the surface at a ray parameter. */
    double distanceAt(BigDecimal t) {
        return distance(t.subtract(shift)).doubleValue();
    }

    private BigDecimal distance(BigDecimal s) {
        BigDecimal[] p = {at(o, 0, s), at(o, 1, s), at(o, 2, s)};
        BigDecimal height = dot(p, axis);
        BigDecimal z2 = height.multiply(height).divide(dot(axis, axis), DIGITS);
        BigDecimal rho = dot(p, p).subtract(z2, DIGITS).max(BigDecimal.ZERO).sqrt(DIGITS);
        BigDecimal w = rho.subtract(major);
        return w.multiply(w).add(z2, DIGITS).sqrt(DIGITS).subtract(minor);
    }

    private List<BigDecimal> parameters(List<BigDecimal> roots) {
        return roots.stream().map(s -> s.add(shift)).toList();
    }

    private static BigDecimal[] derivative(BigDecimal[] c) {
        BigDecimal[] r = new BigDecimal[c.length - 1];
        for (int i = 0; i < r.length; i++) {
            r[i] = c[i + 1].multiply(BigDecimal.valueOf(i + 1));
        }
        return r;
    }

    private static BigDecimal evaluate(BigDecimal[] c, BigDecimal s) {
        BigDecimal v = c[c.length - 1];
        for (int i = c.length - 2; i >= 0; i--) {
            v = v.multiply(s, DIGITS).add(c[i], DIGITS);
        }
        return v;
    }

    /** The simple roots within ±bound: between neighbouring extrema there is at most one. */
    private List<BigDecimal> roots(BigDecimal[] c) {
        List<BigDecimal> ends = new ArrayList<>();
        ends.add(bound.negate());
        if (c.length > 2) {
            ends.addAll(roots(derivative(c)));
        }
        ends.add(bound);
        List<BigDecimal> found = new ArrayList<>();
        for (int i = 1; i < ends.size(); i++) {
            BigDecimal a = ends.get(i - 1);
            BigDecimal b = ends.get(i);
            int sign = evaluate(c, a).signum();
            if (sign * evaluate(c, b).signum() < 0) {
                found.add(root(c, a, b, sign));
            }
        }
        return found;
    }

    private BigDecimal root(BigDecimal[] c, BigDecimal from, BigDecimal to, int signAtFrom) {
        BigDecimal[] slope = derivative(c);
        BigDecimal a = from;
        BigDecimal b = to;
        BigDecimal x = a.add(b).divide(BigDecimal.valueOf(2));
        BigDecimal small = bound.scaleByPowerOfTen(-50);
        for (int i = 0; i < 400; i++) {
            BigDecimal v = evaluate(c, x);
            if (v.signum() == signAtFrom) {
                a = x;
            } else {
                b = x;
            }
            BigDecimal m = evaluate(slope, x);
            BigDecimal next = m.signum() == 0 ? a : x.subtract(v.divide(m, DIGITS), DIGITS);
            // Newton's step where it stays in the middle of the bracket or is tiny, halving where it does not.
            boolean tiny = next.subtract(x).abs().compareTo(small) < 0;
            if (tiny) {
                return next;
            }
            if (next.compareTo(a) <= 0 || next.compareTo(b) >= 0 || i % 4 == 3) {
                next = a.add(b).divide(BigDecimal.valueOf(2)).round(DIGITS);
            }
            x = next;
        }
        return x;
    }
}
