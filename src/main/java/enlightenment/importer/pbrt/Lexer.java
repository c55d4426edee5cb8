package enlightenment.importer.pbrt;

import enlightenment.text.Plain;
import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads the tokens of one file, character by character: a file is never in memory as a whole. */
final class Lexer implements Closeable {
    /** The longest token, in characters. */
    static final int LONGEST = 1 << 14;

    private static final int END = -1;

    private final Path file;
    private final boolean isMain;
    private final Reader in;
    private final StringBuilder text = new StringBuilder();
    private int next;
    private int line = 1;
    private long characters;

    /** @param isMain whether it is the imported file, and none that it includes */
    Lexer(Path file, boolean isMain) throws IOException {
        this.file = file;
        this.isMain = isMain;
        in = new BufferedReader(new InputStreamReader(Files.newInputStream(file), StandardCharsets.UTF_8));
        next = in.read();
    }

    Path file() {
        return file;
    }

    /** How much has been read. */
    long characters() {
        return characters;
    }

    /** Where reading stands. */
    Place place() {
        return new Place(file, line, isMain);
    }

    /** The next token; null at the end of the file. */
    Token next() throws IOException {
        skipBlanks();
        Place place = place();
        if (next == END) {
            return null;
        }
        if (next == '[' || next == ']') {
            Token.Kind kind = next == '[' ? Token.Kind.OPEN : Token.Kind.CLOSE;
            String bracket = String.valueOf((char) next);
            advance();
            return new Token(kind, bracket, place);
        }
        text.setLength(0);
        if (next == '"') {
            string(place);
            return new Token(Token.Kind.STRING, text.toString(), place);
        }
        while (next != END && !isBlank(next) && next != '"' && next != '[' && next != ']' && next != '#') {
            append(place);
        }
        return new Token(Token.Kind.WORD, text.toString(), place);
    }

    private void string(Place place) throws IOException {
        advance();
        while (next != '"') {
            if (next == END || next == '\n') {
                throw place.failure(
                        "a string has no closing quotation mark on its line: " + Plain.quoted(text.toString()));
            }
            if (next == '\\') {
                advance();
                escape(place);
            } else {
                append(place);
            }
        }
        advance();
    }

    private void escape(Place place) throws IOException {
        int of = "nrtbf\\\"'".indexOf(next);
        if (of < 0 || next == END) {
            throw place.failure(
                    "a string has an escape that pbrt does not know; it has \\n \\r \\t \\b \\f \\\\ \\\" \\'");
        }
        text.append("\n\r\t\b\f\\\"'".charAt(of));
        advance();
    }

    private void append(Place place) throws IOException {
        if (text.length() >= LONGEST) {
            throw place.failure(
                    "a word or string is longer than " + LONGEST + " characters: " + Plain.quoted(text.toString()));
        }
        text.append((char) next);
        advance();
    }

    private void skipBlanks() throws IOException {
        while (isBlank(next) || next == '#') {
            if (next == '#') {
                while (next != END && next != '\n') {
                    advance();
                }
            } else {
                advance();
            }
        }
    }

    private static boolean isBlank(int c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    }

    private void advance() throws IOException {
        if (next == '\n') {
            line++;
        }
        next = in.read();
        characters++;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
