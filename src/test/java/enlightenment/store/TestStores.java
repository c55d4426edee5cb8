package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.film.SampleLog;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.Map;
import java.util.Random;

/** Stores of made up results, for tests. */
final class TestStores {
    static final String ID = "a".repeat(64);
    static final byte[] SCENE = "{}".getBytes(StandardCharsets.UTF_8);
    static final byte[] PLAN = {1, 2, 3};

    private TestStores() {}

    static StoreAddress at(Path file) {
        return StoreAddress.of(file.toString());
    }

    static StoreArchive open(StoreAddress address, StoreLogin login, String id, StoredSamples samples)
            throws IOException {
        RenderRow row = RenderRow.now(id, "a scene", "as it is", "0", 40, 30);
        return StoreArchive.open(
                address, login, new StoreArchive.Render(row, SCENE, n -> Map.of("Title", "a scene"), samples));
    }

    static StoreArchive open(Path file) throws IOException {
        return open(at(file), StoreLogin.NONE, ID, StoredSamples.NONE);
    }

    /** What a unit is worth: the same wherever it is made. */
    static byte[] result(int unit) {
        byte[] bytes = new byte[100 + unit % 1000];
        new Random(unit).nextBytes(bytes);
        return ByteBuffer.wrap(bytes).putLong(unit).putLong(bytes.length).array();
    }

    /** Samples of a unit. */
    static byte[] samples(int unit) {
        SampleLog log = new SampleLog(false, 40, (kind, count, bytes) -> LAST.set(bytes));
        for (int i = 0; i < unit % 50; i++) {
            log.add(i % 40, unit % 30, i / 50.0, 0.5, new double[] {unit, i, 1});
        }
        log.flush();
        return LAST.get();
    }

    private static final ThreadLocal<byte[]> LAST = new ThreadLocal<>();

    /** Fails unless these units, and no others, are in the store as they should be, each with its samples. */
    static void assertHolds(StoreAddress address, StoreLogin login, int from, int to) throws IOException {
        try (StoreArchive archive = open(address, login, ID, StoredSamples.PIXELS)) {
            BitSet there = new BitSet();
            archive.replay(0, (unit, bytes) -> {
                assertArrayEquals(result(unit), bytes);
                there.set(unit);
            });
            assertEquals(0, archive.damaged());
            BitSet expected = new BitSet();
            expected.set(from, to);
            assertEquals(expected, there);
        }
        try (SampleStore store = SampleStore.open(address, login)) {
            Blocks blocks = new Blocks(store.database(), ID, 0);
            BitSet there = new BitSet();
            blocks.read(0, (unit, block) -> {
                there.set(unit);
                assertEquals(unit % 50, block.size());
                for (int i = 0; i < block.size(); i++) {
                    assertEquals(unit % 30 * 40 + i % 40, block.pixel(i));
                    assertEquals(unit, block.number(i, 2));
                    assertEquals(i, block.number(i, 3));
                }
            });
            assertEquals(0, blocks.damaged());
            assertEquals(to - from, there.cardinality());
        }
    }
}
