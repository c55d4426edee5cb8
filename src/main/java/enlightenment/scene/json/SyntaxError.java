package enlightenment.scene.json;

import java.io.IOException;
import java.io.Reader;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.TokenStreamLocation;

/** Says what is wrong with a text that is not JSON: what stands there, and what could. */
final class SyntaxError {
    private static final int CONTEXT = 80;
    private static final String DELIMITERS = ",:[]{}\"'";

    private SyntaxError() {}

    static void report(JsonParser parser, JacksonException e, JsonTree.Source source, Problems problems)
            throws IOException {
        TokenStreamLocation at = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
        String pointer = parser.streamReadContext().pathAsPointer().toString();
        String word = wordAt(source, at.getLineNr(), at.getColumnNr());
        problems.add(at.getLineNr(), at.getColumnNr(), pointer, message(e.getOriginalMessage(), word));
    }

    private static String message(String theirs, String word) {
        if (theirs.contains("end-of-input") || theirs.contains("end of input")) {
            return "the text ends too early; a closing bracket, brace or quote is missing";
        }
        if (theirs.contains("nesting depth")) {
            return "is nested more than " + JsonTree.DEEPEST_NESTING + " levels deep";
        }
        if (theirs.contains("Number value length")) {
            return "is a number of more than " + JsonTree.LONGEST_NUMBER + " characters";
        }
        String found = JsonValue.quoted(word);
        if (word.matches("[-+.]?[0-9.].*|[-+].*")) {
            return "is not JSON: " + found + " is not a number; expected a decimal number such as 8, -0.5 or 1e-3";
        }
        if (word.matches("[\\p{L}_$].*")) {
            return "is not JSON: " + found + " needs double quotes, if it is meant as a text or a key";
        }
        String reason = theirs.replaceAll("\\s*\\(from `[^`]*`\\)|, from `[^`]*`", "")
                .replaceAll("\\s*\\(code \\d+[^)]*\\)", "")
                .replaceAll("[;:] enable `[^`]*` to allow", "");
        return "is not JSON: " + reason;
    }

    /** The word around a place: the longest run of characters that are neither blank nor punctuation of JSON. */
    private static String wordAt(JsonTree.Source source, int line, int column) throws IOException {
        String text = around(source, line, column);
        int at = Math.min(column, CONTEXT + 1) - 1;
        for (int i = Math.min(at, text.length() - 1); i >= Math.max(0, at - 1); i--) {
            if (isWord(text.charAt(i))) {
                int from = i;
                int to = i + 1;
                while (from > 0 && isWord(text.charAt(from - 1))) {
                    from--;
                }
                while (to < text.length() && isWord(text.charAt(to))) {
                    to++;
                }
                return text.substring(from, to);
            }
        }
        return "";
    }

    private static boolean isWord(char c) {
        return !Character.isWhitespace(c) && DELIMITERS.indexOf(c) < 0;
    }

    /** Up to CONTEXT characters on each side of a place in one line; the place is at index min(column - 1, CONTEXT). */
    private static String around(JsonTree.Source source, int line, int column) throws IOException {
        StringBuilder kept = new StringBuilder();
        try (Reader reader = source.open()) {
            int l = 1;
            int c = 1;
            int previous = 0;
            for (int ch = reader.read(); ch >= 0 && l <= line; ch = reader.read()) {
                if (ch == '\n' && previous == '\r') {
                    previous = ch;
                    continue;
                }
                if (ch == '\n' || ch == '\r') {
                    l++;
                    c = 1;
                } else {
                    if (l == line && Math.abs(c - column) <= CONTEXT) {
                        kept.append((char) ch);
                    }
                    c++;
                }
                previous = ch;
            }
        }
        return kept.toString();
    }
}
