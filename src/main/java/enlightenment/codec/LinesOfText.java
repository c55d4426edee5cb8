package enlightenment.codec;

import java.io.IOException;
import java.nio.ByteBuffer;

/** The lines of text that a picture file begins with. */
final class LinesOfText {
    private static final int LONGEST = 4096;

    private final ByteBuffer file;
    private int number;

    LinesOfText(ByteBuffer file) {
        this.file = file;
    }

    /** The number of the line that was read last, counted from 1. */
    int number() {
        return number;
    }

    /**
     * The next line, without its end.
     *
     * @throws IOException if the file ends in it, or it is longer than 4,096 bytes
     */
    String next() throws IOException {
        number++;
        StringBuilder line = new StringBuilder();
        while (file.hasRemaining() && line.length() < LONGEST) {
            byte b = file.get();
            if (b == '\n') {
                return line.toString();
            }
            line.append((char) (b & 255));
        }
        throw new IOException(
                "line " + number + " of its head " + (file.hasRemaining() ? "is too long" : "does not end"));
    }
}
