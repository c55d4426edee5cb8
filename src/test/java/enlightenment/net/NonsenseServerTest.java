package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.job.JobContent;
import enlightenment.net.protocol.Frames;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.secure.Handshake;
import enlightenment.net.secure.Tls;
import enlightenment.net.secure.Token;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.CRC32C;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A server that proves itself and then talks nonsense is given up like one that is away. */
@Timeout(600)
class NonsenseServerTest {
    private static final byte[] CONTENT = {1, 2, 3};
    private static final ContentHash HASH = ContentHash.of(CONTENT);

    /** After {@code --reconnect 1}: pauses of at least 50, 100, 200, 400 and 800 ms lie between six visits. */
    private static final int MOST_VISITS = 6;

    private final AtomicInteger visits = new AtomicInteger();
    private final List<String> log = Collections.synchronizedList(new ArrayList<>());

    /** What the server says when it has proved itself, and to each request. */
    private interface Talk {
        void job(OutputStream out) throws IOException;

        default Message content(Message.ContentRequest request) {
            return new Message.Content(request.content(), 0, CONTENT.length, CONTENT);
        }

        default Message ready() {
            return new Message.Challenge(Message.PROTOCOL, new byte[Handshake.NONCE_BYTES]);
        }
    }

    private static void say(OutputStream out, Message message) throws IOException {
        Frames.write(out, message, Limits.FRAME);
        out.flush();
    }

    private void serve(ServerSocket socket, Talk talk) {
        while (!socket.isClosed()) {
            try (Socket worker = socket.accept()) {
                visits.incrementAndGet();
                OutputStream out = worker.getOutputStream();
                Message.Hello hello = (Message.Hello) next(worker);
                byte[] nonce = new byte[Handshake.NONCE_BYTES];
                say(out, new Message.Challenge(Message.PROTOCOL, nonce));
                next(worker);
                byte[] proof =
                        Handshake.proof(Handshake.Side.SERVER, Token.NONE, hello.nonce(), nonce, Tls.noCertificate());
                say(out, new Message.Welcome(proof, 200, 600_000, Limits.UNACKNOWLEDGED_TILES));
                talk.job(out);
                while (true) {
                    Message message = next(worker);
                    if (message instanceof Message.ContentRequest request) {
                        say(out, talk.content(request));
                    } else if (message instanceof Message.Ready) {
                        say(out, talk.ready());
                    }
                }
            } catch (IOException | java.util.NoSuchElementException e) {
                continue;
            }
        }
    }

    private static Message next(Socket worker) throws IOException {
        return Frames.read(worker.getInputStream(), Limits.FRAME).orElseThrow();
    }

    private RenderWorker.Outcome meet(Talk talk) throws Exception {
        try (ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress())) {
            Thread thread = new Thread(() -> serve(socket, talk), "nonsense");
            thread.setDaemon(true);
            thread.start();
            RenderWorker.Options options =
                    Farm.worker(1).reconnectSeconds(1).log(log::add).build();
            return RenderWorker.run("127.0.0.1", socket.getLocalPort(), options, () -> false);
        }
    }

    private static Message.Job job() {
        return new Message.Job(HASH, 1, List.of(HASH));
    }

    private static Talk talk(String how) {
        return switch (how) {
            case "content of other bytes" -> talk(new Message.Content(HASH, 0, 2, new byte[2]));
            case "an empty piece of 900 MiB" -> talk(new Message.Content(HASH, 0, 900L << 20, new byte[0]));
            case "a total of 0" -> talk(new Message.Content(HASH, 0, 0, new byte[0]));
            case "1,002 contents" -> NonsenseServerTest::sayTooManyContents;
            default -> realJobThenNonsense();
        };
    }

    private static Talk talk(Message.Content answer) {
        return new Talk() {
            @Override
            public void job(OutputStream out) throws IOException {
                say(out, NonsenseServerTest.job());
            }

            @Override
            public Message content(Message.ContentRequest request) {
                return answer;
            }
        };
    }

    private static Talk realJobThenNonsense() {
        DividedRender render = DividedRender.prepare(Farm.SCENE, Farm.SETTINGS, () -> false);
        JobContent job = JobContent.of(Farm.SCENE, render.outline(), Build.number());
        return new Talk() {
            @Override
            public void job(OutputStream out) throws IOException {
                say(out, new Message.Job(job.hash(), render.units(), job.hashes()));
            }

            @Override
            public Message content(Message.ContentRequest request) {
                byte[] bytes = job.content(request.content());
                return new Message.Content(request.content(), 0, bytes.length, bytes);
            }
        };
    }

    /** As bytes, since no record has them. */
    private static void sayTooManyContents(OutputStream out) throws IOException {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        body.writeBytes(new byte[] {(byte) 0x84, 6});
        writeHash(body);
        body.writeBytes(new byte[] {1, (byte) 0x99, 1002 >> 8, (byte) 1002});
        for (int i = 0; i < 1002; i++) {
            writeHash(body);
        }
        CRC32C crc = new CRC32C();
        crc.update(body.toByteArray());
        ByteBuffer frame = ByteBuffer.allocate(body.size() + 2 * Integer.BYTES);
        frame.putInt(body.size()).put(body.toByteArray()).putInt((int) crc.getValue());
        out.write(frame.array());
        out.flush();
    }

    private static void writeHash(ByteArrayOutputStream body) {
        body.writeBytes(new byte[] {0x58, ContentHash.BYTES});
        body.writeBytes(HASH.toBytes());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "content of other bytes",
                "an empty piece of 900 MiB",
                "a total of 0",
                "1,002 contents",
                "nonsense after a real job"
            })
    void aWorkerGivesUpWhoProvesItselfAndTalksNonsense(String how) throws Exception {
        RenderWorker.Outcome outcome = meet(talk(how));
        assertFalse(outcome.isDone());
        assertTrue(outcome.reason().startsWith("no tile was taken by the server for "), outcome.reason());
        assertTrue(visits.get() <= MOST_VISITS, visits + " visits");
        List<String> complaints =
                log.stream().filter(line -> line.contains("lost the server: ")).toList();
        // On a very busy machine one visit may take all the time that there is.
        assertTrue(complaints.size() <= 2, log.toString());
        if (complaints.size() == 2) {
            assertEquals(visits.get() - 1 + " times: " + complaints.get(0), complaints.get(1));
        }
    }

    @Test
    void fiveHundredRandomBytesWithTheirRightHashAreNoJob() throws Exception {
        byte[] noise = new byte[500];
        new Random(1).nextBytes(noise);
        ContentHash hash = ContentHash.of(noise);
        RenderWorker.Outcome outcome = meet(new Talk() {
            @Override
            public void job(OutputStream out) throws IOException {
                say(out, new Message.Job(hash, 1, List.of(hash)));
            }

            @Override
            public Message content(Message.ContentRequest request) {
                return new Message.Content(hash, 0, noise.length, noise);
            }
        });
        assertFalse(outcome.isDone());
        assertTrue(outcome.reason().startsWith("this is no job"), outcome.reason());
        assertEquals(1, visits.get(), "trying again would not help");
    }

    @Test
    void differentComplaintsAreCountedApart() {
        RepeatedLines lines = new RepeatedLines(log::add);
        for (String line : new String[] {"a", "b", "a", "a"}) {
            lines.say(line);
        }
        lines.settle();
        lines.say("a");
        assertEquals(List.of("a", "b", "3 times: a", "a"), log);
    }
}
