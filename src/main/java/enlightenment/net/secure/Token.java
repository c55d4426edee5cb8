package enlightenment.net.secure;

import enlightenment.file.InputFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The secret that server and workers share. */
public final class Token {
    /** Stands for no token: both sides of a loopback connection know it, so it proves nothing. */
    public static final byte[] NONE = "enlightenment without token".getBytes(StandardCharsets.US_ASCII);

    private static final int LONGEST = 4_096;

    private Token() {}

    /** Writes a file with a new random token. */
    static void make(Path file) throws IOException {
        SecretFile.create(file, SecretFile.random() + "\n");
    }

    /** The token in a file, without white space at its ends; fails if it is too short to be one. */
    public static byte[] read(Path file) throws IOException {
        if (Files.notExists(file)) {
            throw new IOException(file + ": there is no such file; copy the server's token to it");
        }
        byte[] bytes = InputFile.start(file, LONGEST + 1);
        if (bytes.length > LONGEST) {
            throw new IOException(file + ": is longer than any token");
        }
        try {
            return of(new String(bytes, StandardCharsets.ISO_8859_1));
        } catch (IllegalArgumentException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }

    /**
     * The token in a text, without white space at its ends.
     *
     * @throws IllegalArgumentException if it is too short or too long to be one
     */
    public static byte[] of(String text) {
        byte[] token = text.strip().getBytes(StandardCharsets.ISO_8859_1);
        if (token.length < Handshake.SHORTEST_TOKEN) {
            throw new IllegalArgumentException(
                    "a token has at least " + Handshake.SHORTEST_TOKEN + " characters, not " + token.length);
        }
        if (token.length > LONGEST) {
            throw new IllegalArgumentException("is longer than any token");
        }
        return token;
    }
}
