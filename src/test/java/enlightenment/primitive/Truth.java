package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import java.util.List;

/** What decimal arithmetic says of rays against one primitive. */
interface Truth {
    /** Clearances below this many roundings of the distance decide nothing: "4 u D". */
    double ROUNDINGS = 4;

    /**
     * What is known of a ray.
     *
     * @param decided whether it is clear of the border between hit and miss
     * @param t the exact crossing with the least t ≥ 0, or null if it misses
     */
    record Verdict(boolean decided, BigDecimal t) {
        static final Verdict UNDECIDED = new Verdict(false, null);
    }

    /** Judges the ray o + t·d, if the surface may be off by {@code allowed}. */
    Verdict judge(Vec3 o, Vec3 d, double allowed);

    /** The distance of a point from the surface. */
    double distance(Vec3 point);

    /** The clearance that rounding may hide, for a ray from o. */
    static double allowed(Vec3 o, Vec3 center, double size) {
        return ROUNDINGS * Scale.UNIT_ROUNDOFF * (o.minus(center).length() + size);
    }

    private static BigDecimal first(BigDecimal[] stretch) {
        return stretch == null || stretch[1].signum() < 0 ? null : stretch[stretch[0].signum() >= 0 ? 0 : 1];
    }

    /** The verdict on a convex solid, from the stretches of the line in it, in a smaller and in a larger one. */
    static Verdict convex(BigDecimal[] inner, BigDecimal[] exact, BigDecimal[] outer) {
        BigDecimal t = first(exact);
        boolean same = (first(inner) == null) == (t == null) && (first(outer) == null) == (t == null);
        // Undecided too where rounding may move the origin through the surface.
        boolean entering = t != null && exact[0].signum() >= 0;
        boolean clear = t == null || inner == null || (inner[0].signum() >= 0) == entering;
        return same && clear ? new Verdict(true, t) : Verdict.UNDECIDED;
    }

    static Truth of(ExactSolid solid) {
        return new Truth() {
            @Override
            public Verdict judge(Vec3 o, Vec3 d, double allowed) {
                return convex(
                        solid.inflated(-allowed).stretch(o, d),
                        solid.stretch(o, d),
                        solid.inflated(allowed).stretch(o, d));
            }

            @Override
            public double distance(Vec3 point) {
                return solid.distance(point);
            }
        };
    }

    static Truth torus(Vec3 center, Vec3 axis, double major, double minor) {
        return new Truth() {
            @Override
            public Verdict judge(Vec3 o, Vec3 d, double allowed) {
                TorusTruth truth = new TorusTruth(center, axis, major, minor, o, d);
                if (truth.clearance() <= allowed) {
                    return Verdict.UNDECIDED;
                }
                List<BigDecimal> ahead =
                        truth.crossings().stream().filter(t -> t.signum() >= 0).toList();
                return new Verdict(true, ahead.isEmpty() ? null : ahead.get(0));
            }

            @Override
            public double distance(Vec3 point) {
                return Math.abs(new TorusTruth(center, axis, major, minor, point, axis).distanceAt(BigDecimal.ZERO));
            }
        };
    }

    static Truth box(Vec3 min, Vec3 max) {
        return new Truth() {
            @Override
            public Verdict judge(Vec3 o, Vec3 d, double allowed) {
                return convex(stretch(o, d, -allowed), stretch(o, d, 0), stretch(o, d, allowed));
            }

            private BigDecimal[] stretch(Vec3 o, Vec3 d, double inflation) {
                BigDecimal near = null;
                BigDecimal far = null;
                BigDecimal pad = new BigDecimal(inflation);
                for (int k = 0; k < 3; k++) {
                    BigDecimal at = new BigDecimal(o.component(k));
                    BigDecimal lo =
                            new BigDecimal(min.component(k)).subtract(pad).subtract(at);
                    BigDecimal hi = new BigDecimal(max.component(k)).add(pad).subtract(at);
                    if (d.component(k) == 0) {
                        if (lo.signum() > 0 || hi.signum() < 0) {
                            return null;
                        }
                        continue;
                    }
                    BigDecimal along = new BigDecimal(d.component(k));
                    BigDecimal t0 = Exact.quotient(lo, along);
                    BigDecimal t1 = Exact.quotient(hi, along);
                    near = near == null ? t0.min(t1) : near.max(t0.min(t1));
                    far = far == null ? t0.max(t1) : far.min(t0.max(t1));
                }
                return near.compareTo(far) > 0 ? null : new BigDecimal[] {near, far};
            }

            @Override
            public double distance(Vec3 point) {
                BigDecimal square = BigDecimal.ZERO;
                BigDecimal depth = null;
                for (int k = 0; k < 3; k++) {
                    BigDecimal p = new BigDecimal(point.component(k));
                    BigDecimal beyond = new BigDecimal(min.component(k))
                            .subtract(p)
                            .max(p.subtract(new BigDecimal(max.component(k))));
                    depth = depth == null ? beyond : depth.max(beyond);
                    BigDecimal out = beyond.max(BigDecimal.ZERO);
                    square = square.add(out.multiply(out));
                }
                return (depth.signum() <= 0 ? depth.negate() : square.sqrt(Exact.DIGITS)).doubleValue();
            }
        };
    }

    static Truth triangle(Vec3 a, Vec3 b, Vec3 c) {
        Vec3[] corners = {a, b, c};
        Exact normal = Exact.of(b).minus(Exact.of(a)).cross(Exact.of(c).minus(Exact.of(a)));
        return new Truth() {
            @Override
            public Verdict judge(Vec3 origin, Vec3 direction, double allowed) {
                Exact o = Exact.of(origin);
                Exact d = Exact.of(direction);
                BigDecimal facing = normal.dot(d);
                if (facing.signum() == 0) {
                    return Verdict.UNDECIDED;
                }
                double least = Double.POSITIVE_INFINITY;
                for (int k = 0; k < 3; k++) {
                    Exact from = Exact.of(corners[k]);
                    Exact to = Exact.of(corners[(k + 1) % 3]);
                    BigDecimal side = d.dot(to.minus(o).cross(from.minus(o)));
                    double gap = Exact.quotient(side, d.cross(to.minus(from)).length())
                            .doubleValue();
                    least = Math.min(least, gap * -facing.signum());
                }
                BigDecimal t = Exact.quotient(normal.dot(Exact.of(a).minus(o)), facing);
                return Math.abs(least) <= allowed
                        ? Verdict.UNDECIDED
                        : new Verdict(true, least > 0 && t.signum() >= 0 ? t : null);
            }

            @Override
            public double distance(Vec3 point) {
                return Exact.quotient(normal.dot(Exact.of(point).minus(Exact.of(a))), normal.length())
                        .abs()
                        .doubleValue();
            }
        };
    }
}
