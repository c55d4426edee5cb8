package enlightenment.primitive;

import enlightenment.math.Vec3;

/**
 * Intersections as textbooks print them, in plain double arithmetic: what the primitives are compared with in {@link
 * ErrorTables}. Nothing else uses them.
 */
final class NaiveForms {
    /** The limit on a determinant in the printed form of Möller and Trumbore (1997). */
    private static final double PRINTED_EPSILON = 0.000001;

    /** What the printed solvers of cubics and quartics take for zero (Schwarze, Graphics Gems, 1990). */
    private static final double PRINTED_ZERO = 1e-9;

    private NaiveForms() {}

    /** The least t &gt; tMin at which the line o + t·d meets a surface, or {@link Primitive#MISS}. */
    interface Form {
        double nearest(Vec3 o, Vec3 d, double tMin);
    }

    private static double dot(Vec3 a, Vec3 b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }

    private static Vec3 cross(Vec3 a, Vec3 b) {
        return new Vec3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
    }

    private static Vec3 at(Vec3 o, Vec3 d, double t) {
        return new Vec3(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z());
    }

    private static double[] quadratic(double a, double b, double c) {
        double discriminant = b * b - 4 * a * c;
        if (!(discriminant >= 0)) {
            return new double[0];
        }
        double s = Math.sqrt(discriminant);
        return new double[] {(-b - s) / (2 * a), (-b + s) / (2 * a)};
    }

    private static double least(double tMin, double[] candidates) {
        double t = Primitive.MISS;
        for (double c : candidates) {
            t = c > tMin && c < t ? c : t;
        }
        return t;
    }

    static Form sphere(Vec3 center, double radius) {
        return (o, d, tMin) -> {
            Vec3 f = o.minus(center);
            return least(tMin, quadratic(dot(d, d), 2 * dot(f, d), dot(f, f) - radius * radius));
        };
    }

    /** The crossing with an end disk that is perpendicular to the axis. */
    private static double disk(Vec3 o, Vec3 d, Vec3 center, Vec3 axis, double radius, double tMin) {
        double t = dot(center.minus(o), axis) / dot(d, axis);
        Vec3 p = at(o, d, t).minus(center);
        return t > tMin && dot(p, p) <= radius * radius ? t : Primitive.MISS;
    }

    static Form cylinder(Vec3 base, Vec3 top, double radius) {
        double height = Math.sqrt(dot(top.minus(base), top.minus(base)));
        Vec3 a = top.minus(base).times(1 / height);
        return (o, d, tMin) -> {
            Vec3 f = o.minus(base);
            Vec3 fa = f.minus(a.times(dot(f, a)));
            Vec3 da = d.minus(a.times(dot(d, a)));
            double t = Math.min(disk(o, d, base, a, radius, tMin), disk(o, d, top, a, radius, tMin));
            for (double r : quadratic(dot(da, da), 2 * dot(fa, da), dot(fa, fa) - radius * radius)) {
                double h = dot(at(f, d, r), a);
                t = r > tMin && r < t && h >= 0 && h <= height ? r : t;
            }
            return t;
        };
    }

    static Form cone(Vec3 base, Vec3 apex, double radius) {
        double height = Math.sqrt(dot(base.minus(apex), base.minus(apex)));
        Vec3 a = base.minus(apex).times(1 / height);
        double cosine2 = height * height / (height * height + radius * radius);
        return (o, d, tMin) -> {
            Vec3 f = o.minus(apex);
            double da = dot(d, a);
            double fa = dot(f, a);
            double t = disk(o, d, base, a, radius, tMin);
            double[] roots = quadratic(
                    da * da - cosine2 * dot(d, d), 2 * (da * fa - cosine2 * dot(d, f)), fa * fa - cosine2 * dot(f, f));
            for (double r : roots) {
                double h = fa + r * da;
                t = r > tMin && r < t && h >= 0 && h <= height ? r : t;
            }
            return t;
        };
    }

