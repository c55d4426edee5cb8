package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import enlightenment.listen.ServerLog;
import enlightenment.net.protocol.Message;
import enlightenment.net.secure.Token;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What peers say reaches nobody's terminal, log or page as they said it. */
@Timeout(600)
class TextsTest {
    private static final String NASTY =
            "\u001b[2J\u009b31m\r\nenlightenment: done\u202egnp\u0000\u2066" + "x".repeat(5_000);

    @Test
    void logAndStatusShowOneHarmlessLine() throws Exception {
        List<String> lines = new ArrayList<>();
        ServerOptions.Builder options = Farm.options()
                .localThreads(1)
                .awaitWorkers(1, Farm.TIMEOUT_SECONDS)
                .statusPort(0);
        try (Farm farm = new Farm(options).begin();
                RawPeer peer = new RawPeer(farm.server.port())) {
            Message.Hello h = RawPeer.hello(NASTY);
            peer.prove(h, Token.NONE);
            Message.Job job = peer.receive(Message.Job.class);
            peer.send(RawPeer.ready(job, NASTY));
            Farm.until(
                    () -> farm.server.round().snapshot().workers().stream()
                            .anyMatch(w -> w.name().startsWith("?[2J")),
                    "it has joined");
            String json = farm.status("status.json");
            assertEquals(Plain.lines(json), json);
            peer.send(new Message.Bye(NASTY));
            Farm.until(() -> farm.logHas(" left: "), "it has left");
            lines.addAll(List.copyOf(farm.log));
        }
        for (String line : lines) {
            assertEquals(Plain.line(line, ServerLog.LONGEST_LINE), line);
            assertFalse(line.startsWith("enlightenment: done"));
        }
    }
}
