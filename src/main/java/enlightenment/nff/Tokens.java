package enlightenment.nff;

import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;

/**
 * The words of an NFF file in order. The format is given in lines, but files in use break them as they like (cones on one
 * line, polygons on one line), so only words count; comments end with their line.
 */
final class Tokens {
    /** Decimals beyond this exponent are no doubles, and exact arithmetic with them would take forever. */
    private static final int MAX_EXPONENT = 400;

    /** No number that a program wrote has more characters. */
    private static final int MAX_NUMBER_LENGTH = 400;

    private final String text;
    private int position;
    private int line = 1;
    private int lineStart;
    private NffToken next;

    Tokens(String text) {
        this.text = text;
        advance();
    }

    /** The next word, which stays. */
    NffToken peek() {
        return next;
    }

    /** The next word, which is consumed. */
    NffToken take() {
        NffToken t = next;
        advance();
        return t;
    }

    private void advance() {
        skipBlanks();
        int start = position;
        while (position < text.length() && !isBlank(text.charAt(position)) && text.charAt(position) != '#') {
            position++;
        }
        next = new NffToken(text.substring(start, position), line, start - lineStart + 1);
    }

    private void skipBlanks() {
        boolean comment = false;
        while (position < text.length()) {
            char c = text.charAt(position);
            if (c == '\n') {
                line++;
                lineStart = position + 1;
                comment = false;
            } else if (c == '#') {
                comment = true;
            } else if (!comment && !isBlank(c)) {
                return;
            }
            position++;
        }
    }

    /** Control characters too: old files end with Ctrl-Z or have form feeds. */
    private static boolean isBlank(char c) {
        return c <= ' ' || c == '\uFEFF';
    }

    /** An exact decimal. */
    BigDecimal decimal(String what) throws NffSyntaxException {
        NffToken t = take();
        if (t.text().length() > MAX_NUMBER_LENGTH) {
            throw new NffSyntaxException(
                    t, "expected " + what + ", not a word of " + t.text().length() + " characters");
        }
        BigDecimal value;
        try {
            value = new BigDecimal(t.text());
        } catch (NumberFormatException e) {
            throw new NffSyntaxException(t, "expected " + what + " (a number), not " + t.quoted());
        }
        long exponent = (long) value.precision() - value.scale();
        boolean sane = value.signum() == 0 || exponent > -MAX_EXPONENT && Double.isFinite(value.doubleValue());
        if (!sane) {
            throw new NffSyntaxException(
                    t, "expected " + what + " between 1e-400 and 1.7e308 in size, not " + t.quoted());
        }
        return value.signum() == 0 ? BigDecimal.ZERO : value;
    }

    /** A decimal, rounded once. */
    double number(String what) throws NffSyntaxException {
        return decimal(what).doubleValue();
    }

    ExactPoint point(String what) throws NffSyntaxException {
        BigDecimal x = decimal(what + " x");
        BigDecimal y = decimal(what + " y");
        return new ExactPoint(x, y, decimal(what + " z"));
    }

    Vec3 direction(String what) throws NffSyntaxException {
        return point(what).toVec3();
    }

    /** A whole number between lo and hi. */
    int count(String what, int lo, int hi) throws NffSyntaxException {
        NffToken t = peek();
        BigDecimal value = decimal(what);
        BigDecimal whole = value.stripTrailingZeros();
        boolean inside = whole.scale() <= 0
                && whole.compareTo(BigDecimal.valueOf(lo)) >= 0
                && whole.compareTo(BigDecimal.valueOf(hi)) <= 0;
        if (!inside) {
            throw new NffSyntaxException(
                    t, "expected " + what + " (a whole number in " + lo + ".." + hi + "), not " + t.quoted());
        }
        return whole.intValueExact();
    }
}
