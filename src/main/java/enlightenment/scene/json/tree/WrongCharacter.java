package enlightenment.scene.json.tree;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Messages for single wrong characters in place of the parser's, which state its own rules only. */
final class WrongCharacter {
    private static final String BACKSLASH =
            " means nothing in a text: a backslash is written \\\\, and / does as well in the path of a file";
    private static final Pattern ESCAPE =
            Pattern.compile("Unrecognized character escape (?:'(.)'|\\(CTRL-CHAR).*", Pattern.DOTALL);
    private static final Pattern CONTROL = Pattern.compile(".*\\(CTRL-CHAR, code ([0-9]+).*", Pattern.DOTALL);

    private WrongCharacter() {}

    /**
     * The message for a character that is not allowed within a text or key.
     *
     * @param theirs the parser's message
     * @return null if the parser's message is about another problem
     */
    static String withinText(String theirs) {
        Matcher escape = ESCAPE.matcher(theirs);
        if (escape.matches()) {
            return (escape.group(1) == null
                            ? "\\ before the end of a line or a control character"
                            : "\\" + escape.group(1))
                    + BACKSLASH;
        }
        if (theirs.contains("hex-digit")) {
            return "\\u without four hexadecimal digits" + BACKSLASH;
        }
        if (!theirs.contains("has to be escaped")) {
            return null;
        }
        return switch (control(theirs)) {
            // No number in the message (−1) means another version of the parser: a line end is the most frequent case.
            case '\n', '\r', -1 -> "a text does not end in its line; a double quote is missing";
            case '\t' -> "a tab in a text must be written as \\t";
            default -> "a control character in a text must be written as " + escaped(control(theirs));
        };
    }

    /** A message for a character that must not stand outside of texts; null where the parser means another problem. */
    static String betweenValues(String theirs) {
        int character = control(theirs);
        if (character < 0) {
            return null;
        }
        return character == 0
                ? "found a character NUL, as texts in UTF-16 have them; a scene file must be a text in UTF-8"
                : String.format(
                                Locale.ROOT,
                                "found the control character U+%04X, which may stand only in a text, as ",
                                character)
                        + escaped(character);
    }

    private static String escaped(int character) {
        return String.format(Locale.ROOT, "\\u%04x", character);
    }

    /** The control character that a message is about; -1 for none. */
    private static int control(String theirs) {
        Matcher control = CONTROL.matcher(theirs);
        return control.matches() ? Integer.parseInt(control.group(1)) : -1;
    }
}
