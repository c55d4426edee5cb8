package enlightenment.text;

/**
 * Text of unknown origin for terminals, logs and pages: what could move a cursor, colour or hide other text, turn the direction
 * of reading or begin a new line of a log is replaced by a question mark, and there is an end to its length. Letters,
 * digits, signs and accents of all languages stay.
 */
public final class Plain {
    /** Marks on one letter: more than these pile up over the lines around. */
    private static final int MOST_MARKS = 4;

    private static final int LONGEST_EXCERPT = 60;
    private static final String CUT = "...";

    private Plain() {}

    /** Whether a text can be said in UTF-8, which has no halves of surrogate pairs. */
    public static boolean isWellFormed(String text) {
        for (int i = 0; i < text.length(); i++) {
            boolean pair = Character.isHighSurrogate(text.charAt(i))
                    && i + 1 < text.length()
                    && Character.isLowSurrogate(text.charAt(i + 1));
            if (!pair && Character.isSurrogate(text.charAt(i))) {
                return false;
            }
            i += pair ? 1 : 0;
        }
        return true;
    }

    /**
     * One line.
     *
     * @param most the longest that it may be, in characters (of Java), at least 3
     */
    public static String line(String text, int most) {
        return plain(text, most, false);
    }

    /** Several lines, of any length: for what is put together here from texts that may come from elsewhere. */
    public static String lines(String text) {
        return plain(text, Integer.MAX_VALUE, true);
    }

    /** One line of at most 60 characters: as much of what somebody wrote as a message quotes. */
    public static String excerpt(String text) {
        return line(text, LONGEST_EXCERPT);
    }

    /** An {@link #excerpt} in quotation marks. */
    public static String quoted(String text) {
        return '"' + excerpt(text) + '"';
    }

    private static String plain(String text, int most, boolean keepsLines) {
        StringBuilder out = new StringBuilder(Math.min(text.length(), most));
        int marks = 0;
        for (int i = 0; i < text.length(); ) {
            int c = text.codePointAt(i);
            i += Character.charCount(c);
            marks = isMark(c) ? marks + 1 : 0;
            int shown = keepsLines && c == '\n' ? c : marks > MOST_MARKS ? '?' : shown(c);
            if (out.length() + Character.charCount(shown) > most) {
                return cut(out, most);
            }
            out.appendCodePoint(shown);
        }
        return out.toString();
    }

    private static String cut(StringBuilder out, int most) {
        int end = Math.max(Math.min(out.length(), most - CUT.length()), 0);
        if (end > 0 && Character.isHighSurrogate(out.charAt(end - 1))) {
            end--;
        }
        return out.substring(0, end) + CUT;
    }

    private static boolean isMark(int c) {
        int type = Character.getType(c);
        return type == Character.NON_SPACING_MARK || type == Character.ENCLOSING_MARK;
    }

    private static int shown(int c) {
        switch (Character.getType(c)) {
            case Character.SPACE_SEPARATOR:
                return ' ';
            case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE:
            case Character.UNASSIGNED, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR:
                return '?';
            default:
                return c;
        }
    }
}
