package enlightenment.store;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
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

    static StoreArchive open(StoreAddress address, StoreLogin login, String id, int kind) throws IOException {
        RenderRow row = RenderRow.now(id, "a scene", "as it is", "0", 40, 30);
        return StoreArchive.open(address, login, row, SCENE, plan -> Map.of("Title", "a scene"), r -> r.length, kind);
    }

    static StoreArchive open(Path file) throws IOException {
        return open(at(file), StoreLogin.NONE, ID, -1);
    }

    /** What a unit is worth: the same wherever it is made. */
    static byte[] result(int unit) {
        byte[] bytes = new byte[100 + unit % 1000];
        new Random(unit).nextBytes(bytes);
        return ByteBuffer.wrap(bytes).putInt(unit).array();
    }
}
