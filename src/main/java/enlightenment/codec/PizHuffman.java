package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * The Huffman code of PIZ: symbols are the 16-bit numbers and one more, the highest, which repeats what went before it. A head of 20
 * bytes, then the lengths of the code words, packed, then the words; the highest bit of a byte is the first.
 */
final class PizHuffman {
    private static final int HEAD = 20;
    private static final int HIGHEST_SYMBOL = 1 << 16;
    private static final int LONGEST_WORD = 58;

    /** Lengths from here on stand for runs of symbols that have no word: of 2, 3, 4, 5. */
    private static final int SHORT_RUN = 59;

    /** A run whose length follows in 8 bits, less 6. */
    private static final int LONG_RUN = 63;

    private static final int LEAST_SHORT_RUN = 2;
    private static final int LEAST_LONG_RUN = 6;

    /** Words up to this long are looked up in a table. */
    private static final int TABLE_BITS = 12;

    private final byte[] coded;

    /** In bits. */
    private long position;

    /** Where the words end, in bits. */
    private long end;

    /** Number of words, and the first word, of each length. */
    private final int[] count = new int[LONGEST_WORD + 1];

    private final long[] first = new long[LONGEST_WORD + 1];

    /** The symbols in the order of the lengths of their words, then of their values; and where those of a length begin. */
    private int[] symbols;

    private final int[] symbolsFrom = new int[LONGEST_WORD + 2];

    /** Per {@link #TABLE_BITS} bits: the symbol whose word they begin with, times 64, plus the length; 0 if there is none. */
    private final int[] table = new int[1 << TABLE_BITS];

    private PizHuffman(byte[] coded) {
        this.coded = coded;
    }

    /**
     * Decodes a whole array of numbers.
     *
     * @throws IOException unless the bytes stand for exactly as many
     */
    static void decode(byte[] coded, char[] into) throws IOException {
        if (coded.length < HEAD) {
            throw new IOException("its Huffman code ends in its head");
        }
        new PizHuffman(coded).decode(into);
    }

    private void decode(char[] into) throws IOException {
        ByteBuffer head = ByteBuffer.wrap(coded).order(ByteOrder.LITTLE_ENDIAN);
        int lowest = head.getInt(0);
        int highest = head.getInt(4);
        long bits = head.getInt(12) & 0xffffffffL;
        if (lowest < 0 || highest < lowest || highest > HIGHEST_SYMBOL) {
            throw new IOException("the symbols of its Huffman code are said to be " + lowest + ".." + highest);
        }
        position = 8L * HEAD;
        end = 8L * coded.length;
        readLengths(lowest, highest);
        position = position + 7 & ~7L;
        if (bits > end - position) {
            throw new IOException("its Huffman code ends after " + (end - position) + " of " + bits + " bits");
        }
        end = position + bits;
        fillTable();
        decode(highest, into);
    }

    private void decode(int repeat, char[] into) throws IOException {
        int done = 0;
        while (position < end) {
            int symbol = nextSymbol();
            if (symbol != repeat) {
                if (done == into.length) {
                    throw new IOException("it holds more than " + into.length + " numbers");
                }
                into[done++] = (char) symbol;
            } else {
                int times = take(8);
                if (done == 0 || times > into.length - done) {
                    throw new IOException("a run of " + times + " numbers is too long");
                }
                Arrays.fill(into, done, done + times, into[done - 1]);
                done += times;
            }
        }
        if (done < into.length) {
            throw new IOException("only " + done + " of " + into.length + " numbers are there");
        }
    }

    private int take(int bits) throws IOException {
        if (bits > end - position) {
            throw new IOException("its Huffman code ends too early");
        }
        int value = peek(bits);
        position += bits;
        return value;
    }

    /** The next bits, at most 16; zeros beyond the array. */
    private int peek(int bits) {
        int at = (int) (position >>> 3);
        int three = 0;
        for (int i = at; i < at + 3; i++) {
            three = three << 8 | (i < coded.length ? coded[i] & 255 : 0);
        }
        return three >>> 24 - bits - (int) (position & 7) & (1 << bits) - 1;
    }

    /** Reads the lengths of words and sorts the symbols by them. */
    private void readLengths(int lowest, int highest) throws IOException {
        byte[] lengths = new byte[highest + 1];
        int next = lowest;
        while (next <= highest) {
            int length = take(6);
            if (length < SHORT_RUN) {
                lengths[next++] = (byte) length;
                count[length]++;
            } else {
                int run = length == LONG_RUN ? take(8) + LEAST_LONG_RUN : length - SHORT_RUN + LEAST_SHORT_RUN;
                if (run > highest + 1 - next) {
                    throw new IOException("the lengths of its Huffman code are too many");
                }
                next += run;
            }
        }
        for (int length = 1; length <= LONGEST_WORD; length++) {
            symbolsFrom[length + 1] = symbolsFrom[length] + count[length];
        }
        symbols = new int[symbolsFrom[LONGEST_WORD + 1]];
        int[] at = symbolsFrom.clone();
        for (int symbol = lowest; symbol <= highest; symbol++) {
            if (lengths[symbol] > 0) {
                symbols[at[lengths[symbol]]++] = symbol;
            }
        }
        numberWords();
    }

    /** The canonical code of these lengths: the longest words have the lowest numbers. */
    private void numberWords() throws IOException {
        long next = 0;
        for (int length = LONGEST_WORD; length > 0; length--) {
            first[length] = next;
            if (next + count[length] > 1L << length) {
                throw new IOException("the words of its Huffman code are too many");
            }
            next = next + count[length] + 1 >> 1;
        }
    }

    private void fillTable() {
        for (int length = 1; length <= TABLE_BITS; length++) {
            for (int i = 0; i < count[length]; i++) {
                int entry = symbols[symbolsFrom[length] + i] << 6 | length;
                int from = (int) (first[length] + i) << TABLE_BITS - length;
                Arrays.fill(table, from, from + (1 << TABLE_BITS - length), entry);
            }
        }
    }

    private int nextSymbol() throws IOException {
        int entry = table[peek(TABLE_BITS)];
        int known = entry & 63;
        if (known > 0 && known <= end - position) {
            position += known;
            return entry >>> 6;
        }
        long word = 0;
        for (int length = 1; length <= LONGEST_WORD; length++) {
            word = word << 1 | take(1);
            long index = word - first[length];
            if (index >= 0 && index < count[length]) {
                return symbols[symbolsFrom[length] + (int) index];
            }
        }
        throw new IOException("there is no such word in its Huffman code");
    }
}
