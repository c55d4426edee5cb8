package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(600)
class ServerSecurityTest {
    private static final double FOR_EVER = 1e9;

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

    private ServerOptions.Builder secured() {
        return Farm.options().tls(certificate, key).tokenFile(token);
    }

    @Test
    void overTlsWithAPinnedCertificateThePictureIsTheSame() throws Exception {
        try (Farm farm = new Farm(secured().awaitWorkers(2, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1).pin(farm.server.pin()).tokenFile(token));
            farm.join(Farm.worker(1).authorities(certificate).tokenFile(token));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            for (var worker : farm.workers) {
                assertTrue(worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whoIsStillShakingHandsWhenThePictureIsDoneIsToldSo(boolean isOverTls) throws Exception {
        ServerOptions.Builder options = isOverTls ? secured() : Farm.options().tokenFile(token);
        try (Farm farm = new Farm(options).begin();
                FaultProxy proxy = new FaultProxy(farm.server.port())) {
            proxy.freeze(Integer.MAX_VALUE);
            CompletableFuture<RenderWorker.Outcome> late =
                    farm.join(patient(farm, isOverTls).reconnectSeconds(0), proxy.port(), () -> false);
            Farm.until(() -> proxy.connections() == 1, "it knocks");
            // So it comes second.
            CompletableFuture<RenderWorker.Outcome> other = farm.join(patient(farm, isOverTls));
            assertTrue(other.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone());
            proxy.freeze(0);
            assertEquals(
                    "the picture is done",
                    late.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).reason());
            assertTrue(late.get().isDone());
        }
    }

    private RenderWorker.Options.Builder patient(Farm farm, boolean isOverTls) {
        RenderWorker.Options.Builder worker = Farm.worker(1).tokenFile(token);
        return isOverTls ? worker.pin(farm.server.pin()) : worker;
    }

    @Test
    void aServerWithAnotherCertificateIsNotSpokenTo() throws Exception {
        try (Farm farm = new Farm(secured()).begin()) {
            String other = "00".repeat(32);
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).pin(other).tokenFile(token).reconnectSeconds(FOR_EVER))
                    .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            String words = "certificate is not trusted: it is " + farm.server.pin() + ", not " + other;
            assertTrue(outcome.reason().contains(words), outcome.reason());
            assertEquals(0, farm.server.round().job().film().done());
        }
    }

    @Test
    void aServerThatNoAuthorityVouchesForIsNotTriedAgain() throws Exception {
        Path other = copy("self-signed.pem");
        try (Farm farm = new Farm(secured()).begin()) {
            assertUntrusted(farm, other);
        }
        // It vouches for itself, but not for the name that is connected to.
        ServerOptions.Builder nameless = Farm.options().tokenFile(token).tls(other);
        try (Farm farm = new Farm(nameless).begin()) {
            assertUntrusted(farm, other);
        }
    }

    private void assertUntrusted(Farm farm, Path authorities) throws Exception {
        RenderWorker.Outcome outcome = farm.join(
                        Farm.worker(1).authorities(authorities).tokenFile(token).reconnectSeconds(FOR_EVER))
                .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        assertEquals(false, outcome.isDone());
        assertTrue(outcome.reason().startsWith("the server's certificate is not trusted: "), outcome.reason());
    }

    @Test
    void aConnectionThatBreaksInTheMiddleOfTheHandshakeIsTriedAgain() throws Exception {
        AtomicInteger connections = new AtomicInteger();
        try (ServerSocket breaker = new ServerSocket(0, 10, InetAddress.getLoopbackAddress())) {
            Thread closing = new Thread(() -> {
                try {
                    while (true) {
                        breaker.accept().close();
                        connections.incrementAndGet();
                    }
                } catch (IOException e) {
                    // The test is over.
                    return;
                }
            });
            closing.setDaemon(true);
            closing.start();
            RenderWorker.Options.Builder options =
                    Farm.worker(1).pin("00".repeat(32)).tokenFile(token).reconnectSeconds(FOR_EVER);
            RenderWorker.Outcome outcome = RenderWorker.run(
                    "127.0.0.1", breaker.getLocalPort(), options.build(), () -> connections.get() >= 3);
            assertEquals("stopped", outcome.reason());
        }
    }

    @Test
    void whoSpeaksPlainlyToATlsServerGetsNowhere() throws Exception {
        try (Farm farm = new Farm(secured()).begin()) {
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).tokenFile(token).reconnectSeconds(0))
                    .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertEquals(false, outcome.isDone());
            Farm.until(() -> farm.logHas("TLS failed"), "the server says why");
            assertTrue(
                    outcome.reason().endsWith("the server speaks TLS: a worker of it needs --pin or --tls-ca"),
                    outcome.reason());
        }
    }

    @Test
    void aWorkerDoesNotWorkForAServerThatDoesNotKnowTheToken() throws Exception {
        Path other = Files.writeString(folder.resolve("other"), "another token of some length");
        try (Farm farm = new Farm(Farm.options().tokenFile(other)).begin()) {
            RenderWorker.Outcome outcome = farm.join(
                            Farm.worker(1).tokenFile(token).reconnectSeconds(0.3))
                    .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertTrue(outcome.reason().contains("token"), outcome.reason());
        }
    }

    @Test
    void beyondLoopbackATokenIsRequired() {
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class, () -> new Farm(Farm.options().address("0.0.0.0", 0)));
        assertTrue(e.getMessage().contains("need a token"), e.getMessage());
    }

    @Test
    void aServerThatMadeItsSecretsIsJoinedWithTokenAndPin() throws Exception {
        Path made = folder.resolve("made-token");
        ServerOptions.Builder options =
                Farm.options().tls(folder.resolve("made.pem")).tokenFile(made).awaitWorkers(2, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(options).begin()) {
            farm.join(Farm.worker(1).pin(farm.server.pin()).tokenFile(made));
            farm.join(Farm.worker(1).pin(farm.server.pin()).token(Files.readString(made)));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            for (var worker : farm.workers) {
                assertTrue(worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).isDone());
            }
        }
    }

    @Test
    void anExpiredCertificateIsRefusedByWhoChecksItAndTakenByWhoPinsIt() throws Exception {
        Path expired = copy("expired.pem");
        try (Farm farm = new Farm(Farm.options().tls(expired)).begin()) {
            RenderWorker.Outcome refused = farm.join(
                            Farm.worker(1).authorities(expired).reconnectSeconds(0))
                    .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertFalse(refused.isDone());
            farm.join(Farm.worker(1).pin(farm.server.pin()));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    @Test
    void aWorkerMakesNoTokenAndSaysWhereItComesFrom() {
        Path none = folder.resolve("none");
        RenderWorker.Options options =
                RenderWorker.Options.builder().tokenFile(none).build();
        String message = assertThrows(IOException.class, () -> RenderWorker.run("127.0.0.1", 1, options, () -> true))
                .getMessage();
        assertTrue(message.endsWith("there is no such file; copy the server's token to it"), message);
        assertFalse(Files.exists(none));
        assertThrows(IllegalArgumentException.class, () -> RenderWorker.Options.builder()
                .token("0123456789abcde\n"));
    }
}
