package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.engine.UnitMaker;
import enlightenment.net.protocol.Message;
import enlightenment.net.secure.Token;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What counts of what workers send, and what is told of audits that were not made. */
@Timeout(600)
class ServerAuditsTest {
    private static final byte[] ALONE = Farm.alone();

    /** Every tile, each a little wrong, before the render begins and without a lease. */
    @Test
    void whatIsSentBeforeTheBeginningDoesNotCount() throws Exception {
        ServerOptions.Builder options = Farm.options().auditRate(0).awaitWorkers(2, 1e6);
        try (Farm farm = new Farm(options).begin()) {
            try (RawPeer liar = new RawPeer(farm.server.port())) {
                Message.Job job = liar.enter("liar", Token.NONE);
                sendAll(liar, job, farm);
                liar.send(RawPeer.ready(job, "liar"));
                sendAll(liar, job, farm);
                farm.join(Farm.worker(1).machine("honest"));
                liar.receive(Message.Grant.class);
            }
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }

    private static void sendAll(RawPeer liar, Message.Job job, Farm farm) throws IOException {
        UnitMaker maker =
                DividedRender.prepare(Farm.SCENE, Farm.SETTINGS, () -> false).maker();
        for (int tile = 0; tile < job.tiles(); tile++) {
            byte[] wrong = maker.make(tile);
            // The last but one byte of the red of its last pixel, which has 36.
            wrong[wrong.length - 36 + 6] ^= 1;
            liar.send(new Message.Result(0, job.job(), tile, wrong));
            assertEquals(tile, liar.receive(Message.Acknowledge.class).tile());
        }
        assertEquals(0, farm.server.round().job().film().done());
        assertEquals(0, farm.server.round().snapshot().workers().size(), "it has not begun");
    }

    @Test
    void auditsThatOneMachineAloneLeavesAreInTheLogAndInTheReport() throws Exception {
        ServerOptions.Builder options = Farm.options().auditRate(1).awaitWorkers(1, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(options).begin()) {
            farm.join(Farm.worker(1).machine("only"));
            assertTrue(farm.result().complete());
            int tiles = farm.server.round().job().tiles();
            RenderServer.AuditReport audits = farm.server.audits();
            assertFalse(audits.isComplete());
            assertEquals(tiles, audits.due());
            assertEquals(tiles, audits.missing());
            assertEquals(IntStream.range(0, tiles).boxed().toList(), audits.where());
            assertTrue(farm.logHas("warning: " + tiles + " of " + tiles + " audits were not made: "), "" + farm.log);
        }
    }

    @Test
    void auditsOfASecondMachineAreMade() throws Exception {
        ServerOptions.Builder options = Farm.options().auditRate(1).awaitWorkers(2, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(options).begin()) {
            farm.join(Farm.worker(1).machine("one"));
            farm.join(Farm.worker(1).machine("other"));
            assertTrue(farm.result().complete());
            RenderServer.AuditReport audits = farm.server.audits();
            assertTrue(audits.isComplete(), audits.toString());
            assertEquals(farm.server.round().job().tiles(), audits.due());
            assertFalse(farm.logHas("not made"), farm.log.toString());
        }
    }

    @Test
    void theSentenceNamesTwentyTilesAtMost() {
        assertEquals(
                "1 of 1 audit was not made: no second machine checked tile 7",
                AuditCount.ofTiles(List.of(7), List.of(7)).sentence());
        List<Integer> many = IntStream.range(0, 25).boxed().toList();
        assertTrue(AuditCount.ofTiles(many, many).sentence().endsWith("18, 19, and 5 more"));
        assertEquals(
                "3 of 4 audits were not made: no second machine checked tiles of frames 2, 9",
                new RenderServer.AuditReport(4, 3, true, List.of(2, 9)).sentence());
    }
}
