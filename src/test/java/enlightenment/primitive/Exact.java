package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;

/** Vectors of exact decimals: every double is one, and sums and products of them are too. */
record Exact(BigDecimal x, BigDecimal y, BigDecimal z) {
    /** Digits of quotients and roots, which are the only results that are rounded. */
    static final MathContext DIGITS = new MathContext(60);

    static Exact of(Vec3 v) {
        return new Exact(new BigDecimal(v.x()), new BigDecimal(v.y()), new BigDecimal(v.z()));
    }

    static Exact origin(Ray ray) {
        return of(new Vec3(ray.ox, ray.oy, ray.oz));
    }

    static Exact direction(Ray ray) {
        return of(new Vec3(ray.dx, ray.dy, ray.dz));
    }

    Exact minus(Exact o) {
        return new Exact(x.subtract(o.x), y.subtract(o.y), z.subtract(o.z));
    }

    Exact plus(Exact o) {
        return new Exact(x.add(o.x), y.add(o.y), z.add(o.z));
    }

    Exact times(BigDecimal s) {
        return new Exact(x.multiply(s), y.multiply(s), z.multiply(s));
    }

    BigDecimal dot(Exact o) {
        return x.multiply(o.x).add(y.multiply(o.y)).add(z.multiply(o.z));
    }

    Exact cross(Exact o) {
        return new Exact(
                y.multiply(o.z).subtract(z.multiply(o.y)),
                z.multiply(o.x).subtract(x.multiply(o.z)),
                x.multiply(o.y).subtract(y.multiply(o.x)));
    }

    BigDecimal component(int k) {
        return k == 0 ? x : k == 1 ? y : z;
    }

    BigDecimal length() {
        return dot(this).sqrt(DIGITS);
    }

    static BigDecimal quotient(BigDecimal a, BigDecimal b) {
        return a.divide(b, DIGITS);
    }
}
