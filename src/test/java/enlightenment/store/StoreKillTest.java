package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a writer has said to be safe is there after it was killed, and whoever goes on finishes the same store. */
class StoreKillTest {
    private static final int UNITS = 4000;

    @TempDir
    private Path folder;

    @Test
    void nothingAcknowledgedIsLostAtTwoMoments() throws Exception {
        kill(2);
    }

    @Tag("full")
    @Test
    void nothingAcknowledgedIsLostAtTwentyMoments() throws Exception {
        kill(20);
    }

    @Tag("full")
    @Test
    void nothingAcknowledgedIsLostByH2AsItIsOpenedHere() throws Exception {
        kill(6, StoreAddress.of("jdbc:h2:" + folder.resolve("h")));
    }

    private void kill(int moments) throws Exception {
        kill(moments, TestStores.at(folder.resolve("s.db")));
    }

    private static void kill(int moments, StoreAddress address) throws Exception {
        Random random = new Random(7);
        int safe = -1;
        for (int k = 0; k < moments; k++) {
            Process writer = TestWriter.start(address, "", 0, UNITS, 1);
            safe = Math.max(TestWriter.lastSafe(writer, 1 + random.nextInt(20)), safe);
            writer.waitFor();
            assertTrue(safe >= 0);
            assertThere(address, safe);
        }
        Process last = TestWriter.start(address, "", 0, UNITS, 1);
        TestWriter.lastSafe(last, Integer.MAX_VALUE);
        assertEquals(0, last.waitFor());
        TestStores.assertHolds(address, StoreLogin.NONE, 0, UNITS);
    }

    private static void assertThere(StoreAddress address, int safe) throws Exception {
        BitSet there = new BitSet();
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.PIXELS)) {
            archive.replay(0, (unit, bytes) -> there.set(unit));
            assertEquals(0, archive.damaged());
        }
        assertTrue(there.nextClearBit(0) > safe, there.nextClearBit(0) + " is missing, up to " + safe + " is safe");
    }

    @Test
    void twoProcessesWriteToOneFileOneOfThemUpAndOneDownAndOneIsKilled() throws Exception {
        StoreAddress address = TestStores.at(folder.resolve("two.db"));
        Process up = TestWriter.start(address, "", 0, UNITS / 4, 1);
        Process down = TestWriter.start(address, "", UNITS / 4 - 1, -1, -1);
        int safe = TestWriter.lastSafe(down, 5);
        TestWriter.lastSafe(up, Integer.MAX_VALUE);
        assertEquals(0, up.waitFor());
        down.waitFor();
        assertTrue(safe > 0);
        TestStores.assertHolds(address, StoreLogin.NONE, 0, UNITS / 4);
    }
}
