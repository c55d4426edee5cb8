package enlightenment.mesh;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.DeflaterOutputStream;

/** Small files of meshes for tests, by hand, and how they are read. */
public final class SmallMeshFiles {
    /** The unit square as two triangles. */
    static final float[] SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

    static final int[] HALVES = {0, 1, 2, 0, 2, 3};

    private SmallMeshFiles() {}

    public static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    static TriangleMesh mesh(byte[] content, String name) throws IOException {
        List<MeshFiles.Part> parts = MeshFiles.read(content, name, MeshFiles.MAX_TRIANGLES);
        assertTrue(parts.size() == 1 && parts.get(0).material().isEmpty(), parts.toString());
        return parts.get(0).mesh();
    }

    static TriangleMesh mesh(String text, String name) throws IOException {
        return mesh(bytes(text), name);
    }

    /** Why a content is refused; the name and a colon are taken off. */
    static String problem(byte[] content, String name) {
        String message = assertThrows(IOException.class, () -> MeshFiles.read(content, name, MeshFiles.MAX_TRIANGLES))
                .getMessage();
        assertTrue(message.startsWith(name + ": "), message);
        return message.substring(name.length() + 2);
    }

    static String problem(String text, String name) {
        return problem(bytes(text), name);
    }

    /** Binary numbers one after the other: bytes, shorts, ints, longs, floats, doubles, and ASCII. */
    static byte[] numbers(ByteOrder order, Object... values) {
        ByteBuffer out = ByteBuffer.allocate(1 << 16).order(order);
        for (Object value : values) {
            if (value instanceof Byte b) {
                out.put(b);
            } else if (value instanceof Short s) {
                out.putShort(s);
            } else if (value instanceof Integer i) {
                out.putInt(i);
            } else if (value instanceof Long l) {
                out.putLong(l);
            } else if (value instanceof Float f) {
                out.putFloat(f);
            } else if (value instanceof Double d) {
                out.putDouble(d);
            } else if (value instanceof byte[] b) {
                out.put(b);
            } else {
                out.put(bytes((String) value));
            }
        }
        byte[] all = new byte[out.position()];
        out.flip().get(all);
        return all;
    }

    static byte[] little(Object... values) {
        return numbers(ByteOrder.LITTLE_ENDIAN, values);
    }

    static byte[] deflated(byte[] content) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (OutputStream zlib = new DeflaterOutputStream(out)) {
            zlib.write(content);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }

    /** A .serialized file of some shapes, which are compressed here. */
    static byte[] serialized(int version, byte[]... shapes) {
        List<Object> all = new ArrayList<>();
        List<Object> offsets = new ArrayList<>();
        long offset = 0;
        for (byte[] shape : shapes) {
            byte[] data = deflated(shape);
            all.add((short) 0x041C);
            all.add((short) version);
            all.add(data);
            offsets.add(version == 3 ? (Object) (int) offset : (Object) offset);
            offset += 4 + data.length;
        }
        all.addAll(offsets);
        all.add(shapes.length);
        return little(all.toArray());
    }

    /** A triangle as a shape of version 4. */
    static byte[] shape(float width) {
        return little(0x1000, "a\0", 3L, 1L, 0f, 0f, 0f, width, 0f, 0f, 0f, 1f, 0f, 0, 1, 2);
    }

    static byte[] binaryStl(float... corners) {
        List<Object> all = new ArrayList<>(List.of("solid".repeat(16), corners.length / 9));
        for (int i = 0; i < corners.length; i++) {
            if (i % 9 == 0) {
                all.addAll(List.of(9f, 9f, 9f));
            }
            all.add(corners[i]);
            if (i % 9 == 8) {
                all.add((short) 7);
            }
        }
        return little(all.toArray());
    }
}
