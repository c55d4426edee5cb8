package enlightenment.cli.serve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the commands tell of audits that were not made, with one machine only. */
@Timeout(600)
class AuditsCommandTest extends SceneFixture {
    private static final int SECONDS = 300;

    AuditsCommandTest() {
        super(50, 34);
    }

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    /** A server whose only help is this machine's worker. */
    private CliRun serve(Object... more) throws Exception {
        int port = freePort();
        CompletableFuture<CliRun> worker = CompletableFuture.supplyAsync(
                () -> CliRun.of("worker", "127.0.0.1:" + port, "--threads", 1, "--reconnect", SECONDS));
        String[] usual = CliRun.texts(
                "server",
                scene,
                "-o",
                picture,
                "--port",
                port,
                "--local-threads",
                0,
                "--min-workers",
                1,
                "--wait",
                SECONDS);
        String[] all = Stream.concat(Arrays.stream(usual), Arrays.stream(CliRun.texts(more)))
                .toArray(String[]::new);
        CliRun run = CliRun.of((Object[]) all);
        assertEquals(0, worker.get(SECONDS, TimeUnit.SECONDS).code());
        return run;
    }

    private static String lastLine(CliRun run) {
        return run.err().strip().replaceFirst("(?s).*\\R", "");
    }

    @Test
    void auditsThatNobodyMadeAreTheLastLineAndInTheReport() throws Exception {
        Path report = folder.resolve("report.json");
        CliRun run = serve("--audit", 1, "--report", report);
        assertEquals(0, run.code(), run.err());
        String json = Files.readString(report).replaceAll("\\s", "");
        int due = Integer.parseInt(json.replaceFirst(".*\"audits\":\\{\"due\":(\\d+),.*", "$1"));
        assertTrue(json.contains("\"missing\":" + due + ",\"tiles\":[0,1,"), json);
        assertTrue(
                lastLine(run).startsWith("enlightenment: warning: " + due + " of " + due + " audits were not made: "),
                run.err());
    }

    @Test
    void requiredAuditsThatNobodyMadeAreAFailureOfAPictureThatIsWritten() throws Exception {
        byte[] alone = CliRun.picture("render", scene, "-o", folder.resolve("alone.png"));
        CliRun run = serve("--audit", 1, "--audit-required");
        assertEquals(1, run.code(), run.err());
        assertTrue(lastLine(run).endsWith(", which --audit-required asks for"), run.err());
        assertArrayEquals(alone, Files.readAllBytes(picture));
    }

    @Test
    void whereNothingIsAuditedNothingIsTold() throws Exception {
        CliRun run = serve("--audit", 0);
        assertEquals(0, run.code(), run.err());
        assertFalse(run.err().contains("audit"), run.err());
    }

    @Test
    void aServerAloneNeedsNoAudits() {
        CliRun run = CliRun.of("server", scene, "-o", picture, "--port", 0, "--audit", 1, "--audit-required");
        assertEquals(0, run.code(), run.err());
        assertFalse(run.err().contains("audit"), run.err());
    }

    @Test
    void requiredAuditsOfNothingAreRefused() {
        CliRun run = CliRun.of("server", scene, "-o", picture, "--audit", 0, "--audit-required");
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains("--audit-required must not be given with --audit 0"), run.err());
    }
}
