package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;
import enlightenment.mesh.input.BinaryInput;
import enlightenment.mesh.input.MeshSource;
import enlightenment.mesh.input.TextInput;
import enlightenment.text.Plain;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;

/**
 * Reads STL files, binary and ascii. Numbers are floats, in the ascii form correctly rounded. Vertices in one place become one, where -0 is 0:
 * the format has no others that are shared. Normals are ignored; they follow from the order of the corners.
 */
final class StlReader {
    private static final int HEADER = 84;
    private static final int FACET = 50;

    private final MeshSource source;
    private final long maxTriangles;
    private final VertexTable places = new VertexTable();
    private final Ints indices = new Ints(12);

    private StlReader(MeshSource source, long maxTriangles) {
        this.source = source;
        this.maxTriangles = maxTriangles;
    }

    /** Whether the size is what a binary file has by its count of triangles: many of them begin with {@code solid} too. */
    static boolean isBinary(MeshSource source, byte[] start) {
        return start.length >= HEADER && source.size == HEADER + FACET * count(start);
    }

    private static long count(byte[] start) {
        return ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt(HEADER - 4) & 0xffffffffL;
    }

    static TriangleMesh read(MeshSource source, byte[] start, long maxTriangles) throws IOException {
        StlReader reader = new StlReader(source, maxTriangles);
        boolean isBinary = isBinary(source, start);
        try (InputStream in = source.open(isBinary ? HEADER : 0)) {
            if (isBinary) {
                reader.readBinary(in, count(start));
            } else {
                reader.readAscii(new TextInput(source, in, 1));
            }
        }
        return reader.mesh();
    }

    private void readBinary(InputStream stream, long count) throws IOException {
        if (count > maxTriangles) {
            throw source.failure("has " + count + " triangles, which exceeds the limit of " + maxTriangles);
        }
        long[] triangle = new long[1];
        BinaryInput in = new BinaryInput(
                source, stream, FACET * count, ByteOrder.LITTLE_ENDIAN, () -> "triangle " + triangle[0]);
        for (; triangle[0] < count; triangle[0]++) {
            in.skip(12);
            for (int k = 0; k < 3; k++) {
                float x = in.float32();
                float y = in.float32();
                float z = in.float32();
                if (!Float.isFinite(x) || !Float.isFinite(y) || !Float.isFinite(z)) {
                    throw in.failure("has the corner (" + x + ", " + y + ", " + z + "), which is not finite");
                }
                corner(x, y, z);
            }
            in.skip(2);
        }
    }

    private void readAscii(TextInput in) throws IOException {
        int corners = 0;
        for (in.space(); !in.atEnd(); in.space()) {
            String word = in.word().toLowerCase(Locale.ROOT);
            switch (word) {
                case "solid", "endsolid" -> in.nextLine();
                case "facet", "outer", "loop", "endfacet" -> {}
                case "normal" -> skipNormal(in);
                case "vertex" -> {
                    in.blanks();
                    float x = in.floatNumber();
                    in.blanks();
                    float y = in.floatNumber();
                    in.blanks();
                    corner(x, y, in.floatNumber());
                    if (++corners > 3) {
                        throw in.failure("has a triangle of more than 3 corners");
                    }
                }
                case "endloop" -> {
                    if (corners != 3) {
                        throw in.failure("ends a triangle of " + corners + " corners");
                    }
                    corners = 0;
                    if (indices.size() / 3 > maxTriangles) {
                        throw in.failure("exceeds the limit of " + maxTriangles + " triangles");
                    }
                }
                default ->
                    throw in.failure(
                            "has a word that STL does not have: " + Plain.quoted(word.isEmpty() ? in.found() : word));
            }
        }
        if (corners != 0) {
            throw in.failure("ends in the middle of a triangle");
        }
    }

    /** Some programs write normals that are no numbers. */
    private static void skipNormal(TextInput in) throws IOException {
        for (int i = 0; i < 3; i++) {
            in.blanks();
            in.word();
        }
    }

    private void corner(float x, float y, float z) {
        indices.add(places.number(bits(x), bits(y), bits(z)));
    }

    private static int bits(float x) {
        return Float.floatToRawIntBits(x + 0f);
    }

    private TriangleMesh mesh() throws IOException {
        if (indices.size() == 0) {
            throw source.failure("has no triangles");
        }
        places.freeze();
        float[] positions = new float[3 * places.size()];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = Float.intBitsToFloat(places.part(i / 3, i % 3));
        }
        return new TriangleMesh(new VertexArrays(positions, null, null, null), indices.toArray());
    }
}
