package enlightenment.scene.json;

/** Which numbers the scene format takes: those that neither vanish, overflow nor blow up when they are worked with. */
final class Numbers {
    static final int MAX_DIGITS = 1200;
    static final int MAX_EXPONENT = 400;
    private static final int SHOWN = 40;

    private Numbers() {}

    /**
     * Why a number is refused, or null where it is fine. Looks at the text only, so that an exponent of a billion costs
     * nothing.
     *
     * @param text a number in JSON's grammar
     */
    static String problem(String text) {
        int n = text.length();
        int digits = 0;
        boolean zero = true;
        int i = 0;
        for (; i < n; i++) {
            char c = text.charAt(i);
            if (c == 'e' || c == 'E') {
                break;
            }
            if (c >= '0' && c <= '9') {
                digits++;
                zero &= c == '0';
            }
        }
        if (digits > MAX_DIGITS) {
            return "must have at most " + MAX_DIGITS + " digits, not " + digits + " (" + shortened(text) + ")";
        }
        if (i < n && exponentIsHuge(text, i + 1)) {
            return "must have an exponent in -" + MAX_EXPONENT + ".." + MAX_EXPONENT + ", unlike " + shortened(text);
        }
        if (zero || n < 9 && i == n) {
            return null;
        }
        double value = Double.parseDouble(text);
        if (value == 0) {
            return "must not be so small that it becomes 0, like " + shortened(text) + "; the least is "
                    + Double.MIN_VALUE;
        }
        return Double.isInfinite(value)
                ? "must not be so large, like " + shortened(text) + "; the most is " + Double.MAX_VALUE
                : null;
    }

    private static boolean exponentIsHuge(String text, int from) {
        int exponent = 0;
        for (int i = from; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c >= '0' && c <= '9') {
                exponent = 10 * exponent + (c - '0');
                if (exponent > MAX_EXPONENT) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The number's text, cut where it is long. */
    static String shortened(String text) {
        return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "…";
    }
}
