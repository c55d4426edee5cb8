package enlightenment.net.worker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.Farm;
import enlightenment.net.RawPeer;
import enlightenment.net.job.JobContent;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.MessageChannel;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A worker takes no more than a job may have, and nothing that is not what it asked for. */
@Timeout(600)
class WorkerContentsTest {
    /** What a worker makes of a server that answers its first request with this. */
    private static SessionEnd fetch(ContentHash wanted, Message answer, WorkerJobs jobs) throws Exception {
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                RawPeer server = new RawPeer(listening.getLocalPort());
                Socket socket = listening.accept();
                MessageChannel link = new MessageChannel(socket, socket, Farm.PATIENT, "test").begin()) {
            link.trust();
            server.send(answer);
            return new WorkerContents(link, jobs, () -> {}).fetch(new Message.Job(wanted, 1, List.of(wanted)));
        }
    }

    @Test
    void aWorkerTakesNoJobOfMoreThanOneGibibyte() throws Exception {
        ContentHash hash = ContentHash.of(new byte[1]);
        WorkerJobs jobs = new WorkerJobs(1, null, Build.number(), (tile, bytes) -> bytes);
        SessionEnd end = fetch(hash, new Message.Content(hash, 0, Limits.JOB + 1, new byte[9]), jobs);
        assertTrue(end.isFinal());
        assertTrue(end.reason().contains("more than 1073741824 bytes"), end.reason());
    }

    @Test
    void contentWithAnotherHashIsNotKept() throws Exception {
        byte[] content = "the right one".getBytes(StandardCharsets.US_ASCII);
        ContentHash hash = ContentHash.of(content);
        WorkerJobs jobs = new WorkerJobs(1, null, Build.number(), (tile, bytes) -> bytes);
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
        IOException e = assertThrows(
                IOException.class,
                () -> JobContent.read(noise, new SceneReader.NamedFiles(Map.of()), Build.number(), 1));
        assertTrue(e.getMessage().contains("no job") || e.getMessage().contains("cannot be used"), e.getMessage());
    }
}
