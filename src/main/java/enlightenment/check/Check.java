package enlightenment.check;

import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;

/**
 * Checks of values that come from outside. A failed check throws {@link InvalidValueException} with the key of the scene format
 * (or the setting) that holds the value, so that a reader of files can point at its place and a program's author recognises it.
 */
public final class Check {
    private Check() {}

    /** Throws, with this problem at this key, unless the condition holds. */
    public static void that(boolean condition, String key, String problem) {
        if (!condition) {
            throw new InvalidValueException(key, problem);
        }
    }

    /** Finite and greater than zero. */
    public static void positive(String key, double v) {
        // The message is only built where it is needed: a scene may have millions of numbers.
        if (!(v > 0 && v < Double.POSITIVE_INFINITY)) {
            throw new InvalidValueException(key, "must be a number greater than 0, not " + v);
        }
    }

    /** Finite and at least zero. */
    public static void notNegative(String key, double v) {
        if (!(v >= 0 && v < Double.POSITIVE_INFINITY)) {
            throw new InvalidValueException(key, "must be a number of at least 0, not " + v);
        }
    }

    /** Between lo and hi, both included. */
    public static void range(String key, double v, double lo, double hi) {
        if (!(v >= lo && v <= hi)) {
            throw new InvalidValueException(key, "must lie in " + lo + ".." + hi + ", not " + v);
        }
    }

    /** Neither infinite nor NaN. */
    public static void finite(String key, double v) {
        if (!Double.isFinite(v)) {
            throw new InvalidValueException(key, "must be a finite number, not " + v);
        }
    }

    /** Finite and not the zero vector. */
    public static void direction(String key, Vec3 v) {
        that(v.isFinite() && v.maxAbs() > 0, key, "must be a finite direction other than (0, 0, 0)");
    }
}
