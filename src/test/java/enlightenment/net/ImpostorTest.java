package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.net.protocol.Frames;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.secure.Handshake;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
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
@Timeout(120)
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
            WorkerOptions.Builder options = Farm.worker(1).tokenFile(token).reconnectSeconds(100);
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
                Farm.options().address("127.0.0.1", port).tokenFile(token).awaitWorkers(1, 60);
        try (Farm farm = new Farm(real).begin()) {
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertEquals("the picture is done", worker.get(60, TimeUnit.SECONDS).reason());
        }
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
