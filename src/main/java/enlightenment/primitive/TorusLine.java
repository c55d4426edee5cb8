package enlightenment.primitive;

import enlightenment.numeric.Scale;

/**
 * A ray's line in the frame of one torus, and the search for its crossings: scratch that a {@link Ray} keeps, so that
 * testing a torus allocates nothing.
 *
 * <p>Lengths s along the line are measured from a base point. With ρ the distance from the axis and z the height above
 * the ring's plane, the inside of a torus of radii R and r is where
 *
 * <pre>  F = (ρ − R − r)(ρ − R + r) + z² &lt; 0,</pre>
 *
 * a form that keeps the sign of F however thin the tube is. Times a positive factor, F is a quartic in s; counted from
 * the point of the line closest to the centre it has no cubic term (numerics, "robust forms"):
 *
 * <pre>  G = (s² + |w|² + R² − r²)² − 4R²ρ²,   G′/4 = s³ + p·s + q.</pre>
 *
 * G has one minimum, or a minimum, a maximum and a minimum; below, a minimum is called a dip and the maximum a ridge. Where F is
 * negative at a dip the line runs inside, and between a dip and its neighbours it crosses the surface once. G only isolates the
 * crossings: signs and positions come from F. The ends of the bounding interval count as outside, so crossings always pair.
 *
 * <p>A line that starts on the torus is searched with (F(s) − F(0))/s in place of F: its start is no crossing, nor can
 * rounding make it one. That quotient has a form without cancellation, and it is F/s of the torus that passes through the start
 * exactly, whose tube is r + rounding. The sign just after the start is given by the side that the ray travels on.
 */
final class TorusLine {
    /** Widens the bounds of the search by more than their roundings: {@link #search} decides, not the bounds. */
    static final double SLACK = 1 + Scale.gamma(32);

    /** A search ends when its step is within the rounding of positions on the line. */
    private static final double RESOLUTION = Scale.gamma(2);

    /** More bisections than it takes from the size of the torus to the resolution. */
    private static final int MAX_STEPS = 128;

    /** The base point, in units of the scene, and the line's unit direction; z is along the torus's axis. */
    double bx;

    double by;
    double bz;
    double ex;
    double ey;
    double ez;

    private double major;
    private double minor;

    /** The ray's parameter at the base point, and the length of the ray's direction: t = tBase + s/length. */
    private double tBase;

    private double length;

    /** The interval of s that is searched. */
    private double lo;

    private double hi;
    private double resolution;

    private boolean onSurface;
    private double baseRho;
    private double baseSlope;
    private double flatness;

    /** The coefficients of G′/4 and where it turns, relative to the line's point closest to the centre; the base point from there. */
    private double p;

    private double q;
    private double turn;
    private double basePlace;

    /** The extrema of G: a dip, and if there are three, a ridge and another dip. */
    private boolean three;

    private boolean restFound;

    private double dip;
    private double ridge;
    private double secondDip;

    private double value;
    private double slope;

    /** The crossing found: its position on the line and the side that the ray arrives on. */
    double s;

    int side;

    /** Sets the torus, and how t and s are related; base and direction have been set before. */
    void begin(double majorRadius, double minorRadius, double tAtBase, double directionLength) {
        major = majorRadius;
        minor = minorRadius;
        tBase = tAtBase;
        length = directionLength;
        resolution = RESOLUTION * (major + minor);
        flatness = ex * ex + ey * ey;
    }

    double t(double place) {
        return tBase + place / length;
    }

    /** The nearest crossing of a line whose base is its point closest to the centre, or {@link Primitive#MISS}. */
    double fromFar(double tMin, double tMax) {
        onSurface = false;
        double closest = bx * bx + by * by + bz * bz;
        if (!bound(closest, 0) || t(hi) < tMin || t(lo) > tMax || inHole()) {
            return Primitive.MISS;
        }
        isolate(closest, Math.fma(bx, ex, by * ey), 0);
        return accept(search(0, false, tMin), tMax);
    }

