package enlightenment.codec;

/** What makes halves and floats shorter before RLE and ZIP: bytes of even places before those of odd ones, then differences. */
final class ExrPrediction {
    /** Added to differences, so that small ones lie in the middle of the range. */
    private static final int MIDDLE = 128;

    private ExrPrediction() {}

    /** Sorts the first bytes of an array by place and makes differences of them. */
    static void apply(byte[] plain, int size, byte[] coded) {
        int half = (size + 1) / 2;
        for (int i = 0; i < size; i++) {
            coded[(i & 1) == 0 ? i / 2 : half + i / 2] = plain[i];
        }
        for (int i = size - 1; i > 0; i--) {
            coded[i] = (byte) (coded[i] - coded[i - 1] + MIDDLE);
        }
    }

    /** Undoes {@link #apply}; the coded bytes are overwritten. */
    static void undo(byte[] coded, byte[] plain) {
        int n = coded.length;
        for (int i = 1; i < n; i++) {
            coded[i] = (byte) (coded[i - 1] + coded[i] - MIDDLE);
        }
        int half = (n + 1) / 2;
        for (int i = 0; i < n; i++) {
            plain[i] = coded[(i & 1) == 0 ? i / 2 : half + i / 2];
        }
    }
}
