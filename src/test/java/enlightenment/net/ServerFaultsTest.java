package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.file.ContentHash;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.Timing;
import enlightenment.net.secure.Token;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Strangers, liars and the dead; in each test an honest worker ends the picture afterwards. Deadlines are far away, but for the one that
 * a test is about: on a busy machine whoever keeps the others would miss them.
 */
@Timeout(600)
class ServerFaultsTest {
    private static final byte[] ALONE = Farm.alone();

    private static final int FAR = Farm.PATIENT.idleMillis();
    private static final int SOON = 600;
    private static final int HEARTBEAT = 50;

    @TempDir
    Path folder;

    private Farm farm;

    @BeforeEach
    void server() throws IOException {
        farm = new Farm(Farm.options()).begin();
    }

    @AfterEach
    void theHonestWorkerEndsThePicture() throws Exception {
        farm.join(Farm.worker(2).machine("honest"));
        assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        farm.close();
    }

    /** The same server with other deadlines. */
    private void restart(Timing timing) throws IOException {
        farm.close();
        farm = new Farm(Farm.options().timing(timing)).begin();
    }

    private RawPeer peer() throws IOException {
        return new RawPeer(farm.server.port());
    }

    private void assertLogged(String words) {
        Farm.until(() -> farm.logHas(words), "the log has: " + words + "\n" + farm.log);
    }