    /** The nearest crossing, other than its base, of a line whose base lies on the surface. */
    double fromSurface(int startSide, double tMin, double tMax) {
        onSurface = true;
        baseRho = Math.sqrt(bx * bx + by * by);
        baseSlope = Math.fma(bx, ex, by * ey);
        minor = Math.sqrt((baseRho - major) * (baseRho - major) + bz * bz);
        double base = Math.fma(bz, ez, baseSlope);
        double wx = Math.fma(-base, ex, bx);
        double wy = Math.fma(-base, ey, by);
        double wz = Math.fma(-base, ez, bz);
        double closest = wx * wx + wy * wy + wz * wz;
        if (!bound(closest, base)) {
            lo = 0;
            hi = 0;
        }
        lo = 0;
        hi = Math.max(hi, 0);
        isolate(closest, Math.fma(wx, ex, wy * ey), base);
        boolean inside = startSide == Ray.INSIDE;
        int behind = extremaBehind(inside);
        return accept(search(behind, inside, tMin), tMax);
    }

    private static double accept(double t, double tMax) {
        return t <= tMax ? t : Primitive.MISS;
    }

    /** Sets lo and hi to the interval within the bounding sphere and slab; false if it is empty. */
    private boolean bound(double closest, double base) {
        double reach = major + minor;
        double half = Math.sqrt(reach * reach * SLACK - closest);
        lo = -half - base;
        hi = half - base;
        double top = Math.fma(reach, SLACK - 1, minor);
        if (ez != 0) {
            double below = (-top - bz) / ez;
            double above = (top - bz) / ez;
            lo = Math.max(lo, Math.min(below, above));
            hi = Math.min(hi, Math.max(below, above));
        } else if (Math.abs(bz) > top) {
            return false;
        }
        return lo <= hi;
    }

    /** Whether both ends of the interval lie in the hole: ρ is convex, so everything between them does. */
    private boolean inHole() {
        double hole = major - minor - (SLACK - 1) * (major + minor);
        return hole > 0 && rhoSquared(lo) < hole * hole && rhoSquared(hi) < hole * hole;
    }

    private double rhoSquared(double place) {
        double x = Math.fma(place, ex, bx);
        double y = Math.fma(place, ey, by);
        return x * x + y * y;
    }

    /** Prepares the extrema of G and finds the first dip; base is the base point's position from the closest point. */
    private void isolate(double closest, double radialDrift, double base) {
        p = Math.fma(-2 * major * major, flatness, closest + (major - minor) * (major + minor));
        q = -2 * major * major * radialDrift;
        basePlace = base;
        turn = DepressedCubic.turn(p);
        three = DepressedCubic.hasThreeRoots(q, turn);
        restFound = false;
        dip = three
                ? DepressedCubic.smallest(p, q, turn, resolution) - base
                : DepressedCubic.only(p, q, major + minor, resolution) - base;
    }

    /** Finds the ridge and the second dip; separate, because most rays end before them. */
    private void findRest() {
        if (!restFound) {
            secondDip = DepressedCubic.largest(p, q, turn, resolution) - basePlace;
            ridge = DepressedCubic.middle(p, q, turn, resolution) - basePlace;
            restFound = true;
        }
    }

    /** Clamps an extremum to the interval, at whose ends F is positive. */
    private double within(double place) {
        return Math.max(lo, Math.min(hi, place));
    }

    /**
     * How many extrema of G lie behind a start on the surface: an even number where F falls, as it must for a line that
     * goes inside, else an odd one. If rounding gives the wrong parity, the line is almost tangent, and the extremum closest to
     * the start is on the wrong side of it.
     */
    private int extremaBehind(boolean inside) {
        if (!three) {
            return inside ? 0 : 1;
        }
        findRest();
        if (ridge > 0) {
            // The start is before the ridge: before the dip the line goes inside, after it outside.
            boolean beforeDip = dip > 0;
            if (beforeDip == inside) {
                return inside ? 0 : 1;
            }
            return !inside ? 1 : -dip < ridge ? 0 : 2;
        }
        boolean beforeSecond = secondDip > 0;
        if (beforeSecond == inside) {
            return inside ? 2 : 3;
        }
        return inside ? 2 : secondDip < -ridge ? 3 : 1;
    }

