package enlightenment.codec;

import java.util.Arrays;

/**
 * A prefix code in which no code word is longer than a limit: D. A. Huffman's construction (1952), then shortened where it
 * exceeds the limit, then numbered canonically as RFC 1951, 3.2.2, demands. Ties are broken by symbol, so that the same
 * counts give the same code everywhere.
 */
final class HuffmanCode {
    /** Bits per symbol; 0 for a symbol that does not occur. */
    final int[] lengths;
    /** Code word per symbol, bits in the order in which {@link BitWriter} sends them. */
    final int[] words;

    private HuffmanCode(int[] lengths) {
        this.lengths = lengths;
        this.words = canonicalWords(lengths);
    }

    static HuffmanCode ofLengths(int... lengths) {
        return new HuffmanCode(lengths);
    }

    /**
     * The best code for these counts, up to the shortening. At least two symbols get a word, so that every decoder sees a
     * complete code.
     */
    static HuffmanCode ofCounts(int[] counts, int limit) {
        // A sortable key per symbol that occurs: count first, then symbol. Symbols fit in 9 bits.
        long[] keys = new long[Math.max(2, counts.length)];
        int used = 0;
        for (int symbol = 0; symbol < counts.length; symbol++) {
            if (counts[symbol] > 0) {
                keys[used++] = ((long) counts[symbol] << 9) | symbol;
            }
        }
        for (int symbol = 0; used < 2; symbol++) {
            if (counts[symbol] == 0) {
                keys[used++] = (1L << 9) | symbol;
            }
        }
        Arrays.sort(keys, 0, used);
        int[] wordsOfLength = shorten(lengthHistogram(keys, used), limit);
        int[] lengths = new int[counts.length];
        int next = 0;
        for (int length = limit; length > 0; length--) {
            for (int i = 0; i < wordsOfLength[length]; i++) {
                lengths[(int) (keys[next++] & 511)] = length;
            }
        }
        return new HuffmanCode(lengths);
    }

    /** How many words of each length Huffman's tree has: leaves and inner nodes both come up in order of weight. */
    private static int[] lengthHistogram(long[] keys, int used) {
        long[] weight = new long[2 * used - 1];
        int[] parent = new int[2 * used - 1];
        for (int i = 0; i < used; i++) {
            weight[i] = keys[i] >>> 9;
        }
        int leaf = 0;
        int inner = used;
        for (int node = used; node < 2 * used - 1; node++) {
            for (int child = 0; child < 2; child++) {
                boolean takeLeaf = leaf < used && (inner == node || weight[leaf] <= weight[inner]);
                int taken = takeLeaf ? leaf++ : inner++;
                weight[node] += weight[taken];
                parent[taken] = node;
            }
        }
        int[] depth = parent;
        int[] histogram = new int[used + 1];
        depth[2 * used - 2] = 0;
        for (int node = 2 * used - 3; node >= 0; node--) {
            depth[node] = depth[parent[node]] + 1;
            if (node < used) {
                histogram[depth[node]]++;
            }
        }
        return histogram;
    }

    /**
     * Cuts words to the limit. That claims more than the whole code space; each step gives one unit of it back: a word
     * shorter than the limit grows by one bit and takes one word of full length as its neighbour.
     */
    private static int[] shorten(int[] histogram, int limit) {
        int[] result = Arrays.copyOf(histogram, Math.max(histogram.length, limit + 1));
        for (int length = limit + 1; length < result.length; length++) {
            result[limit] += result[length];
            result[length] = 0;
        }
        long claimed = 0;
        for (int length = 1; length <= limit; length++) {
            claimed += (long) result[length] << (limit - length);
        }
        for (; claimed > 1L << limit; claimed--) {
            int length = limit - 1;
            while (result[length] == 0) {
                length--;
            }
            result[length]--;
            result[length + 1] += 2;
            result[limit]--;
        }
        return result;
    }

    private static int[] canonicalWords(int[] lengths) {
        int[] next = new int[17];
        for (int length : lengths) {
            next[length + 1]++;
        }
        next[1] = 0;
        for (int length = 1; length < 16; length++) {
            next[length + 1] += next[length];
            next[length + 1] <<= 1;
        }
        int[] words = new int[lengths.length];
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            int length = lengths[symbol];
            if (length > 0) {
                words[symbol] = Integer.reverse(next[length]++) >>> (32 - length);
            }
        }
        return words;
    }
}
