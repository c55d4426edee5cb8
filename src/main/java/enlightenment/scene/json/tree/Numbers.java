package enlightenment.scene.json.tree;

import enlightenment.text.Plain;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Conversions between the text of JSON numbers and their values. */
public final class Numbers {
    /** The largest decimal exponent accepted, beyond the range of doubles: larger ones are mistakes or attacks. */
    public static final int LARGEST_EXPONENT = 400;

    /** More digits than the longest exact double has (767), and than the number of any frame ({@link Tracks}). */
    public static final int MOST_DIGITS = 2000;

    /** The most characters of a number without exponent that is certainly within the range of doubles. */
    private static final int SAFE = 300;

    private static final int LEAST_PLAIN_EXPONENT = -7;
    private static final int GREATEST_PLAIN_EXPONENT = 20;

    private Numbers() {}

    /**
     * The reason to refuse a number's text, or null. The number is not expanded: a short text for a number of a billion digits costs nothing.
     */
    public static String objection(String text) {
        if (isPlain(text)) {
            return null;
        }
        int e = exponentIndex(text);
        int digits = 0;
        for (int i = 0; i < e; i++) {
            char c = text.charAt(i);
            if (c >= '0' && c <= '9') {
                digits++;
            } else if (c != '.' && !(c == '-' && i == 0)) {
                return "must be a finite number, not " + Plain.excerpt(text);
            }
        }
        if (digits > MOST_DIGITS) {
            return "has " + digits + " digits; a number may have at most " + MOST_DIGITS;
        }
        if (isZero(text)) {
            return null;
        }
        if (!exponentIsModest(text, e)) {
            return "must be a number that a double can hold, not " + Plain.excerpt(text) + ": its exponent is beyond "
                    + LARGEST_EXPONENT;
        }
        if (digits <= SAFE && e == text.length()) {
            return null;
        }
        double d = Double.parseDouble(text);
        if (Double.isInfinite(d)) {
            return "must be a number that a double can hold (at most 1.8e308), not " + Plain.excerpt(text);
        }
        if (d == 0) {
            return "must be 0 or a number that a double can hold (at least 4.9e-324), not " + Plain.excerpt(text);
        }
        return null;
    }

    /** Whether a text is short and has no exponent, so that there is no objection to it. */
    private static boolean isPlain(String text) {
        int length = text.length();
        for (int i = 0; i < length; i++) {
            char c = text.charAt(i);
            if ((c < '0' || c > '9') && c != '.' && !(c == '-' && i == 0)) {
                return false;
            }
        }
        return length <= SAFE;
    }

    private static int exponentIndex(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) == 'e' || text.charAt(i) == 'E') {
                return i;
            }
        }
        return text.length();
    }

    private static boolean exponentIsModest(String text, int e) {
        int value = 0;
        for (int i = e + 1; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c >= '0' && c <= '9') {
                value = 10 * value + (c - '0');
                if (value > LARGEST_EXPONENT) {
                    return false;
                }
            }
        }
        return true;
    }

    /** The exact value of a text without {@linkplain #objection objections}; any spelling of zero gives 0. */
    public static BigDecimal exact(String text) {
        return new BigDecimal(decimal(text));
    }

    /** A text without objections in a form that BigDecimal parses: a zero with too large an exponent becomes "0". */
    public static String decimal(String text) {
        return isPlain(text) || exponentIsModest(text, exponentIndex(text)) ? text : "0";
    }

    private static boolean isZero(String text) {
        for (int i = 0, e = exponentIndex(text); i < e; i++) {
            if (text.charAt(i) >= '1' && text.charAt(i) <= '9') {
                return false;
            }
        }
        return true;
    }

    /**
     * The shortest text whose nearest double is v; of several, the one nearest to v. Unlike {@code Double.toString}, the result does not depend on
     * the version of Java.
     */
    public static String text(double v) {
        if (v == Math.rint(v) && Math.abs(v) < 1e15) {
            return v == 0 && 1 / v < 0 ? "-0.0" : Long.toString((long) v);
        }
        BigDecimal exact = new BigDecimal(v);
        for (int digits = 1; ; digits++) {
            BigDecimal rounded = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
            if (rounded.doubleValue() == v) {
                return text(rounded);
            }
        }
    }

    /** The exact text of a number: without exponent where that is short, else with one. */
    public static String text(BigDecimal v) {
        if (v.signum() == 0) {
            return "0";
        }
        BigDecimal s = v.stripTrailingZeros();
        int exponent = s.precision() - s.scale() - 1;
        if (exponent >= LEAST_PLAIN_EXPONENT && exponent <= GREATEST_PLAIN_EXPONENT) {
            return s.toPlainString();
        }
        String digits = s.unscaledValue().abs().toString();
        String fraction = digits.length() == 1 ? "" : "." + digits.substring(1);
        return (s.signum() < 0 ? "-" : "") + digits.charAt(0) + fraction + "e" + exponent;
    }
}
