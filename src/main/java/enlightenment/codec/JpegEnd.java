package enlightenment.codec;

import java.io.IOException;

/**
 * Finds the end of a JPEG file (ITU-T T.81, annex B). A decoder shows what there is of a file that was cut: a progressive one is then whole
 * but blurred, and nothing warns.
 */
final class JpegEnd {
    private static final int MARKER = 0xff;
    private static final int START_OF_IMAGE = 0xd8;
    private static final int END_OF_IMAGE = 0xd9;
    private static final int START_OF_SCAN = 0xda;
    private static final int FIRST_RESTART = 0xd0;
    private static final int TEMPORARY = 0x01;
    private static final int MARKER_BYTES = 2;

    private JpegEnd() {}

    /** @throws IOException if the file ends before its end-of-image marker */
    static void require(byte[] file) throws IOException {
        int at = MARKER_BYTES;
        boolean isInScan = false;
        while (at + 1 < file.length) {
            if ((file[at] & MARKER) != MARKER) {
                // Only coded data lie between markers; what else does is for the decoder to refuse.
                at++;
                continue;
            }
            int code = file[at + 1] & MARKER;
            if (code == END_OF_IMAGE) {
                return;
            }
            if (isBare(code)) {
                at += code == MARKER ? 1 : MARKER_BYTES;
                continue;
            }
            isInScan = code == START_OF_SCAN;
            at += MARKER_BYTES + length(file, at + MARKER_BYTES);
        }
        throw new IOException(isInScan ? "it ends too early, in the middle of its pixels" : "it ends too early");
    }

    /** A marker without a segment: fill bytes, an escaped 0xff of coded data, restarts. */
    private static boolean isBare(int code) {
        return code == MARKER || code == 0 || code == TEMPORARY || code >= FIRST_RESTART && code <= START_OF_IMAGE;
    }

    private static int length(byte[] file, int at) {
        return at + 1 < file.length ? (file[at] & 0xff) << 8 | file[at + 1] & 0xff : file.length;
    }
}
