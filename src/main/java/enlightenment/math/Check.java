package enlightenment.math;

/**
 * Checks of values that come from outside. A failed check names the key of the scene format (or the setting) that holds the
 * value, so that a reader can point at it, and whoever makes the value in a program knows which it is.
 */
public final class Check {
    private Check() {}

    /** A value that cannot be used. The message is {@code KEY: PROBLEM}, such as {@code radius: must be ..., not -1.0}. */
    public static final class InvalidValueException extends IllegalArgumentException {
        private static final long serialVersionUID = 1L;
        private final String key;
        private final String problem;

        /**
         * @param key where the value is, see {@link #key}; "" where that is what the message speaks of as a whole
         * @param problem what is wrong with it, see {@link #problem}
         */
        public InvalidValueException(String key, String problem) {
            super(key.isEmpty() ? problem : key + ": " + problem);
            this.key = key;
            this.problem = problem;
        }

        /** The key of the scene format that holds the value, as a relative JSON pointer without the leading slash. */
        public String key() {
            return key;
        }

        /** What is wrong, without the key: for who tells the place in another way. */
        public String problem() {
            return problem;
        }
    }

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
