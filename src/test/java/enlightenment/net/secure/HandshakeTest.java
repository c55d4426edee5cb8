package enlightenment.net.secure;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;

class HandshakeTest {
    private static final ContentHash CERTIFICATE = ContentHash.of("certificate".getBytes(US_ASCII));

    private static byte[] repeated(int value, int count) {
        byte[] bytes = new byte[count];
        Arrays.fill(bytes, (byte) value);
        return bytes;
    }

    private static void check(byte[] key, byte[] text, String expected) {
        String found = HexFormat.of().formatHex(Handshake.hmac(key, text));
        // Test case 5 of the RFC gives the first 128 bits only.
        assertEquals(expected, found.substring(0, expected.length()));
    }

    @Test
    void theHmacGivesTheVectorsOfRfc4231() {
        check(
                repeated(0x0b, 20),
                "Hi There".getBytes(US_ASCII),
                "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
        check(
                "Jefe".getBytes(US_ASCII),
                "what do ya want for nothing?".getBytes(US_ASCII),
                "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
        check(
                repeated(0xaa, 20),
                repeated(0xdd, 50),
                "773ea91e36800e46854db8ebd09181a72959098b3ef8c122d9635514ced565fe");
        byte[] counting = new byte[25];
        for (int i = 0; i < counting.length; i++) {
            counting[i] = (byte) (i + 1);
        }
        check(counting, repeated(0xcd, 50), "82558a389a443c0ea4cc819899f2083a85f0faa3e578f8077a2e3ff46729665b");
        check(repeated(0x0c, 20), "Test With Truncation".getBytes(US_ASCII), "a3b6167473100ee06e0c796c2955552b");
        check(
                repeated(0xaa, 131),
                "Test Using Larger Than Block-Size Key - Hash Key First".getBytes(US_ASCII),
                "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
        check(
                repeated(0xaa, 131),
                ("This is a test using a larger than block-size key and a larger than block-size data. The key needs to be"
                                + " hashed before being used by the HMAC algorithm.")
                        .getBytes(US_ASCII),
                "9b09ffa71b942fcb27635fbcd5b0e944bfdc63644f0713938a7f51535c3a35e2");
    }

    @Test
    void aProofIsTheHmacOfLabelNoncesAndCertificate() {
        byte[] text = new byte[97];
        text[0] = 1;
        Arrays.fill(text, 1, 33, (byte) 7);
        Arrays.fill(text, 33, 65, (byte) 9);
        System.arraycopy(CERTIFICATE.toBytes(), 0, text, 65, 32);
        byte[] token = repeated(3, 16);
        assertArrayEquals(
                Handshake.hmac(token, text),
                Handshake.proof(Handshake.Side.WORKER, token, repeated(7, 32), repeated(9, 32), CERTIFICATE));
    }

    @Test
    void anythingThatDiffersMakesAnotherProof() {
        byte[] token = repeated(3, 16);
        byte[] mine = repeated(7, 32);
        byte[] yours = repeated(9, 32);
        byte[] proof = Handshake.proof(Handshake.Side.WORKER, token, mine, yours, CERTIFICATE);
        List<byte[]> others = List.of(
                Handshake.proof(Handshake.Side.SERVER, token, mine, yours, CERTIFICATE),
                Handshake.proof(Handshake.Side.WORKER, repeated(4, 16), mine, yours, CERTIFICATE),
                Handshake.proof(Handshake.Side.WORKER, token, yours, mine, CERTIFICATE),
                Handshake.proof(Handshake.Side.WORKER, token, mine, repeated(8, 32), CERTIFICATE),
                Handshake.proof(Handshake.Side.WORKER, token, mine, yours, new ContentHash(0, 0, 0, 0)));
        for (byte[] other : others) {
            assertFalse(Handshake.same(proof, other));
        }
        assertTrue(Handshake.same(proof, proof.clone()));
        assertFalse(Handshake.same(proof, Arrays.copyOf(proof, 31)));
    }

    @Test
    void noncesOfAnotherLengthAndEmptyTokensAreRefused() {
        byte[] token = repeated(3, 16);
        byte[] nonce = repeated(7, 32);
        assertThrows(
                IllegalArgumentException.class,
                () -> Handshake.proof(Handshake.Side.WORKER, token, repeated(7, 31), nonce, CERTIFICATE));
        assertThrows(
                IllegalArgumentException.class,
                () -> Handshake.proof(Handshake.Side.WORKER, token, nonce, repeated(7, 33), CERTIFICATE));
        assertThrows(
                IllegalArgumentException.class,
                () -> Handshake.proof(Handshake.Side.WORKER, new byte[0], nonce, nonce, CERTIFICATE));
    }

    @Test
    void aHashIsThatOfTheStandardAndSurvivesItsBytes() {
        // FIPS 180-4, example "abc".
        ContentHash hash = ContentHash.of("abc".getBytes(US_ASCII));
        assertEquals("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", hash.toString());
        assertEquals(hash, ContentHash.fromBytes(hash.toBytes()));
        assertThrows(IllegalArgumentException.class, () -> ContentHash.fromBytes(new byte[31]));
    }
}