    /** Slabs with the library's minimum and maximum, which hand on what is not a number. */
    static Form box(Vec3 min, Vec3 max) {
        return (o, d, tMin) -> {
            double near = Double.NEGATIVE_INFINITY;
            double far = Double.POSITIVE_INFINITY;
            for (int k = 0; k < 3; k++) {
                double t0 = (min.component(k) - o.component(k)) / d.component(k);
                double t1 = (max.component(k) - o.component(k)) / d.component(k);
                near = Math.max(near, Math.min(t0, t1));
                far = Math.min(far, Math.max(t0, t1));
            }
            boolean met = near <= far;
            return !met ? Primitive.MISS : near > tMin ? near : far > tMin ? far : Primitive.MISS;
        };
    }

    /** Möller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997. */
    static Form triangle(Vec3 a, Vec3 b, Vec3 c) {
        return (o, d, tMin) -> {
            Vec3 e1 = b.minus(a);
            Vec3 e2 = c.minus(a);
            Vec3 p = cross(d, e2);
            double det = dot(e1, p);
            if (det > -PRINTED_EPSILON && det < PRINTED_EPSILON) {
                return Primitive.MISS;
            }
            double inverse = 1 / det;
            Vec3 s = o.minus(a);
            double u = dot(s, p) * inverse;
            Vec3 q = cross(s, e1);
            double v = dot(d, q) * inverse;
            double t = dot(e2, q) * inverse;
            return u >= 0 && u <= 1 && v >= 0 && u + v <= 1 && t > tMin ? t : Primitive.MISS;
        };
    }

    /** The quartic with all its terms, solved by Ferrari's formula. */
    static Form torus(Vec3 center, Vec3 axis, double major, double minor) {
        Vec3 a = axis.times(1 / Math.sqrt(dot(axis, axis)));
        return (o, d, tMin) -> {
            Vec3 f = o.minus(center);
            double dd = dot(d, d);
            double fd = dot(f, d);
            double k = dot(f, f) + major * major - minor * minor;
            double da = dot(d, a);
            double fa = dot(f, a);
            double four = 4 * major * major;
            double e = dd * dd;
            return least(
                    tMin,
                    quartic(
                            4 * fd * dd / e,
                            (4 * fd * fd + 2 * k * dd - four * (dd - da * da)) / e,
                            (4 * k * fd - 2 * four * (fd - fa * da)) / e,
                            (k * k - four * (dot(f, f) - fa * fa)) / e));
        };
    }

    /** The real roots of x⁴ + ax³ + bx² + cx + d. */
    static double[] quartic(double a, double b, double c, double d) {
        double a2 = a * a;
        double p = b - 3 * a2 / 8;
        double q = a2 * a / 8 - a * b / 2 + c;
        double r = -3 * a2 * a2 / 256 + a2 * b / 16 - a * c / 4 + d;
        double z = cubicRoot(-p / 2, -r, r * p / 2 - q * q / 8);
        double u = root(z * z - r);
        double v = root(2 * z - p);
        if (!(u >= 0 && v >= 0)) {
            return new double[0];
        }
        v = q < 0 ? -v : v;
        double[] first = quadratic(1, v, z - u);
        double[] second = quadratic(1, -v, z + u);
        double[] all = new double[first.length + second.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = (i < first.length ? first[i] : second[i - first.length]) - a / 4;
        }
        return all;
    }

    private static double root(double square) {
        return Math.abs(square) < PRINTED_ZERO ? 0 : Math.sqrt(square);
    }

    /** The largest real root of x³ + ax² + bx + c, by Cardano's formula or by cosines. */
    private static double cubicRoot(double a, double b, double c) {
        double p = (b - a * a / 3) / 3;
        double q = (2 * a * a * a / 27 - a * b / 3 + c) / 2;
        double discriminant = q * q + p * p * p;
        if (discriminant < 0) {
            double angle = StrictMath.acos(-q / Math.sqrt(-p * p * p)) / 3;
            return 2 * Math.sqrt(-p) * StrictMath.cos(angle) - a / 3;
        }
        double s = Math.sqrt(discriminant);
        return StrictMath.cbrt(s - q) - StrictMath.cbrt(s + q) - a / 3;
    }
}
