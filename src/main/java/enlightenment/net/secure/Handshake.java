package enlightenment.net.secure;

import enlightenment.file.ContentHash;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * Proofs that the other side knows the token, without sending it.
 *
 * <p>A proof is the HMAC-SHA-256 (RFC 2104) with the token as key over: a label that says who proves, the worker's nonce,
 * the server's nonce, and the hash of the server's certificate. The nonces make a recorded proof useless; the certificate's
 * hash makes a proof useless to someone in the middle who shows another certificate; the label keeps a proof from being
 * sent back to its author.
 */
public final class Handshake {
    /** Length of a nonce in bytes. */
    public static final int NONCE_BYTES = 32;

    /** Length of a proof in bytes. */
    public static final int PROOF_BYTES = 32;

    /** Shortest token in bytes that a server takes: 16 random bytes cannot be guessed from a recorded proof. */
    static final int SHORTEST_TOKEN = 16;

    private static final String ALGORITHM = "HmacSHA256";

    private Handshake() {}

    /** The side that makes a proof. */
    public enum Side {
        WORKER(1),
        SERVER(2);

        private final byte label;

        Side(int label) {
            this.label = (byte) label;
        }
    }

    /**
     * The proof of one side.
     *
     * @param token the shared secret, not empty
     * @param certificate hash of the server's certificate as this side saw it; all zeros where the connection has none
     * @throws IllegalArgumentException if a nonce has the wrong length or the token is empty
     */
    public static byte[] proof(
            Side side, byte[] token, byte[] workerNonce, byte[] serverNonce, ContentHash certificate) {
        checkNonce(workerNonce);
        checkNonce(serverNonce);
        byte[] text = new byte[1 + 2 * NONCE_BYTES + ContentHash.BYTES];
        text[0] = side.label;
        System.arraycopy(workerNonce, 0, text, 1, NONCE_BYTES);
        System.arraycopy(serverNonce, 0, text, 1 + NONCE_BYTES, NONCE_BYTES);
        System.arraycopy(certificate.toBytes(), 0, text, 1 + 2 * NONCE_BYTES, ContentHash.BYTES);
        return hmac(token, text);
    }

    /** Whether two proofs are the same, in a time that does not tell where they differ. */
    public static boolean same(byte[] expected, byte[] given) {
        return MessageDigest.isEqual(expected, given);
    }

    /** HMAC-SHA-256. */
    public static byte[] hmac(byte[] key, byte[] text) {
        if (key.length == 0) {
            throw new IllegalArgumentException("the token is empty");
        }
        try {
            Mac mac = Mac.getInstance(ALGORITHM);
            mac.init(new SecretKeySpec(key, ALGORITHM));
            return mac.doFinal(text);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java platform has " + ALGORITHM, e);
        }
    }

    private static void checkNonce(byte[] nonce) {
        if (nonce.length != NONCE_BYTES) {
            throw new IllegalArgumentException("a nonce has " + NONCE_BYTES + " bytes, not " + nonce.length);
        }
    }
}
