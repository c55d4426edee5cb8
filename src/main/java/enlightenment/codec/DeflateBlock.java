package enlightenment.codec;

import java.io.IOException;
import java.util.Arrays;

/**
 * Literals and matches on their way into one DEFLATE block (RFC 1951). Collects them, then writes them in whichever of
 * the three forms is shortest: stored, with the fixed code, or with a code made for them.
 */
final class DeflateBlock {
    static final int CAPACITY = 1 << 14;
    private static final int END_OF_BLOCK = 256;
    private static final int FIRST_LENGTH = 257;
    private static final int LAST_LENGTH = 285;
    private static final int MAXIMUM_STORED = 65535;
    /** The order in which the lengths of the code for code lengths are sent (RFC 1951, 3.2.7). */
    private static final int[] CODE_LENGTH_ORDER = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

    /** A literal 0..255, or a match as distance · 512 + length. */
    private final int[] tokens = new int[CAPACITY];

    private final int[] literalCounts = new int[286];
    private final int[] distanceCounts = new int[30];
    private int tokenCount;
    private int rawLength;

    boolean isFull() {
        return tokenCount == CAPACITY;
    }

    /** The number of bytes that the collected tokens stand for. */
    int rawLength() {
        return rawLength;
    }

    void literal(int value) {
        tokens[tokenCount++] = value;
        literalCounts[value]++;
        rawLength++;
    }

    /** Length 3..258, distance 1..32768. */
    void match(int length, int distance) {
        tokens[tokenCount++] = distance << 9 | length;
        literalCounts[lengthSymbol(length)]++;
        distanceCounts[distanceSymbol(distance)]++;
        rawLength += length;
    }

    /**
     * Writes everything that was collected and starts anew.
     *
     * @param raw what the tokens stand for, from index {@code from} on
     * @param last whether no block follows
     */
    void write(BitWriter out, byte[] raw, int from, boolean last) throws IOException {
        literalCounts[END_OF_BLOCK]++;
        HuffmanCode literals = HuffmanCode.ofCounts(literalCounts, 15);
        HuffmanCode distances = HuffmanCode.ofCounts(distanceCounts, 15);
        CodeLengths header = new CodeLengths(literals, distances);
        long extra = extraBits();
        long own = header.bits + cost(literals, distances) + extra;
        long fixed = cost(Fixed.LITERALS, Fixed.DISTANCES) + extra;
        long stored = 8L * rawLength + 40L * Math.max(1, (rawLength + MAXIMUM_STORED - 1) / MAXIMUM_STORED);
        if (stored < Math.min(own, fixed)) {
            writeStored(out, raw, from, last);
        } else {
            out.write(last ? 1 : 0, 1);
            if (own < fixed) {
                out.write(2, 2);
                header.write(out);
                writeTokens(out, literals, distances);
            } else {
                out.write(1, 2);
                writeTokens(out, Fixed.LITERALS, Fixed.DISTANCES);
            }
        }
        clear();
    }

    private void clear() {
        Arrays.fill(literalCounts, 0);
        Arrays.fill(distanceCounts, 0);
        tokenCount = 0;
        rawLength = 0;
    }

    private long cost(HuffmanCode literals, HuffmanCode distances) {
        long bits = 0;
        for (int symbol = 0; symbol < literalCounts.length; symbol++) {
            bits += (long) literalCounts[symbol] * literals.lengths[symbol];
        }
        for (int symbol = 0; symbol < distanceCounts.length; symbol++) {
            bits += (long) distanceCounts[symbol] * distances.lengths[symbol];
        }
        return bits;
    }

    private long extraBits() {
        long bits = 0;
        for (int symbol = FIRST_LENGTH; symbol < LAST_LENGTH; symbol++) {
            bits += (long) literalCounts[symbol] * lengthExtraBits(symbol);
        }
        for (int symbol = 0; symbol < distanceCounts.length; symbol++) {
            bits += (long) distanceCounts[symbol] * distanceExtraBits(symbol);
        }
        return bits;
    }

    private void writeStored(BitWriter out, byte[] raw, int from, boolean last) throws IOException {
        int done = 0;
        do {
            int length = Math.min(MAXIMUM_STORED, rawLength - done);
            out.write(last && done + length == rawLength ? 1 : 0, 3);
            out.alignToByte();
            out.write(length, 16);
            out.write(~length & 0xffff, 16);
            out.writeBytes(raw, from + done, length);
            done += length;
        } while (done < rawLength);
    }

    private void writeTokens(BitWriter out, HuffmanCode literals, HuffmanCode distances) throws IOException {
        for (int i = 0; i < tokenCount; i++) {
            int token = tokens[i];
            int distance = token >>> 9;
            if (distance == 0) {
                out.write(literals.words[token], literals.lengths[token]);
            } else {
                int length = token & 511;
                int symbol = lengthSymbol(length);
                out.write(literals.words[symbol], literals.lengths[symbol]);
                int extra = lengthExtraBits(symbol);
                out.write(length - 3 & (1 << extra) - 1, extra);
                symbol = distanceSymbol(distance);
                out.write(distances.words[symbol], distances.lengths[symbol]);
                extra = distanceExtraBits(symbol);
                out.write(distance - 1 & (1 << extra) - 1, extra);
            }
        }
        out.write(literals.words[END_OF_BLOCK], literals.lengths[END_OF_BLOCK]);
    }

