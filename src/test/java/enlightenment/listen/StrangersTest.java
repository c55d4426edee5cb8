package enlightenment.listen;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Who has a place, what is told about those who have none, and what happens when there are no files left. */
class StrangersTest {
    @Test
    void theOldestLeavesFirst() {
        Strangers<Integer> strangers = new Strangers<>(3, 3);
        for (int i = 0; i < 3; i++) {
            assertEquals(List.of(), strangers.add(i, "a"));
        }
        assertEquals(List.of(0), strangers.add(3, "a"));
        strangers.remove(1);
        assertEquals(List.of(), strangers.add(4, "b"));
        assertEquals(List.of(2), strangers.add(5, "b"));
        assertEquals(List.of(3, 4, 5), strangers.list());
    }

    @Test
    void oneAddressCannotTakeThePlacesOfOthers() {
        SplittableRandom random = new SplittableRandom(3);
        Strangers<Integer> strangers = new Strangers<>(16, 8);
        strangers.add(-1, "honest");
        for (int i = 0; i < 10_000; i++) {
            strangers.add(i, "flood " + random.nextInt(4));
            assertTrue(strangers.size() <= 16);
            assertTrue(strangers.contains(-1), "after " + i);
        }
        Strangers<Integer> one = new Strangers<>(16, 8);
        for (int i = 0; i < 100; i++) {
            one.add(i, "flood");
        }
        assertEquals(8, one.size());
        assertEquals(92, one.oldest());
        new ArrayList<>(one.list()).forEach(one::remove);
        assertNull(one.oldest());
    }

    @Test
    void ofAnIpv6AddressTheHalfThatOneCustomerHasCounts() throws IOException {
        String one = Strangers.addressOf(InetAddress.getByName("2001:db8:1:2:3:4:5:6"));
        assertEquals(one, Strangers.addressOf(InetAddress.getByName("2001:db8:1:2:ffff::1")));
        assertNotEquals(one, Strangers.addressOf(InetAddress.getByName("2001:db8:1:3:3:4:5:6")));
        assertEquals("10.0.0.7", Strangers.addressOf(InetAddress.getByName("10.0.0.7")));
        assertEquals("10.0.0.7", Strangers.addressOf(InetAddress.getByName("::ffff:10.0.0.7")));
    }

    @Test
    void whereFilesAreFewStrangersGetAQuarterOfThem() {
        assertEquals(128, Strangers.places(128, 4_096));
        assertEquals(16, Strangers.places(128, 64));
        assertEquals(1, Strangers.places(128, 2));
        assertEquals(128, Strangers.places(128, 0));
    }

    @Test
    void aFloodMakesFewLinesAndTheirNumberIsTold() {
        AtomicLong now = new AtomicLong(Long.MAX_VALUE - 5);
        List<String> lines = new ArrayList<>();
        ServerLog log = new ServerLog(lines::add, now::get);
        for (int i = 0; i < 1_000; i++) {
            log.seldom("10.0.0.1", "a flood");
        }
        assertEquals(ServerLog.LINES_ABOUT_ONE, lines.size());
        log.seldom("10.0.0.2", "somebody else");
        assertEquals("somebody else", lines.get(lines.size() - 1));
        for (int i = 0; i < 100_000; i++) {
            log.seldom("address " + i, "from everywhere");
        }
        assertEquals(ServerLog.LINES_ABOUT_ALL, lines.size());
        log.say("of a worker");
        now.addAndGet(ServerLog.WINDOW_NANOS);
        log.tick();
        assertEquals(ServerLog.LINES_ABOUT_ALL + 2, lines.size());
        int leftOut = 1_000 + 1 + 100_000 - ServerLog.LINES_ABOUT_ALL;
        assertTrue(lines.get(lines.size() - 1).contains(leftOut + " more lines"), lines.get(lines.size() - 1));
        log.seldom("10.0.0.1", "again");
        assertEquals("again", lines.get(lines.size() - 1));
    }

    /** Has no files for a while, then gives a connection, then is closed. */
    private static final class Shortage implements Acceptor.Door {
        int asked;

        @Override
        public Socket accept() throws IOException {
            asked++;
            if (asked <= 50 || asked > 51) {
                throw new SocketException("Too many open files");
            }
            return new Socket();
        }

        @Override
        public void close() {
            asked = Integer.MAX_VALUE / 2;
        }
    }

    @Test
    void whereFilesRunOutItMakesRoomPausesAndGoesOn() throws IOException {
        List<String> lines = new ArrayList<>();
        List<Long> pauses = new ArrayList<>();
        int[] room = new int[1];
        Shortage shortage = new Shortage();
        Acceptor acceptor = new Acceptor(shortage, 1, new ServerLog(lines::add, System::nanoTime), pauses::add);
        acceptor.accept(
                socket -> {
                    try {
                        acceptor.close();
                    } catch (IOException e) {
                        throw new AssertionError(e);
                    }
                },
                () -> room[0]++);
        assertEquals(50, pauses.size());
        assertEquals(50, room[0]);
        assertEquals(Acceptor.FIRST_PAUSE_MILLIS, pauses.get(0));
        assertEquals(Acceptor.LONGEST_PAUSE_MILLIS, pauses.get(49));
        assertEquals(
                List.of("no connection can be taken for now: Too many open files", "connections are taken again"),
                lines);
        assertFalse(shortage.asked < 51);
    }
}
