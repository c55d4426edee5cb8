package enlightenment.mesh.input;

import enlightenment.text.Plain;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/**
 * Reads words and numbers of a text in pieces of 64 KiB. Lines end with LF, CR LF or CR. A line has at most 1 MiB, a number 400 characters, a
 * name 4 KiB.
 */
public final class TextInput {
    private static final int LONGEST_LINE = 1 << 20;
    private static final int LONGEST_NUMBER = 400;
    private static final int LONGEST_NAME = 1 << 12;
    private static final int PIECE = 1 << 16;

    /** The bytes that are in the buffer where a word or number begins, unless the text ends before: more than the longest. */
    private static final int AHEAD = 1 << 13;

    /** The largest mantissa and power of ten that are doubles: one product or quotient of them is rounded once (Clinger, 1990). */
    private static final long LARGEST_EXACT = 1L << 53;

    private static final double[] POWERS = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22
    };

    /** A mantissa that can take one more digit as a long. */
    private static final long MOST = 100_000_000_000_000_000L;

    private final MeshSource source;
    private final InputStream in;

    /** One byte longer than a piece: a 0 follows the last byte. */
    private final byte[] buffer = new byte[PIECE + 1];

    private int at;
    private int end;
    private boolean hasEnded;

    /** The bytes of the text before the buffer, and before the line. */
    private long before;

    private long lineStart;
    private long line;

    /**
     * Reads a stream, which stays its owner's.
     *
     * @param line the number of its first line
     */
    public TextInput(MeshSource source, InputStream in, long line) throws IOException {
        this.source = source;
        this.in = in;
        this.line = line;
        fill();
        if (line == 1 && end >= 2 && (isMark(0xfe, 0xff) || isMark(0xff, 0xfe))) {
            throw source.failure("is text of UTF-16, by the mark at its start; UTF-8 is expected");
        }
        boolean hasMark = line == 1 && end >= 3 && buffer[0] == -17 && buffer[1] == -69 && buffer[2] == -65;
        at = hasMark ? 3 : 0; // the mark of UTF-8
    }

    private boolean isMark(int first, int second) {
        return buffer[0] == (byte) first && buffer[1] == (byte) second;
    }

    /** A failure whose message names the text and the line. */
    public IOException failure(String what) {
        return source.failure("line " + line + ": " + what);
    }

    /** A failure at another line. */
    public IOException failureAt(long otherLine, String what) {
        return source.failure("line " + otherLine + ": " + what);
    }

    public long line() {
        return line;
    }

    /** The bytes that were read so far. */
    public long passed() {
        return before + at;
    }

    private void fill() throws IOException {
        checkLine();
        System.arraycopy(buffer, at, buffer, 0, end - at);
        end -= at;
        before += at;
        at = 0;
        while (end < PIECE && !hasEnded) {
            int read = in.read(buffer, end, PIECE - end);
            hasEnded = read < 0;
            end += Math.max(read, 0);
        }
        buffer[end] = 0;
    }

    private void ahead() throws IOException {
        if (end - at < AHEAD && !hasEnded) {
            fill();
        }
    }

    private void checkLine() throws IOException {
        if (before + at - lineStart > LONGEST_LINE) {
            throw failure("is longer than 1 MiB");
        }
    }

    /** Whether the text ends here. */
    public boolean atEnd() {
        return at == end && hasEnded;
    }

    /** Whether the line or the text ends here. */
    public boolean atLineEnd() {
        byte c = buffer[at];
        return c == '\n' || c == '\r' || atEnd();
    }

    /** The byte here; 0 at the end. */
    public int here() {
        return buffer[at];
    }

    /** Passes over one byte of a word. */
    public void step() {
        at++;
    }

    /** Passes over blanks within the line, and over line ends behind a backslash. */
    public void blanks() throws IOException {
        while (true) {
            byte c = buffer[at];
            if (c == ' ' || c == '\t') {
                at++;
            } else if (c == '\\' && end - at < 3 && !hasEnded) {
                fill();
            } else if (c == '\\' && (buffer[at + 1] == '\n' || buffer[at + 1] == '\r')) {
                at += buffer[at + 1] == '\r' && buffer[at + 2] == '\n' ? 3 : 2;
                line++;
            } else if (at == end && !hasEnded) {
                fill();
            } else {
                ahead();
                return;
            }
        }
    }

    /** Passes over blanks and line ends. */
    public void space() throws IOException {
        blanks();
        while (atLineEnd() && !atEnd()) {
            nextLine();
            blanks();
        }
    }

    /** Passes over what is left of the line. */
    public void nextLine() throws IOException {
        while (buffer[at] != '\n' && buffer[at] != '\r') {
            if (at < end) {
                at++;
            } else if (hasEnded) {
                checkLine();
                return;
            } else {
                fill();
            }
        }
        checkLine();
        ahead();
        at += buffer[at] == '\r' && buffer[at + 1] == '\n' ? 2 : 1;
        line++;
        lineStart = before + at;
        ahead();
    }

    /** A keyword of one or two letters, as a number of 16 bits, passed over; 0 and nothing is passed over if the word is longer. */
    public int shortWord() {
        if (isWordEnd(buffer[at])) {
            return 0;
        }
        int length = isWordEnd(buffer[at + 1]) ? 1 : isWordEnd(buffer[at + 2]) ? 2 : 0;
        int word = length == 1 ? buffer[at] : length == 2 ? buffer[at] << 8 | buffer[at + 1] & 0xff : 0;
        at += length;
        return word;
    }

    /** Blanks, line ends and the 0 behind the last byte. */
    private static boolean isWordEnd(byte c) {
        return c >= 0 && c <= ' ';
    }

    /** A word, empty at the end of the line. */
    public String word() throws IOException {
        int start = at;
        while (!isWordEnd(buffer[at])) {
            at++;
        }
        return name(start, at);
    }

    /** The line from here on without the blanks at its end; the line end is not passed over. */
    public String rest() throws IOException {
        int start = at;
        while (buffer[at] != '\n' && buffer[at] != '\r' && at < end) {
            at++;
        }
        int stop = at;
        while (stop > start && isWordEnd(buffer[stop - 1])) {
            stop--;
        }
        return name(start, stop);
    }

    private String name(int from, int to) throws IOException {
        if (to - from > LONGEST_NAME) {
            throw failure("has a name of more than " + LONGEST_NAME + " bytes");
        }
        return new String(buffer, from, to - from, StandardCharsets.UTF_8);
    }

    /** An integer of at most 18 digits; what follows it is not looked at. */
    public long integer() throws IOException {
        boolean isNegative = buffer[at] == '-';
        int i = isNegative || buffer[at] == '+' ? at + 1 : at;
        int start = i;
        long n = 0;
        for (; isDigit(buffer[i]) && i - start < 19; i++) {
            n = 10 * n + buffer[i] - '0';
        }
        if (i == start || i - start > 18) {
            throw failure("has " + found() + " where an integer is expected");
        }
        at = i;
        return isNegative ? -n : n;
    }

    /** Checks that a word ends here, as it must behind an integer. */
    public void endWord() throws IOException {
        if (!isWordEnd(buffer[at]) && buffer[at] != '\\') {
            throw failure("has " + found() + " directly behind a number");
        }
    }

    /** A number, rounded correctly to a double. */
    public double number() throws IOException {
        int start = at;
        boolean isNegative = buffer[at] == '-';
        int i = isNegative || buffer[at] == '+' ? at + 1 : at;
        long mantissa = 0;
        boolean isExact = true;
        int digits = 0;
        int point = -1;
        for (byte c = buffer[i]; isDigit(c) || c == '.' && point < 0; c = buffer[++i]) {
            if (c == '.') {
                point = digits;
            } else {
                digits++;
                isExact &= mantissa < MOST;
                mantissa = isExact ? 10 * mantissa + c - '0' : mantissa;
            }
        }
        int exponent = point < 0 ? 0 : point - digits;
        int stop = digits > 0 ? i : -1;
        if (stop >= 0 && (buffer[i] == 'e' || buffer[i] == 'E')) {
            stop = exponentEnd(i + 1);
            exponent += stop < 0 ? 0 : exponent(i + 1, stop);
        }
        if (stop < 0 || stop - start > LONGEST_NUMBER || !isWordEnd(buffer[stop]) && buffer[stop] != '\\') {
            throw notANumber(stop - start);
        }
        at = stop;
        boolean isShort = isExact && mantissa <= LARGEST_EXACT && exponent >= -22 && exponent <= 22;
        return isShort ? value(isNegative, mantissa, exponent) : parsed(start);
    }

    private static double value(boolean isNegative, long mantissa, int exponent) {
        double value = exponent < 0 ? mantissa / POWERS[-exponent] : mantissa * POWERS[exponent];
        return isNegative ? -value : value;
    }

    private static boolean isDigit(byte c) {
        return c >= '0' && c <= '9';
    }

    /** Where the digits of an exponent end; -1 if there are none. */
    private int exponentEnd(int from) {
        int i = buffer[from] == '-' || buffer[from] == '+' ? from + 1 : from;
        int start = i;
        while (isDigit(buffer[i])) {
            i++;
        }
        return i == start ? -1 : i;
    }

    /** An exponent, clamped where the double is 0 or infinite anyway. */
    private int exponent(int from, int to) {
        int n = 0;
        for (int i = isDigit(buffer[from]) ? from : from + 1; i < to; i++) {
            n = Math.min(100_000, 10 * n + buffer[i] - '0');
        }
        return buffer[from] == '-' ? -n : n;
    }

    private double parsed(int start) throws IOException {
        double value = Double.parseDouble(new String(buffer, start, at - start, StandardCharsets.ISO_8859_1));
        if (Double.isInfinite(value)) {
            at = start;
            throw failure("has the number " + found() + ", which is beyond the range of doubles");
        }
        return value;
    }

    /** A number, rounded correctly to a float: once, not to a double before. */
    public float floatNumber() throws IOException {
        int start = at;
        double exact = number();
        // Rounding twice differs only where the double lies halfway between floats, which subnormal floats do
        // elsewhere.
        boolean isDoubtful = (Double.doubleToRawLongBits(exact) & 0x1fffffff) == 0x10000000
                || exact != 0 && Math.abs(exact) < Float.MIN_NORMAL;
        float value = isDoubtful
                ? Float.parseFloat(new String(buffer, start, at - start, StandardCharsets.ISO_8859_1))
                : (float) exact;
        if (Float.isInfinite(value)) {
            at = start;
            throw failure("has the number " + found() + ", which is beyond the range of floats");
        }
        return value;
    }

    private IOException notANumber(int length) {
        return length > LONGEST_NUMBER
                ? failure("has a number of more than " + LONGEST_NUMBER + " characters")
                : failure("has " + found() + " where a number is expected");
    }

    /** The word here, for messages. */
    public String found() {
        if (atEnd()) {
            return "the end of the text";
        }
        if (atLineEnd()) {
            return "the end of the line";
        }
        int stop = at;
        while (stop < end && stop - at < 100 && !isWordEnd(buffer[stop])) {
            stop++;
        }
        return Plain.quoted(new String(buffer, at, Math.max(1, stop - at), StandardCharsets.UTF_8));
    }
}
