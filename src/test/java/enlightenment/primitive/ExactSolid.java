package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Convex solids of revolution in decimal arithmetic: the truth that the primitives are held to. Written from the
 * surfaces' equations, with none of the primitives' forms.
 */
final class ExactSolid {
    static final MathContext MC = new MathContext(110);
    private static final BigDecimal ZERO = BigDecimal.ZERO;

    private final BigDecimal[] reference;
    private final BigDecimal[] axis;
    private final BigDecimal length;

    /** How long the lateral surface is from end to end; with the inflation it says how far the radius grows. */
    private final BigDecimal slant;

    /** The radius at the fraction s of the axis is radius0 + s·gain. */
    private final BigDecimal radius0;

    private final BigDecimal gain;

    /** The surface is moved outwards by this along its normal. */
    private final BigDecimal inflation;

    /** What the inflation adds to the radius of the lateral surface, measured across the axis. */
    private final BigDecimal widening;

    private ExactSolid(BigDecimal[] reference, BigDecimal[] axis, BigDecimal r0, BigDecimal gain) {
        this.reference = reference;
        this.axis = axis;
        this.length = axis == null ? null : dot(axis, axis).sqrt(MC);
        this.slant = axis == null
                ? null
                : length.multiply(length).add(gain.multiply(gain)).sqrt(MC);
        this.radius0 = r0;
        this.gain = gain;
        this.inflation = ZERO;
        this.widening = ZERO;
    }

    /** Square roots of 110 digits take most of the time: an inflated solid has those of the one that it comes from. */
    private ExactSolid(ExactSolid solid, BigDecimal inflation) {
        this.reference = solid.reference;
        this.axis = solid.axis;
        this.length = solid.length;
        this.slant = solid.slant;
        this.radius0 = solid.radius0;
        this.gain = solid.gain;
        this.inflation = inflation;
        this.widening = axis == null ? inflation : inflation.multiply(slant).divide(length, MC);
    }

    static ExactSolid sphere(Vec3 center, double radius) {
        return new ExactSolid(vector(center), null, big(radius), ZERO);
    }

    static ExactSolid frustum(Vec3 base, Vec3 top, double baseRadius, double topRadius) {
        BigDecimal r0 = big(baseRadius);
        return new ExactSolid(
                vector(base),
                minus(vector(top), vector(base)),
                r0,
                big(topRadius).subtract(r0));
    }

    static ExactSolid of(Primitive p) {
        if (p instanceof SpherePrimitive s) {
            return sphere(s.center(), s.radius());
        }
        AxialPrimitive a = (AxialPrimitive) p;
        return frustum(a.base(), a.top(), a.baseRadius(), a.topRadius());
    }

    /** This solid with its surface moved outwards by d, or inwards if d is less than 0. */
    ExactSolid inflated(double d) {
        return new ExactSolid(this, big(d));
    }

    /** The stretch of the line o + t·d that is within the solid, or null if none is. */
    BigDecimal[] stretch(Vec3 origin, Vec3 direction) {
        BigDecimal[] f = minus(vector(origin), reference);
        BigDecimal[] d = vector(direction);
        List<BigDecimal> crossings = new ArrayList<>();
        if (axis == null) {
            BigDecimal r = radius0.add(widening);
            if (r.signum() > 0) {
                crossings.addAll(roots(dot(d, d), dot(f, d), dot(f, f).subtract(r.multiply(r))));
            }
        } else {
            addLateral(f, d, crossings);
            addEnds(f, d, crossings);
        }
        if (crossings.size() < 2) {
            return null;
        }
        return new BigDecimal[] {Collections.min(crossings), Collections.max(crossings)};
    }

    /** The radius of the lateral surface at this fraction of the axis, with the inflation. */
    private BigDecimal radiusAt(BigDecimal fraction) {
        return radius0.add(gain.multiply(fraction)).add(widening);
    }

    private BigDecimal fraction(BigDecimal[] p) {
        return dot(p, axis).divide(length.multiply(length), MC);
    }

    private boolean withinEnds(BigDecimal fraction) {
        BigDecimal pad = inflation.divide(length, MC);
        return fraction.compareTo(pad.negate()) >= 0 && fraction.compareTo(BigDecimal.ONE.add(pad)) <= 0;
    }

    /** The squared distance of a point from the axis. */
    private BigDecimal distanceSquared(BigDecimal[] p) {
        BigDecimal[] across = cross(p, axis);
        return dot(across, across).divide(dot(axis, axis), MC);
    }

    private void addLateral(BigDecimal[] f, BigDecimal[] d, List<BigDecimal> crossings) {
        for (BigDecimal t : lateralRoots(f, d)) {
            BigDecimal s = fraction(plus(f, d, t));
            if (withinEnds(s) && radiusAt(s).signum() >= 0) {
                crossings.add(t);
            }
        }
    }

    private List<BigDecimal> lateralRoots(BigDecimal[] f, BigDecimal[] d) {
        BigDecimal aa = dot(axis, axis);
        BigDecimal[] w = cross(f, axis);
        BigDecimal[] u = cross(d, axis);
        // |w + tu|² = aa·(c0 + t·c1)², all of it exact but the inflation and two divisions to 110 digits.
        BigDecimal c0 = radiusAt(fraction(f));
        BigDecimal c1 = gain.multiply(fraction(d));
        BigDecimal a = dot(u, u).subtract(aa.multiply(c1.multiply(c1)));
        BigDecimal b = dot(u, w).subtract(aa.multiply(c0.multiply(c1)));
        BigDecimal c = dot(w, w).subtract(aa.multiply(c0.multiply(c0)));
        return roots(a, b, c);
    }

