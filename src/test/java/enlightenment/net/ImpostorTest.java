package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.net.protocol.Frames;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.Timing;
import enlightenment.net.secure.Handshake;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A server that does not know the token decides nothing about a worker. */
@Timeout(600)
class ImpostorTest {
    private static final byte[] ALONE = Farm.alone();
    private static final ContentHash HASH = ContentHash.of(new byte[1]);

    @TempDir
    Path folder;

    /** Says hello to each worker with these messages, whatever it says. */
    private static final class Impostor implements AutoCloseable {
        final AtomicInteger visits = new AtomicInteger();
        private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        private final List<Message> lines;

        Impostor(List<Message> lines) throws IOException {
            this.lines = lines;
            Thread thread = new Thread(this::serve, "impostor");
            thread.setDaemon(true);
            thread.start();
        }

        private void serve() {
            while (!socket.isClosed()) {
                try (Socket worker = socket.accept()) {
                    visits.incrementAndGet();
                    OutputStream out = worker.getOutputStream();
                    for (Message line : lines) {
                        Frames.read(worker.getInputStream(), Limits.FRAME);
                        Frames.write(out, line, Limits.FRAME);
                        out.flush();
                    }
                    worker.getInputStream().read();
                } catch (IOException e) {
                    continue;
                }
            }
        }

        int port() {
            return socket.getLocalPort();
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    private static List<Message> lines(String how) {
        Message challenge = new Message.Challenge(Message.PROTOCOL, new byte[Handshake.NONCE_BYTES]);
        Message welcome = new Message.Welcome(new byte[Handshake.PROOF_BYTES], 1, 1, 1);
        return switch (how) {
            case "done" -> List.of(new Message.Bye("the picture is done"));
            case "refused" -> List.of(new Message.Refuse("never come back", false));
            case "done after the challenge" -> List.of(challenge, new Message.Bye("the picture is done"));
            case "refused after the challenge" -> List.of(challenge, new Message.Refuse("never come back", false));
            case "a wrong proof" -> List.of(challenge, welcome);
            case "another protocol" -> List.of(new Message.Challenge(99, new byte[Handshake.NONCE_BYTES]));
            default -> List.of(new Message.Job(HASH, 1, List.of(HASH)));
        };
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "done",
                "refused",
                "done after the challenge",
                "refused after the challenge",
                "a wrong proof",
                "another protocol",
                "a job"
            })
    void aWorkerThatMetAnImpostorWorksForTheServerThatComesAfterIt(String how) throws Exception {
        Path token = Files.writeString(folder.resolve("token"), "0123456789abcdef");
        int port;
        CompletableFuture<RenderWorker.Outcome> worker;
        try (Impostor impostor = new Impostor(lines(how))) {
            port = impostor.port();
            RenderWorker.Options.Builder options =
                    Farm.worker(1).tokenFile(token).reconnectSeconds(100);
            worker = CompletableFuture.supplyAsync(() -> {
                try {
                    return RenderWorker.run("127.0.0.1", port, options.build(), () -> false);
                } catch (IOException e) {
                    throw new java.io.UncheckedIOException(e);
                }
            });
            Farm.until(() -> impostor.visits.get() >= 2 || worker.isDone(), "it came back");
            assertFalse(worker.isDone(), "the impostor ended it");
        }
        // The thread that listened there may need a moment to let go of the place.
        Farm.until(() -> Farm.isFree(port), "the place is free again");
        ServerOptions.Builder real =
                Farm.options().address("127.0.0.1", port).tokenFile(token).awaitWorkers(1, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(real).begin()) {
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertEquals(
                    "the picture is done",
                    worker.get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS).reason());
        }
    }

    /** Somebody at a port who speaks something else, or nothing. */
    private static RenderWorker.Outcome atStranger(byte[] words, RenderWorker.Options.Builder options)
            throws Exception {
        try (ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
            Thread thread = new Thread(
                    () -> {
                        while (!socket.isClosed()) {
                            try (Socket worker = socket.accept()) {
                                worker.getOutputStream().write(words);
                                worker.getInputStream().readAllBytes();
                            } catch (IOException e) {
                                continue;
                            }
                        }
                    },
                    "stranger");
            thread.setDaemon(true);
            thread.start();
            RenderWorker.Outcome outcome = RenderWorker.run(
                    "127.0.0.1",
                    socket.getLocalPort(),
                    options.reconnectSeconds(0.1).build(),
                    () -> false);
            assertFalse(outcome.isDone());
            String who = "who answers at 127.0.0.1:" + socket.getLocalPort() + ", not proved to be the server, ";
            assertTrue(outcome.reason().contains(": " + who), outcome.reason());
            return outcome;
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"HTTP/1.1 400 Bad Request\r\n\r\n", "SSH-2.0-OpenSSH_9.2\r\n", "220 mail ESMTP\r\n"})
    void whoSpeaksSomethingElseIsToldByTheAddress(String words) throws Exception {
        byte[] bytes = words.getBytes(StandardCharsets.US_ASCII);
        String reason = atStranger(bytes, Farm.worker(1)).reason();
        long length = ByteBuffer.wrap(bytes).getInt();
        assertTrue(
                reason.endsWith(
                        ", speaks another protocol: a frame of " + length + " bytes is outside the limits 1..4096"),
                reason);
    }

    @Test
    void whoSaysNothingIsToldByTheAddress() throws Exception {
        Timing hurried = new Timing(300, 10_000, 10_000, 60_000, 1_000, 5_000);
        String reason = atStranger(new byte[0], Farm.worker(1).timing(hurried)).reason();
        assertTrue(reason.endsWith(", says nothing within 0.3 s"), reason);
    }

    @Test
    void whoSaysSomethingAndThenNoMoreIsToldByTheAddress() throws Exception {
        Timing hurried = new Timing(300, 10_000, 10_000, 60_000, 1_000, 5_000);
        ByteArrayOutputStream words = new ByteArrayOutputStream();
        Frames.write(words, lines("a wrong proof").get(0), Limits.FRAME);
        String reason =
                atStranger(words.toByteArray(), Farm.worker(1).timing(hurried)).reason();
        assertTrue(reason.endsWith(", says no more within 0.3 s"), reason);
    }

    @Test
    void whoSaysNothingThroughTlsIsToldByTheAddress() throws Exception {
        Timing hurried = new Timing(300, 10_000, 10_000, 60_000, 1_000, 5_000);
        RenderWorker.Options.Builder options = Farm.worker(1).timing(hurried).pin("00".repeat(32));
        String reason = atStranger(new byte[0], options).reason();
        assertTrue(reason.endsWith(", says nothing within 0.3 s"), reason);
    }

    @Test
    void whoSpeaksNoTlsWhereItIsExpectedIsToldByTheAddress() throws Exception {
        byte[] words = "SSH-2.0-OpenSSH_9.2\r\n".getBytes(StandardCharsets.US_ASCII);
        atStranger(words, Farm.worker(1).pin("00".repeat(32)));
    }

    @Test
    void inTheEndTheWorkerSaysWhatItWasToldAndByWhom() throws Exception {
        try (Impostor impostor = new Impostor(List.of(new Message.Bye("the picture\u001b[2J\nis done")))) {
            RenderWorker.Outcome outcome = RenderWorker.run(
                    "127.0.0.1",
                    impostor.port(),
                    Farm.worker(1).reconnectSeconds(0.1).build(),
                    () -> false);
            assertFalse(outcome.isDone());
            assertTrue(
                    outcome.reason().endsWith("not proved to be the server, says: the picture?[2J?is done"),
                    outcome.reason());
        }
    }
}
