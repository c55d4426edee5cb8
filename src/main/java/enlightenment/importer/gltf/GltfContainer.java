package enlightenment.importer.gltf;

import enlightenment.file.InputFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * A glTF file taken apart.
 *
 * @param document the JSON text
 * @param binary the buffer inside a GLB file; empty where there is none
 * @param isBinary whether it is a GLB file
 * @param size bytes of the file
 */
record GltfContainer(GltfElement document, ByteBuffer binary, boolean isBinary, long size) {
    private static final int MAGIC = 0x46546c67;
    private static final int JSON = 0x4e4f534a;
    private static final int BIN = 0x004e4942;
    private static final int HEADER = 12;
    private static final int CHUNK_HEADER = 8;

    /**
     * Reads a file; its first bytes tell whether it is a GLB file.
     *
     * @throws IOException if it is neither kind, or cut
     */
    static GltfContainer read(Path file) throws IOException {
        byte[] bytes = InputFile.bytes(file);
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.length >= 4 && in.getInt(0) == MAGIC) {
            return binary(bytes, in);
        }
        if (bytes.length == 0) {
            throw new IOException("is empty; expected a glTF file");
        }
        return new GltfContainer(GltfJson.parse(bytes), ByteBuffer.allocate(0), false, bytes.length);
    }

    private static GltfContainer binary(byte[] bytes, ByteBuffer in) throws IOException {
        if (bytes.length < HEADER + CHUNK_HEADER) {
            throw new IOException("is incomplete: a GLB file has 20 bytes at least, and this has " + bytes.length);
        }
        long version = Integer.toUnsignedLong(in.getInt(4));
        if (version != 2) {
            throw new IOException("is a GLB file of version " + version + "; only version 2 can be read");
        }
        long length = Integer.toUnsignedLong(in.getInt(8));
        if (length > bytes.length) {
            throw new IOException("is incomplete: its header says " + length + " bytes, and it has " + bytes.length);
        }
        byte[] text = null;
        ByteBuffer buffer = ByteBuffer.allocate(0);
        int chunk = 0;
        for (long at = HEADER; at + CHUNK_HEADER <= length; chunk++) {
            long size = Integer.toUnsignedLong(in.getInt((int) at));
            int type = in.getInt((int) at + 4);
            long start = at + CHUNK_HEADER;
            if (size > length - start) {
                throw new IOException("chunk " + chunk + ": is incomplete: it says " + size + " bytes, and "
                        + (length - start) + " are left");
            }
            if (chunk == 0 && type != JSON) {
                throw new IOException("chunk 0: must be the JSON text of the GLB file, and is not");
            } else if (chunk == 0) {
                text = Arrays.copyOfRange(bytes, (int) start, (int) (start + size));
            } else if (chunk == 1 && type == BIN) {
                buffer = in.slice((int) start, (int) size).order(ByteOrder.LITTLE_ENDIAN);
            }
            at = start + (size + 3) / 4 * 4;
        }
        return new GltfContainer(GltfJson.parse(text), buffer, true, bytes.length);
    }
}
