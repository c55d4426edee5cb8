package enlightenment.spark;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * What an executor gives back of a unit. As bytes: the process and its machine, then the tiles (number, nanoseconds, length,
 * bytes), most significant byte first; so no serializer that a cluster may be set to needs to know of it.
 */
record UnitResult(String machine, List<Tile> tiles) {
    /** A tile and how long it took. */
    record Tile(int tile, long nanos, byte[] bytes) {}

    /** Writes one. */
    static final class Writer {
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        private final DataOutputStream out = new DataOutputStream(bytes);

        Writer() throws IOException {
            out.writeUTF(org.apache.spark.SparkEnv.get().executorId() + "@"
                    + org.apache.spark.SparkEnv.get()
                            .blockManager()
                            .blockManagerId()
                            .host());
        }

        void add(int tile, byte[] content, long nanos) throws IOException {
            out.writeInt(tile);
            out.writeLong(nanos);
            out.writeInt(content.length);
            out.write(content);
        }

        byte[] finish() {
            return bytes.toByteArray();
        }
    }

    /**
     * Reads one.
     *
     * @throws IOException if it is cut short
     */
    static UnitResult read(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        String machine = in.readUTF();
        List<Tile> tiles = new ArrayList<>();
        while (in.available() > 0) {
            int tile = in.readInt();
            long nanos = in.readLong();
            byte[] content = new byte[Math.min(in.readInt(), in.available())];
            in.readFully(content);
            tiles.add(new Tile(tile, nanos, content));
        }
        return new UnitResult(machine, tiles);
    }
}