    private void addEnds(BigDecimal[] f, BigDecimal[] d, List<BigDecimal> crossings) {
        BigDecimal e = dot(d, axis);
        if (e.signum() == 0) {
            return;
        }
        BigDecimal pad = inflation.multiply(length);
        BigDecimal h = dot(f, axis);
        BigDecimal[] heights = {pad.negate(), dot(axis, axis).add(pad)};
        for (BigDecimal height : heights) {
            BigDecimal t = height.subtract(h).divide(e, MC);
            BigDecimal[] p = plus(f, d, t);
            BigDecimal r = radiusAt(fraction(p));
            if (r.signum() >= 0 && distanceSquared(p).compareTo(r.multiply(r)) <= 0) {
                crossings.add(t);
            }
        }
    }

    /**
     * The crossings with the lateral surface between the ends, in order and from the origin on; null if one is so close
     * to an end, to the origin or to the other one that roundings may decide.
     */
    List<BigDecimal> lateralCrossings(Vec3 origin, Vec3 direction) {
        BigDecimal[] f = minus(vector(origin), reference);
        BigDecimal[] d = vector(direction);
        List<BigDecimal> result = new ArrayList<>();
        BigDecimal previous = null;
        double close = 1e-9;
        for (BigDecimal t : lateralRoots(f, d)) {
            BigDecimal s = fraction(plus(f, d, t));
            double height = s.doubleValue();
            if (Math.abs(height) < close || Math.abs(height - 1) < close || Math.abs(t.doubleValue()) < close) {
                return null;
            }
            if (previous != null && Math.abs(t.subtract(previous).doubleValue()) < 1e-3 * (1 + t.doubleValue())) {
                return null;
            }
            if (height > 0 && height < 1 && t.signum() > 0) {
                result.add(t);
            }
            previous = t;
        }
        Collections.sort(result);
        return result;
    }

    /** The roots of at² + 2bt + c. */
    private static List<BigDecimal> roots(BigDecimal a, BigDecimal b, BigDecimal c) {
        BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c));
        if (discriminant.signum() < 0) {
            return List.of();
        }
        BigDecimal s = discriminant.sqrt(MC);
        if (a.signum() == 0) {
            return b.signum() == 0 ? List.of() : List.of(c.divide(b.negate().multiply(BigDecimal.valueOf(2)), MC));
        }
        return List.of(b.negate().subtract(s).divide(a, MC), b.negate().add(s).divide(a, MC));
    }

    /** The distance of a point from the solid's surface. */
    double distance(Vec3 point) {
        BigDecimal[] p = minus(vector(point), reference);
        if (axis == null) {
            return dot(p, p).sqrt(MC).subtract(radius0).abs().doubleValue();
        }
        // In the half plane through the axis: the distance from a polygon of three edges.
        BigDecimal z = dot(p, axis).divide(length, MC);
        BigDecimal r = distanceSquared(p).sqrt(MC);
        BigDecimal r1 = radius0.add(gain);
        double lateral = edge(r, z, radius0, ZERO, r1, length);
        double ends = Math.min(edge(r, z, ZERO, ZERO, radius0, ZERO), edge(r, z, ZERO, length, r1, length));
        return Math.min(lateral, ends);
    }

    /** The distance of a point from the lateral surface alone. */
    double lateralDistance(Vec3 point) {
        BigDecimal[] p = minus(vector(point), reference);
        BigDecimal z = dot(p, axis).divide(length, MC);
        return edge(distanceSquared(p).sqrt(MC), z, radius0, ZERO, radius0.add(gain), length);
    }

    private static double edge(BigDecimal r, BigDecimal z, BigDecimal r0, BigDecimal z0, BigDecimal r1, BigDecimal z1) {
        BigDecimal er = r1.subtract(r0);
        BigDecimal ez = z1.subtract(z0);
        BigDecimal ee = er.multiply(er).add(ez.multiply(ez));
        BigDecimal s = ZERO;
        if (ee.signum() > 0) {
            s = r.subtract(r0).multiply(er).add(z.subtract(z0).multiply(ez)).divide(ee, MC);
            s = s.max(ZERO).min(BigDecimal.ONE);
        }
        BigDecimal dr = r.subtract(r0).subtract(s.multiply(er));
        BigDecimal dz = z.subtract(z0).subtract(s.multiply(ez));
        return dr.multiply(dr).add(dz.multiply(dz)).sqrt(MC).doubleValue();
    }

    static BigDecimal big(double v) {
        return new BigDecimal(v);
    }

    static BigDecimal[] vector(Vec3 v) {
        return new BigDecimal[] {big(v.x()), big(v.y()), big(v.z())};
    }

    static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0])
                .add(a[1].multiply(b[1]))
                .add(a[2].multiply(b[2]))
                .round(MC);
    }

    static BigDecimal[] minus(BigDecimal[] a, BigDecimal[] b) {
        return new BigDecimal[] {a[0].subtract(b[0]), a[1].subtract(b[1]), a[2].subtract(b[2])};
    }

    static BigDecimal[] plus(BigDecimal[] a, BigDecimal[] d, BigDecimal t) {
        return new BigDecimal[] {
            a[0].add(d[0].multiply(t)).round(MC),
            a[1].add(d[1].multiply(t)).round(MC),
            a[2].add(d[2].multiply(t)).round(MC)
        };
    }

    static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
        return new BigDecimal[] {
            a[1].multiply(b[2]).subtract(a[2].multiply(b[1])).round(MC),
            a[2].multiply(b[0]).subtract(a[0].multiply(b[2])).round(MC),
            a[0].multiply(b[1]).subtract(a[1].multiply(b[0])).round(MC)
        };
    }
}
