package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class ServerSecurityTest {
    private static final byte[] ALONE = Farm.alone();

    @TempDir
    Path folder;

    private Path token;
    private Path certificate;
    private Path key;

    @BeforeEach
    void files() throws IOException {
        token = Files.writeString(folder.resolve("token"), "  0123456789abcdef\n");
        certificate = copy("server-cert.pem");
        key = copy("server-key.pem");
    }

    private Path copy(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.copy(ServerSecurityTest.class.getResourceAsStream("/net/" + name), file);
        return file;
    }

    private ServerOptions secured() {
        return Farm.options().withTls(certificate, key).withTokenFile(token);
    }

    @Test
    void overTlsWithAPinnedCertificateThePictureIsTheSame() throws Exception {
        try (Farm farm = new Farm(secured()).begin()) {
            farm.join(Farm.worker(1).withPin(farm.server.pin()).withTokenFile(token));
            farm.join(Farm.worker(1).withAuthorities(certificate).withTokenFile(token));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            for (var worker : farm.workers) {
                assertTrue(worker.get(10, TimeUnit.SECONDS).isDone());
            }
        }
    }

    @Test
    void aServerWithAnotherCertificateIsNotSpokenTo() throws Exception {
        try (Farm farm = new Farm(secured()).begin()) {
            String other = "00".repeat(32);
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).withPin(other).withTokenFile(token).withReconnect(0))
                    .get(20, TimeUnit.SECONDS);
            assertTrue(outcome.reason().contains("not " + other), outcome.reason());
            assertEquals(0, farm.server.job().film().done());
        }
    }

    @Test
    void whoSpeaksPlainlyToATlsServerGetsNowhere() throws Exception {
        try (Farm farm = new Farm(secured()).begin()) {
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).withTokenFile(token).withReconnect(0))
                    .get(20, TimeUnit.SECONDS);
            assertEquals(false, outcome.isDone());
            Farm.until(() -> farm.logHas("TLS failed"), "the server says why");
        }
    }

    @Test
    void aWorkerDoesNotWorkForAServerThatDoesNotKnowTheToken() throws Exception {
        Path other = Files.writeString(folder.resolve("other"), "another token of some length");
        try (Farm farm = new Farm(Farm.options().withTokenFile(other)).begin()) {
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).withTokenFile(token).withReconnect(0.3))
                    .get(20, TimeUnit.SECONDS);
            assertTrue(outcome.reason().contains("token"), outcome.reason());
        }
    }

    @Test
    void beyondLoopbackATokenIsRequired() {
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class, () -> new Farm(Farm.options().withAddress("0.0.0.0", 0)));
        assertTrue(e.getMessage().contains("need a token"), e.getMessage());
    }

    @Test
    void shortTokensAndFilesThatAreNoKeysAreRefused() throws IOException {
        Path small = Files.writeString(folder.resolve("small"), "0123456789abcde\n");
        assertFails("at least 16 characters, not 15", Farm.options().withTokenFile(small));
        assertFails("holds no \"BEGIN PRIVATE KEY\"", Farm.options().withTls(certificate, certificate));
        assertFails("is no PEM file of certificates", Farm.options().withTls(key, key));
    }

    private static void assertFails(String words, ServerOptions options) {
        IOException e = assertThrows(IOException.class, () -> new Farm(options).close());
        assertTrue(e.getMessage().contains(words), e.getMessage());
    }
}