    @Test
    void garbageOnThePortEndsItsConnectionOnly() throws Exception {
        Random random = new Random(1);
        for (int i = 0; i < 40; i++) {
            try (RawPeer peer = peer()) {
                byte[] garbage = new byte[random.nextInt(300) + 5];
                random.nextBytes(garbage);
                peer.bytes(garbage);
                peer.awaitClose();
            }
        }
        try (RawPeer peer = peer()) {
            peer.bytes("GET / HTTP/1.1\r\nHost: x\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            peer.awaitClose();
        }
        assertLogged("outside the limits 1..4096");
    }

    @Test
    void aFrameThatClaimsTwoGibibytesIsNotWaitedFor() throws Exception {
        try (RawPeer peer = peer()) {
            peer.bytes("7fffffff00");
            peer.awaitClose();
        }
        assertLogged("a frame of 2147483647 bytes");
    }

    @Test
    void whoSaysNothingOrTricklesIsHungUpOn() throws Exception {
        restart(new Timing(SOON, FAR, FAR, FAR, HEARTBEAT, FAR));
        try (RawPeer silent = peer();
                RawPeer trickling = peer()) {
            Thread trickle = new Thread(() -> {
                try {
                    trickling.bytes("00000400");
                    // As many as there are, until it is hung up on.
                    for (int i = 0; i < 0x400; i++) {
                        trickling.bytes("80");
                        Farm.sleep(20);
                    }
                } catch (IOException closed) {
                    return;
                }
            });
            trickle.start();
            trickling.awaitClose();
            silent.awaitClose();
            trickle.join();
        }
        assertLogged("did not prove within 600 ms");
    }

    @Test
    void afterTheHandshakeAFrameMustComeInTimeToo() throws Exception {
        restart(new Timing(FAR, SOON, FAR, FAR, HEARTBEAT, FAR));
        try (RawPeer peer = peer()) {
            peer.enter("slow", Token.NONE);
            peer.bytes("00001000");
            peer.awaitClose();
        }
        assertLogged("sends a message too slowly");
    }

    @Test
    void whoIsIdleAfterTheHandshakeIsHungUpOn() throws Exception {
        restart(new Timing(FAR, FAR, FAR, SOON, HEARTBEAT, FAR));
        try (RawPeer peer = peer()) {
            peer.enter("idle", Token.NONE);
            peer.awaitClose();
        }
        assertLogged("is idle");
    }

    @Test
    void aWorkerThatFallsSilentLosesItsTiles() throws Exception {
        restart(new Timing(FAR, FAR, FAR, FAR, HEARTBEAT, SOON));
        try (RawPeer peer = peer()) {
            peer.join("silent", Token.NONE);
            peer.receive(Message.Grant.class);
            assertInstanceOf(Message.Refuse.class, peer.receive(Message.Refuse.class));
        }
        assertLogged("silent for");
    }

    @Test
    void whoReadsNothingIsHungUpOn() throws Exception {
        restart(new Timing(FAR, FAR, SOON, FAR, HEARTBEAT, FAR));
        try (RawPeer peer = peer()) {
            Message.Job job = peer.enter("deaf", Token.NONE);
            Message request = new Message.ContentRequest(job.contents().get(0), 0);
            assertThrows(IOException.class, () -> {
                for (int i = 0; i < 1_000_000; i++) {
                    peer.send(request);
                }
            });
        }
        assertLogged("does not read what it is sent");
    }

    @Test
    void anotherVersionIsRefusedWithBothNumbers() throws Exception {
        RenderWorker.Outcome outcome =
                farm.join(Farm.worker(1).version("0.0.7")).get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        assertFalse(outcome.isDone());
        assertTrue(outcome.reason().contains("the worker 0.0.7: install the same version"), outcome.reason());
        try (RawPeer peer = peer()) {
            Message.Hello h = RawPeer.hello("future");
            peer.send(new Message.Hello(
                    h.magic(), Message.PROTOCOL + 1, 99, h.build(), "x", 1, h.arithmetic(), h.nonce()));
            assertTrue(peer.receive(Message.Refuse.class)
                    .reason()
                    .contains("protocol " + Message.PROTOCOL + ", the worker " + (Message.PROTOCOL + 1) + "..99"));
        }
    }

    @Test
    void aMachineThatComputesOtherNumbersIsRefused() throws Exception {
        try (RawPeer peer = peer()) {
            Message.Hello h = RawPeer.hello("odd");
            ContentHash other = ContentHash.of(new byte[1]);
            peer.prove(
                    new Message.Hello(h.magic(), h.oldest(), h.newest(), h.build(), "x", 1, other, h.nonce()),
                    Token.NONE);
            assertTrue(peer.receive(Message.Refuse.class).reason().contains("canary"));
        }
    }

    @Test
    void aWrongTokenIsRefusedAndTheWorkerSaysSoInTheEnd() throws Exception {
        Path token = Files.writeString(folder.resolve("token"), "0123456789abcdef wrong");
        RenderWorker.Outcome outcome = farm.join(Farm.worker(1).tokenFile(token).reconnectSeconds(0.3))
                .get(Farm.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        assertTrue(outcome.reason().contains("does not know the server's token"), outcome.reason());
    }

    @Test
    void beforeTheHandshakeNothingElseIsHeard() throws Exception {
        for (Message message : new Message[] {
            new Message.Ready(ContentHash.of(new byte[0]), new byte[32], new byte[32]),
            new Message.Heartbeat(List.of(1L)),
            new Message.ContentRequest(ContentHash.of(new byte[0]), 0),
            new Message.Result(0, ContentHash.of(new byte[0]), 0, new byte[9])
        }) {
            try (RawPeer peer = peer()) {
                peer.send(message);
                peer.awaitClose();
            }
        }
        assertLogged("no hello");
        assertEquals(0, farm.server.round().job().film().done());
    }

    @Test
    void resultsOfWrongSizeOrWithNanOrForGrowthExpelTheirMachine() throws Exception {
        int length = farm.server.round().job().film().longest(0);
        byte[] nan =
                ByteBuffer.allocate(length).putDouble(length - 36, Double.NaN).array();
        byte[] grown = DividedRender.prepare(Farm.SCENE, Farm.SETTINGS, () -> false)
                .growing(() -> false, null)
                .make(0, null);
        assertTrue(grown.length > length, "with what a tile grows by, of which workers know nothing");
        int n = 0;
        for (byte[] bytes : new byte[][] {new byte[3], nan, new byte[length], grown}) {
            String machine = "liar " + n++;
            try (RawPeer peer = peer()) {
                Message.Job job = peer.join(machine, Token.NONE);
                peer.receive(Message.Grant.class);
                peer.send(new Message.Result(0, job.job(), 0, bytes));
                Message.Refuse refusal = peer.receive(Message.Refuse.class);
                assertTrue(refusal.reason().startsWith("tile 0: "), refusal.reason());
                assertFalse(refusal.again());
            }
            assertLogged(RawPeer.called(machine, farm) + " expelled");
            try (RawPeer peer = peer()) {
                peer.join(machine, Token.NONE);
                assertTrue(peer.receive(Message.Refuse.class).reason().contains("expelled"));
            }
        }
    }

    @Test
    void anotherJobsResultIsTakenFromTheWorkerAndForgotten() throws Exception {
        try (RawPeer peer = peer()) {
            peer.join("old", Token.NONE);
            peer.send(new Message.Result(5, ContentHash.of(new byte[4]), 3, new byte[8]));
            assertEquals(3, peer.receive(Message.Acknowledge.class).tile());
        }
        assertEquals(0, farm.server.round().job().film().done());
    }

    @Test
    void contentThatThereIsNotEndsTheConnection() throws Exception {
        try (RawPeer peer = peer()) {
            peer.enter("curious", Token.NONE);
            peer.send(new Message.ContentRequest(ContentHash.of("/etc/passwd".getBytes(StandardCharsets.UTF_8)), 0));
            peer.awaitClose();
        }
        assertLogged("there is no content");
    }
}
