package enlightenment.primitive;

/**
 * Roots of s³ + p·s + q: the derivative (over 4) of a quartic without cubic term, whose roots are the quartic's
 * extrema.
 *
 * <p>Every root is approached by Newton's method from a side where the curvature keeps the iterates on that side, so
 * none can escape. Only {@code + - * /} and fused steps are used, so the roots scale exactly with powers of two.
 */
final class DepressedCubic {
    /** Newton's method at least halves the distance to a root in each step, near a double root no more than that. */
    private static final int MAX_STEPS = 64;

    private DepressedCubic() {}

    /**
     * Whether all three roots are real, given {@code turn}, the position of the cubic's minimum (0 if it has none); if so, they
     * are separated by ∓turn.
     */
    static boolean hasThreeRoots(double q, double turn) {
        return turn > 0 && Math.abs(q) <= 2 * turn * turn * turn;
    }

    /** The position of the cubic's minimum, 0 if it is monotone; its maximum is at minus that. */
    static double turn(double p) {
        return p < 0 ? Math.sqrt(-p / 3) : 0;
    }

    /** The smallest of three real roots. */
    static double smallest(double p, double q, double turn, double tolerance) {
        return -descend(p, -q, 2 * turn, turn, tolerance);
    }

    /** The largest of three real roots; it lies in turn..2·turn. */
    static double largest(double p, double q, double turn, double tolerance) {
        return descend(p, q, 2 * turn, turn, tolerance);
    }

    /** The middle one of three real roots. It lies between the origin, an inflection, and a turn. */
    static double middle(double p, double q, double turn, double tolerance) {
        double s = 0;
        for (int i = 0; i < MAX_STEPS; i++) {
            double slope = Math.fma(3 * s, s, p);
            double step = slope < 0 ? evaluate(p, q, s) / slope : 0;
            s = Math.max(-turn, Math.min(turn, s - step));
            if (Math.abs(step) <= tolerance) {
                break;
            }
        }
        return s;
    }

    /** The only real root, or ±limit, with the root's sign, if the root is farther from 0. */
    static double only(double p, double q, double limit, double tolerance) {
        return q > 0 ? -onlyPositive(p, -q, limit, tolerance) : onlyPositive(p, q, limit, tolerance);
    }

    private static double onlyPositive(double p, double q, double limit, double tolerance) {
        if (q == 0) {
            return 0;
        }
        // -q/p is where the line p·s + q vanishes, beyond the root. So is the limit, unless the root is beyond it.
        double start = p > 0 ? Math.min(limit, -q / p) : limit;
        return evaluate(p, q, start) <= 0 ? start : descend(p, q, start, 0, tolerance);
    }

    /**
     * Newton's method from the right of the largest root, where the cubic rises and is convex; at a double root, where
     * rounding could make a step too long, it stops at the floor.
     */
    private static double descend(double p, double q, double from, double floor, double tolerance) {
        double s = from;
        for (int i = 0; i < MAX_STEPS; i++) {
            double step = evaluate(p, q, s) / Math.fma(3 * s, s, p);
            if (!(step > 0)) {
                break;
            }
            s = Math.max(s - step, floor);
            if (step <= tolerance) {
                break;
            }
        }
        return s;
    }

    private static double evaluate(double p, double q, double s) {
        return Math.fma(Math.fma(s, s, p), s, q);
    }
}