    // The tables of RFC 1951, 3.2.5, as formulas: symbols come in groups of four (lengths) or two (distances) that
    // share
    // the number of extra bits; the extra bits are the low bits of length - 3 and of distance - 1.

    private static int lengthSymbol(int length) {
        int offset = length - 3;
        if (offset < 8) {
            return FIRST_LENGTH + offset;
        }
        if (length == 258) {
            return LAST_LENGTH;
        }
        int highest = 31 - Integer.numberOfLeadingZeros(offset);
        return FIRST_LENGTH + 4 * (highest - 1) + (offset >>> highest - 2 & 3);
    }

    private static int lengthExtraBits(int symbol) {
        return symbol < FIRST_LENGTH + 8 || symbol == LAST_LENGTH ? 0 : (symbol - FIRST_LENGTH >>> 2) - 1;
    }

    private static int distanceSymbol(int distance) {
        int offset = distance - 1;
        if (offset < 4) {
            return offset;
        }
        int highest = 31 - Integer.numberOfLeadingZeros(offset);
        return 2 * highest + (offset >>> highest - 1 & 1);
    }

    private static int distanceExtraBits(int symbol) {
        return symbol < 4 ? 0 : (symbol >>> 1) - 1;
    }

    /** The code that both sides know (RFC 1951, 3.2.6). */
    private static final class Fixed {
        static final HuffmanCode LITERALS = literals();
        static final HuffmanCode DISTANCES = distances();

        private static HuffmanCode literals() {
            int[] lengths = new int[288];
            for (int symbol = 0; symbol < lengths.length; symbol++) {
                lengths[symbol] = symbol < 144 ? 8 : symbol < 256 ? 9 : symbol < 280 ? 7 : 8;
            }
            return HuffmanCode.ofLengths(lengths);
        }

        private static HuffmanCode distances() {
            int[] lengths = new int[32];
            Arrays.fill(lengths, 5);
            return HuffmanCode.ofLengths(lengths);
        }
    }

    /** The head of a block with its own code: the lengths of all code words, run-length coded, then Huffman coded. */
    private static final class CodeLengths {
        private final int[] symbols = new int[286 + 30];
        private final int[] repeats = new int[286 + 30];
        private final int literalCount;
        private final int distanceCount;
        private final int orderCount;
        private final HuffmanCode code;
        private int count;
        /** The size of this head. */
        final long bits;

        CodeLengths(HuffmanCode literals, HuffmanCode distances) {
            literalCount = Math.max(FIRST_LENGTH, used(literals.lengths));
            distanceCount = Math.max(1, used(distances.lengths));
            int[] all = new int[literalCount + distanceCount];
            System.arraycopy(literals.lengths, 0, all, 0, literalCount);
            System.arraycopy(distances.lengths, 0, all, literalCount, distanceCount);
            collectRuns(all);
            int[] counts = new int[19];
            for (int i = 0; i < count; i++) {
                counts[symbols[i]]++;
            }
            code = HuffmanCode.ofCounts(counts, 7);
            int order = CODE_LENGTH_ORDER.length;
            while (code.lengths[CODE_LENGTH_ORDER[order - 1]] == 0) {
                order--;
            }
            orderCount = Math.max(4, order);
            long sum = 5 + 5 + 4 + 3L * orderCount;
            for (int symbol = 0; symbol < counts.length; symbol++) {
                sum += (long) counts[symbol] * (code.lengths[symbol] + repeatBits(symbol));
            }
            bits = sum;
        }

        private static int used(int[] lengths) {
            int used = lengths.length;
            while (used > 0 && lengths[used - 1] == 0) {
                used--;
            }
            return used;
        }

        private void collectRuns(int[] all) {
            int end;
            for (int i = 0; i < all.length; i = end) {
                end = i + 1;
                while (end < all.length && all[end] == all[i]) {
                    end++;
                }
                int left = end - i;
                if (all[i] == 0) {
                    for (; left >= 3; left -= Math.min(left, 138)) {
                        int run = Math.min(left, 138);
                        add(run < 11 ? 17 : 18, run < 11 ? run - 3 : run - 11);
                    }
                } else {
                    add(all[i], 0);
                    left--;
                    for (; left >= 3; left -= Math.min(left, 6)) {
                        add(16, Math.min(left, 6) - 3);
                    }
                }
                for (; left > 0; left--) {
                    add(all[i], 0);
                }
            }
        }

        private void add(int symbol, int repeat) {
            symbols[count] = symbol;
            repeats[count++] = repeat;
        }

        private static int repeatBits(int symbol) {
            return symbol < 16 ? 0 : symbol == 16 ? 2 : symbol == 17 ? 3 : 7;
        }

        void write(BitWriter out) throws IOException {
            out.write(literalCount - FIRST_LENGTH, 5);
            out.write(distanceCount - 1, 5);
            out.write(orderCount - 4, 4);
            for (int i = 0; i < orderCount; i++) {
                out.write(code.lengths[CODE_LENGTH_ORDER[i]], 3);
            }
            for (int i = 0; i < count; i++) {
                out.write(code.words[symbols[i]], code.lengths[symbols[i]]);
                out.write(repeats[i], repeatBits(symbols[i]));
            }
        }
    }
}
