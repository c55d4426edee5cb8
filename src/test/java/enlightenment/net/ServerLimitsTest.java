package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Message;
import enlightenment.net.secure.Token;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Limits that honest peers do not meet. */
@Timeout(600)
class ServerLimitsTest {
    private static final byte[] ALONE = Farm.alone();

    @Test
    void moreWorkersThanThereArePlacesAreToldToComeAgain() throws Exception {
        try (Farm farm = new Farm(Farm.options().awaitWorkers(300, Farm.TIMEOUT_SECONDS)).begin()) {
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
        try (Farm farm = new Farm(Farm.options()).begin();
                RawPeer peer = new RawPeer(farm.server.port())) {
            peer.enter("large", Token.NONE);
            peer.bytes("02000001");
            peer.awaitClose();
            Farm.until(
                    () -> farm.logHas("a frame of 33554433 bytes is outside the limits 1..33554432"), "it is refused");
            farm.join(Farm.worker(2));
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
        }
    }
}