    /** The t of the first crossing with t ≥ tMin, given how many extrema are behind the start. */
    private double search(int behind, boolean startsInside, double tMin) {
        boolean inside = startsInside;
        double first = within(dip);
        if (behind == 0 && !inside && valueAt(first) < 0) {
            if (crosses(lo, first, first, Ray.OUTSIDE, tMin)) {
                return t(s);
            }
            inside = true;
        }
        if (!three) {
            return inside && crosses(first, hi, first, Ray.INSIDE, tMin) ? t(s) : Primitive.MISS;
        }
        findRest();
        double top = within(ridge);
        double second = within(secondDip);
        boolean secondDeep = behind == 2 || behind < 2 && valueAt(second) < 0;
        if (behind == 0 && inside && !(secondDeep && valueAt(top) <= 0)) {
            if (crosses(first, secondDeep ? top : second, first, Ray.INSIDE, tMin)) {
                return t(s);
            }
            inside = false;
        }
        if (!secondDeep) {
            return Primitive.MISS;
        }
        boolean found = !inside && crosses(top, second, second, Ray.OUTSIDE, tMin)
                || crosses(second, hi, second, Ray.INSIDE, tMin);
        return found ? t(s) : Primitive.MISS;
    }

    /** Finds the crossing between a and b, one of which is the dip; whether its t is at least tMin. */
    private boolean crosses(double a, double b, double deep, int arriving, double tMin) {
        if (t(b) < tMin) {
            return false;
        }
        boolean leaving = arriving == Ray.INSIDE;
        s = root(a, b, guess(deep, leaving), leaving);
        side = arriving;
        return t(s) >= tMin;
    }

    /** The root of the parabola that osculates F at its dip: a good guess for thin tubes and for grazing lines. */
    private double guess(double deep, boolean leaving) {
        double x = Math.fma(deep, ex, bx);
        double y = Math.fma(deep, ey, by);
        double z = Math.fma(deep, ez, bz);
        double rho = Math.sqrt(x * x + y * y);
        double fromRing = rho - major;
        double rate = (x * ex + y * ey) / rho;
        double bend = ez * ez + rate * rate + fromRing * (flatness - rate * rate) / rho;
        double depth = (minor - fromRing) * (minor + fromRing) - z * z;
        double half = Math.sqrt(depth / bend);
        return leaving ? deep + half : deep - half;
    }

    /** Bracketed Newton. At a and b the signs of F are known, whatever its computed values there. */
    private double root(double from, double to, double start, boolean rising) {
        double a = from;
        double b = to;
        double x = start > a && start < b ? start : a + (b - a) / 2;
        double last = b - a;
        for (int i = 0; i < MAX_STEPS && last > resolution; i++) {
            evaluate(x);
            if (value < 0 == rising) {
                a = x;
            } else {
                b = x;
            }
            double next = x - value / slope;
            if (!(next > a && next < b && 2 * Math.abs(value) <= Math.abs(last * slope))) {
                next = a + (b - a) / 2;
            }
            last = Math.abs(next - x);
            x = next;
        }
        return x;
    }

    private double valueAt(double place) {
        evaluate(place);
        return value;
    }

    /** Sets value and slope to F and its derivative, or to those of (F(s) − F(0))/s for a start on the surface. */
    private void evaluate(double place) {
        double x = Math.fma(place, ex, bx);
        double y = Math.fma(place, ey, by);
        double z = Math.fma(place, ez, bz);
        double rho = Math.sqrt(x * x + y * y);
        double rate = rho > 0 ? (x * ex + y * ey) / rho : 0;
        double fromRing = rho - major;
        if (onSurface) {
            double sum = rho + baseRho;
            // ρ² − ρ₀² = s·growth, so that (ρ − ρ₀)/s = growth/sum.
            double growth = Math.fma(place, flatness, 2 * baseSlope);
            double perSum = sum > 0 ? 1 / sum : 0;
            double both = (fromRing + (baseRho - major)) * perSum;
            value = Math.fma(growth, both, ez * (z + bz));
            slope = flatness * both + growth * rate * (2 * major * perSum * perSum) + ez * ez;
        } else {
            value = (fromRing - minor) * (fromRing + minor) + z * z;
            slope = 2 * (fromRing * rate + z * ez);
        }
    }
}
