package enlightenment.codec;

import java.io.IOException;
import java.io.OutputStream;
import java.util.zip.Adler32;

/**
 * Compresses a stream of bytes to the zlib format (RFC 1950) with DEFLATE (RFC 1951).
 *
 * <p>The JDK's {@link java.util.zip.Deflater} is whatever zlib the machine has, and zlibs differ in what they make of the
 * same bytes. This one gives the same result everywhere: see docs/decisions/0002-own-deflate.md.
 *
 * <p>How: all places where six bytes (two pixels) occurred within the last 32 KiB hang in a chain, found through a hash of
 * these bytes. The longest match of the first {@value #CHAIN} places is taken, unless the next byte starts a longer one
 * (lazy matching, RFC 1951, section 4). Matches shorter than six bytes are not used, although the format has them: what
 * filters leave of a rendered picture is small numbers, which the Huffman code packs better by themselves than such
 * matches would, and the chains become short. This makes the encoder faster than zlib and its files smaller.
 *
 * <p>Input is worked off in pieces of 1 MiB: matches reach back over a piece's start, but not across its end, which costs
 * next to nothing and spares all bookkeeping about bytes yet to come.
 */
final class ZlibEncoder {
    private static final int HISTORY = 1 << 15;
    private static final int PIECE = 1 << 20;
    private static final int HASH_BITS = 15;
    private static final int MINIMUM_MATCH = 6;
    private static final int MAXIMUM_MATCH = 258;
    /** A match this long is taken without a look at the next byte. */
    private static final int LONG_ENOUGH = 16;
    /** With a match this long in hand, a better one is searched for less thoroughly. */
    private static final int GOOD = 8;
    /** A match this long ends the search. */
    private static final int NICE = 128;
    /** The number of places that are looked at. */
    private static final int CHAIN = 32;

    private final BitWriter out;
    private final Adler32 checksum = new Adler32();
    private final DeflateBlock block = new DeflateBlock();
    /** 32 KiB of what went before, then the piece. */
    private final byte[] buffer;
    /** Per hash: the index in the buffer where it occurred last; 0 for never. */
    private final int[] last = new int[1 << HASH_BITS];
    /** Per index in the buffer, modulo 32 KiB: where its hash had occurred before. */
    private final int[] before = new int[HISTORY];

    private int end = HISTORY;
    /** Matches start above this index: there is nothing before the first piece. */
    private int lowest = HISTORY - 1;

    /** The bytes of the buffer up to the last one that was hashed, the latest lowest. */
    private long recent;

    private int blockStart = HISTORY;
    private int matchDistance;

    ZlibEncoder(OutputStream out) throws IOException {
        this(out, PIECE);
    }

    /** @param most how many bytes there will be, at least 1: where they are few, buffers are small */
    ZlibEncoder(OutputStream out, int most) throws IOException {
        int pieces = Math.min(most, PIECE) + HISTORY - 1 & -HISTORY;
        buffer = new byte[HISTORY + pieces];
        this.out = new BitWriter(out);
        this.out.write(0x78, 8); // DEFLATE with a window of 32 KiB
        this.out.write(0x9c, 8); // default effort, no dictionary
    }

    void write(byte[] bytes, int from, int length) throws IOException {
        checksum.update(bytes, from, length);
        int done = 0;
        while (done < length) {
            if (end == buffer.length) {
                compress();
                finishBlock(false);
                slide();
            }
            int count = Math.min(length - done, buffer.length - end);
            System.arraycopy(bytes, from + done, buffer, end, count);
            end += count;
            done += count;
        }
    }

    /** Writes what is left and the checksum; the stream itself stays open. */
    void finish() throws IOException {
        compress();
        finishBlock(true);
        out.alignToByte();
        out.writeBigEndian((int) checksum.getValue());
        out.flush();
    }

    private void compress() throws IOException {
        int heldLength = 0;
        int heldDistance = 0;
        boolean held = false;
        for (int i = HISTORY; i < HISTORY + MINIMUM_MATCH - 1; i++) {
            recent = recent << 8 | buffer[i] & 255;
        }
        int position = HISTORY;
        while (position < end) {
            int length = 0;
            if (end - position >= MINIMUM_MATCH) {
                int candidate = remember(position);
                if (heldLength < LONG_ENOUGH && heldLength < end - position) {
                    length = longestMatch(position, candidate, heldLength);
                }
            }
            if (heldLength > 0 && length <= heldLength) {
                block.match(heldLength, heldDistance);
                int next = position - 1 + heldLength;
                int lastHashed = Math.min(next, end - MINIMUM_MATCH + 1);
                for (int i = position + 1; i < lastHashed; i++) {
                    remember(i);
                }
                position = next;
                held = false;
                heldLength = 0;
            } else {
                if (held) {
                    block.literal(buffer[position - 1] & 255);
                }
                held = true;
                heldLength = length;
                heldDistance = matchDistance;
                position++;
            }
            if (block.isFull()) {
                finishBlock(false);
            }
        }
        if (held) {
            block.literal(buffer[end - 1] & 255);
        }
    }

    /** Files an index under its six bytes and returns the previous one there. Called for one index after the other. */
    private int remember(int index) {
        recent = recent << 8 | buffer[index + MINIMUM_MATCH - 1] & 255;
        // Fibonacci hashing: 2^64 divided by the golden ratio; the shift drops all but the last six bytes.
        int hash = (int) ((recent << 64 - 8 * MINIMUM_MATCH) * 0x9e3779b97f4a7c15L >>> 64 - HASH_BITS);
        int previous = last[hash];
        before[index & HISTORY - 1] = previous;
        last[hash] = index;
        return previous;
    }

    /** The length of the longest match that is longer than {@code floor}, or 0; sets {@link #matchDistance}. */
    private int longestMatch(int position, int first, int floor) {
        final byte[] bytes = buffer;
        final int limit = Math.min(MAXIMUM_MATCH, end - position);
        final int enough = Math.min(NICE, limit);
        final int earliest = Math.max(lowest, position - HISTORY);
        int best = Math.max(floor, MINIMUM_MATCH - 1);
        int found = 0;
        int chain = floor >= GOOD ? CHAIN / 4 : CHAIN;
        for (int candidate = first; candidate > earliest && chain > 0 && best < limit; chain--) {
            if (bytes[candidate + best] == bytes[position + best] && bytes[candidate] == bytes[position]) {
                int length = 1;
                while (length < limit && bytes[candidate + length] == bytes[position + length]) {
                    length++;
                }
                if (length > best) {
                    best = length;
                    found = position - candidate;
                    if (length >= enough) {
                        break;
                    }
                }
            }
            candidate = before[candidate & HISTORY - 1];
        }
        matchDistance = found;
        return found == 0 ? 0 : best;
    }

    private void finishBlock(boolean isLast) throws IOException {
        int length = block.rawLength();
        block.write(out, buffer, blockStart, isLast);
        blockStart += length;
    }

    /** Makes the end of this piece the history of the next one. */
    private void slide() {
        int shift = end - HISTORY; // a multiple of HISTORY, so that indices keep their places in the ring
        System.arraycopy(buffer, shift, buffer, 0, HISTORY);
        shiftDown(last, shift);
        shiftDown(before, shift);
        end = HISTORY;
        blockStart = HISTORY;
        lowest = 0;
    }

    private static void shiftDown(int[] indices, int shift) {
        for (int i = 0; i < indices.length; i++) {
            indices[i] = Math.max(0, indices[i] - shift);
        }
    }
}
