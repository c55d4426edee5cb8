package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Limits that honest peers do not meet. */
@Timeout(120)
class ServerLimitsTest {
    private static final byte[] ALONE = Farm.alone();

    @Test
    void moreWorkersThanThereArePlacesAreToldToComeAgain() throws Exception {
        Timing patient = new Timing(15_000, 10_000, 10_000, 30_000, 5_000, 20_000);
        try (Farm farm = new Farm(Farm.options().timing(patient).awaitWorkers(300, 60)).begin()) {
            List<RawPeer> peers = new ArrayList<>();
            for (int i = 0; i < Limits.WORKERS; i++) {
                RawPeer peer = new RawPeer(farm.server.port());
                peers.add(peer);
                assertNotNull(peer.enter("machine " + i, Token.NONE));
            }
            try (RawPeer oneMore = new RawPeer(farm.server.port())) {
                oneMore.prove(RawPeer.hello("one more"), Token.NONE);
                Message.Refuse refusal = oneMore.receive(Message.Refuse.class);
                assertTrue(refusal.again());
                assertTrue(refusal.reason().contains("as many workers as it can have"), refusal.reason());
            }
            for (RawPeer peer : peers) {
                peer.close();
            }
        }
    }

    @Test
    void framesAreBoundedAfterTheHandshakeToo() throws Exception {
        try (Farm farm = new Farm(Farm.options().timing(Farm.QUICK)).begin();
                RawPeer peer = new RawPeer(farm.server.port())) {
            peer.enter("large", Token.NONE);
            peer.bytes("00800001");
            peer.millisUntilClosed();
            Farm.until(() -> farm.logHas("a frame of 8388609 bytes is outside the limits 1..8388608"), "it is refused");
            farm.join(Farm.worker(2));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    /** What a worker makes of a server that answers its first request with this. */
    private static SessionEnd fetch(ContentHash wanted, Message answer, WorkerJobs jobs) throws Exception {
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                RawPeer server = new RawPeer(listening.getLocalPort());
                Socket socket = listening.accept();
                MessageChannel link = new MessageChannel(socket, socket, Farm.QUICK, "test").begin()) {
            link.trust();
            server.send(answer);
            return new WorkerContents(link, jobs).fetch(new Message.Job(wanted, 1, List.of(wanted)));
        }
    }

    @Test
    void aWorkerTakesNoJobOfMoreThanOneGibibyte() throws Exception {
        ContentHash hash = ContentHash.of(new byte[1]);
        WorkerJobs jobs = new WorkerJobs(1, Build.number(), (tile, bytes) -> bytes);
        SessionEnd end = fetch(hash, new Message.Content(hash, 0, Limits.JOB + 1, new byte[9]), jobs);
        assertTrue(end.isFinal());
        assertTrue(end.reason().contains("more than 1073741824 bytes"), end.reason());
    }

    @Test
    void contentWithAnotherHashIsNotKept() throws Exception {
        byte[] content = "the right one".getBytes(StandardCharsets.US_ASCII);
        ContentHash hash = ContentHash.of(content);
        WorkerJobs jobs = new WorkerJobs(1, Build.number(), (tile, bytes) -> bytes);
        IOException e =
                assertThrows(IOException.class, () -> fetch(hash, new Message.Content(hash, 0, 3, new byte[3]), jobs));
        assertTrue(e.getMessage().contains("came with other bytes"), e.getMessage());
        assertThrows(IOException.class, () -> fetch(hash, new Message.Content(hash, 0, 9, new byte[0]), jobs));
        assertThrows(IOException.class, () -> fetch(hash, new Message.Content(hash, 4, 9, new byte[5]), jobs));
        assertEquals(false, jobs.has(hash));
        assertNull(fetch(hash, new Message.Content(hash, 0, content.length, content), jobs));
        assertTrue(jobs.has(hash));
    }

    @Test
    void whatIsNoJobIsRefusedWithTheReason() {
        byte[] noise = new byte[200];
        IOException e = assertThrows(IOException.class, () -> JobContent.read(noise, List.of(), Build.number(), 1));
        assertTrue(e.getMessage().contains("no job") || e.getMessage().contains("cannot be used"), e.getMessage());
    }
}
