package enlightenment.scene.json.tree;

import enlightenment.text.Plain;
import java.io.IOException;
import java.io.Reader;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.StreamConstraintsException;

/** Messages for text that is not JSON: the characters found, and those expected. */
final class SyntaxError {
    private static final int CONTEXT = 80;
    private static final String DELIMITERS = ",:[]{}\"'";
    private static final Pattern JSON_WORD =
            Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?|true|false|null");
    private static final Pattern UNEXPECTED = Pattern.compile("Unexpected character \\('(.)'.*", Pattern.DOTALL);
    private static final Pattern BRACKET = Pattern.compile(".*close marker '(.)'(: expected '(.)')?.*", Pattern.DOTALL);

    private SyntaxError() {}

    /** The word at an error, between blanks and punctuation; text "" if there is none. */
    private record Word(String text, int column) {}

    static void report(JsonParser parser, JacksonException e, JsonTree.Source source, Problems problems)
            throws IOException {
        TokenStreamLocation at = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
        String pointer = parser.streamReadContext().pathAsPointer().toString();
        int line = at.getLineNr();
        if (e instanceof StreamConstraintsException) {
            problems.add(line, at.getColumnNr(), pointer, tooMuch(e.getOriginalMessage()));
            return;
        }
        if (e.getOriginalMessage().contains("end-of-input")) {
            String message = "the text ends too early; a closing bracket, brace or quote is missing";
            problems.add(line, at.getColumnNr(), pointer, message);
            return;
        }
        String withinText = WrongCharacter.withinText(e.getOriginalMessage());
        if (withinText != null) {
            problems.add(line, at.getColumnNr(), pointer, "is not JSON: " + withinText);
            return;
        }
        Word word = wordAt(source, line, at.getColumnNr());
        String wrongWord = wrongWord(word.text());
        if (wrongWord == null) {
            problems.add(line, at.getColumnNr(), pointer, "is not JSON: " + reason(e.getOriginalMessage()));
        } else {
            problems.add(line, word.column(), pointer, "is not JSON: " + wrongWord);
        }
    }

    private static String tooMuch(String theirs) {
        return theirs.contains("nesting")
                ? "is nested more than " + JsonTree.DEEPEST_NESTING + " levels deep"
                : JsonTree.TOO_LONG;
    }

    /** The message for a word that is not JSON; null if the word is not the error. */
    private static String wrongWord(String word) {
        if (word.isEmpty() || JSON_WORD.matcher(word).matches()) {
            return null;
        }
        String found = Plain.quoted(word);
        if (word.matches("[-+.0-9].*")) {
            return found + " is not a number; expected a decimal number such as 8, -0.5 or 1e-3";
        }
        return word.matches("[\\p{L}_$].*") ? found + " needs double quotes, if it is meant as a text or a key" : null;
    }

    /** The parser's message, reworded for authors of scenes. */
    private static String reason(String theirs) {
        String betweenValues = WrongCharacter.betweenValues(theirs);
        if (betweenValues != null) {
            return betweenValues;
        }
        Matcher bracket = BRACKET.matcher(theirs);
        if (bracket.matches()) {
            String expected = bracket.group(3) == null ? "nothing is open" : "expected '" + bracket.group(3) + "'";
            return "found '" + bracket.group(1) + "', " + expected;
        }
        Matcher unexpected = UNEXPECTED.matcher(theirs);
        if (unexpected.matches()) {
            String found = "found '" + unexpected.group(1) + "'";
            if (theirs.contains("expecting comma")) {
                return found + ", expected a comma or a closing bracket";
            }
            if (theirs.contains("expecting a colon")) {
                return found + ", expected a colon";
            }
            if (theirs.contains("start property name")) {
                return found + ", expected a key in double quotes";
            }
            if (theirs.contains("expected a valid value")) {
                String hint = unexpected.group(1).equals("'") ? "; a text needs double quotes" : "";
                return found + " where a value should stand" + hint;
            }
        }
        return theirs.replaceAll("\\[Source:[^\\]]*\\]", "the text").replaceAll("\\s*\\(code \\d+[^)]*\\)", "");
    }

    private static Word wordAt(JsonTree.Source source, int line, int column) throws IOException {
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
                // A word beside a quote is part of a text that began or ended at the wrong place.
                boolean quoted =
                        from > 0 && text.charAt(from - 1) == '"' || to < text.length() && text.charAt(to) == '"';
                return new Word(quoted ? "" : text.substring(from, to), column - at + from);
            }
        }
        return new Word("", column);
    }

    private static boolean isWord(char c) {
        return !Character.isWhitespace(c) && DELIMITERS.indexOf(c) < 0;
    }

    /** Up to CONTEXT characters on each side of a place in one line. The place is at index min(column - 1, CONTEXT). */
    private static String around(JsonTree.Source source, int line, int column) throws IOException {
        StringBuilder kept = new StringBuilder();
        try (Reader reader = source.open()) {
            int l = 1;
            int c = 1;
            int previous = 0;
            for (int ch = reader.read(); ch >= 0 && l <= line; ch = reader.read()) {
                boolean secondOfLineEnd = ch == '\n' && previous == '\r';
                previous = ch;
                if (secondOfLineEnd) {
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
            }
        }
        return kept.toString();
    }
}
