package enlightenment.photometry;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** Lines, then numbers between blanks, commas and line ends, of a text in memory. */
final class IesText {
    /** The most characters of a number. */
    private static final int LONGEST_NUMBER = 64;

    private final byte[] content;
    private int at;

    /** The line of what was read last. */
    private int line = 1;

    /** The line of {@link #at}. */
    private int next = 1;

    IesText(byte[] content) {
        this.content = content;
    }

    /** A failure at the line of what was read last. */
    IOException failure(String what) {
        return new IOException("line " + line + ": " + what);
    }

    boolean atEnd() {
        return at >= content.length;
    }

    /** The rest of the line, without blanks around it; empty at the end. */
    String line() {
        line = next;
        int start = at;
        while (at < content.length && content[at] != '\n' && content[at] != '\r') {
            at++;
        }
        String text = new String(content, start, at - start, StandardCharsets.ISO_8859_1).strip();
        if (at < content.length) {
            boolean isPair = content[at] == '\r' && at + 1 < content.length && content[at + 1] == '\n';
            at += isPair ? 2 : 1;
            next++;
        }
        return text;
    }

    private boolean isBetween() {
        byte c = content[at];
        return c == ' ' || c == '\t' || c == ',' || c == '\n' || c == '\r';
    }

    private String word(String what) throws IOException {
        while (at < content.length && isBetween()) {
            boolean endsPair = content[at] == '\n' && at > 0 && content[at - 1] == '\r';
            next += (content[at] == '\n' || content[at] == '\r') && !endsPair ? 1 : 0;
            at++;
        }
        line = next;
        int start = at;
        while (at < content.length && !isBetween()) {
            at++;
        }
        if (at == start) {
            throw failure("ends where " + what + " is expected");
        }
        if (at - start > LONGEST_NUMBER) {
            throw failure("has more than " + LONGEST_NUMBER + " characters where " + what + " is expected");
        }
        return new String(content, start, at - start, StandardCharsets.ISO_8859_1);
    }

    /** A finite number. */
    double number(String what) throws IOException {
        String word = word(what);
        if (!word.matches("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?")) {
            throw failure("has " + Plain.quoted(word) + " where " + what + " is expected, a number");
        }
        double value = Double.parseDouble(word);
        if (!Double.isFinite(value)) {
            throw failure("has " + Plain.quoted(word) + " for " + what + ", beyond the range of doubles");
        }
        return value;
    }

    /** A finite number of at least 0. */
    double notNegative(String what) throws IOException {
        double value = number(what);
        if (value < 0) {
            throw failure("has " + value + " for " + what + ", which is at least 0");
        }
        return value;
    }

    /** A whole number of a range; it may be written with a point. */
    int count(String what, int least, int most) throws IOException {
        double value = number(what);
        if (!(value >= least && value <= most) || value != Math.rint(value)) {
            throw failure("has " + value + " for " + what + ", a whole number in " + least + ".." + most);
        }
        return (int) value;
    }
}
