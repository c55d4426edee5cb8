package enlightenment.net;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The secret that server and workers share. */
final class Token {
    /** Stands for no token: both sides of a loopback connection know it, so it proves nothing. */
    static final byte[] NONE = "enlightenment without token".getBytes(StandardCharsets.US_ASCII);

    private static final int LONGEST = 4_096;

    private Token() {}

    /** The token in a file, without white space at its ends; fails if it is too short to be one. */
    static byte[] read(Path file) throws IOException {
        if (Files.size(file) > LONGEST) {
            throw new IOException(file + ": is longer than any token");
        }
        byte[] token =
                Files.readString(file, StandardCharsets.ISO_8859_1).strip().getBytes(StandardCharsets.ISO_8859_1);
        if (token.length < Handshake.SHORTEST_TOKEN) {
            throw new IOException(file + ": a token has at least " + Handshake.SHORTEST_TOKEN + " characters, not "
                    + token.length + " (openssl rand -hex 16 makes one)");
        }
        return token;
    }
}
