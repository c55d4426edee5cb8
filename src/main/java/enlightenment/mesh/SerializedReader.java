package enlightenment.mesh;

import enlightenment.mesh.data.VertexArrays;
import enlightenment.mesh.input.BinaryInput;
import enlightenment.mesh.input.MeshSource;
import java.io.ByteArrayInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.InflaterInputStream;

/**
 * Reads Mitsuba's {@code .serialized} files, versions 3, 4 and 5, one shape after the other or a single one. The layout is the one that the
 * documentation of Mitsuba's plugin describes: a header, a zlib stream for each shape, and their offsets at the end of the file. Colours and
 * attributes are ignored.
 */
final class SerializedReader {
    private static final int MAGIC = 0x041C;
    private static final int NORMALS = 1;
    private static final int UV = 2;
    private static final int COLORS = 8;
    private static final int FACE_NORMALS = 0x10;
    private static final int FLOATS = 0x1000;
    private static final int DOUBLES = 0x2000;

    /** Flags of version 5. */
    private static final int TANGENTS = 2;

    private static final int PACKED_UV = 4;

    /** The most bytes that deflate makes of one. */
    private static final long MOST_INFLATED = 1032;

    /** The fewest bytes of a shape: magic, version, and a zlib stream of nothing. */
    private static final int LEAST_SHAPE = 12;

    private static final int LONGEST_NAME = 1 << 12;

    private final MeshSource source;
    private final long maxTriangles;
    private int version;
    private long[] offsets;
    private int shape;
    private String element = "";
    private long triangles;
    private BinaryInput in;

    private SerializedReader(MeshSource source, long maxTriangles) throws IOException {
        this.source = source;
        this.maxTriangles = maxTriangles;
        readOffsets();
    }

    static boolean isSerialized(byte[] start) {
        return start.length >= 2 && start[0] == (byte) MAGIC && start[1] == MAGIC >> 8;
    }

    static List<MeshFiles.Part> read(MeshSource source, long maxTriangles) throws IOException {
        SerializedReader reader = new SerializedReader(source, maxTriangles);
        List<MeshFiles.Part> parts = new ArrayList<>();
        for (int i = 0; i < reader.offsets.length - 1; i++) {
            parts.add(reader.part(i));
        }
        return parts;
    }

    static MeshFiles.Part read(MeshSource source, int shape, long maxTriangles) throws IOException {
        SerializedReader reader = new SerializedReader(source, maxTriangles);
        int shapes = reader.offsets.length - 1;
        if (shape < 0 || shape >= shapes) {
            throw source.failure("has no shape " + shape + "; there are " + shapes + " from 0");
        }
        return reader.part(shape);
    }

    private String place() {
        return "shape " + shape + element;
    }

    /** Reads the table at the end of the file; where it begins is the last of the offsets. */
    private void readOffsets() throws IOException {
        if (source.size < LEAST_SHAPE + 8) {
            throw source.failure("is too short for a .serialized file: " + source.size + " bytes");
        }
        try (InputStream stream = source.open(0)) {
            version = version(input(stream, 4));
        }
        long count;
        try (InputStream stream = source.open(source.size - 4)) {
            count = input(stream, 4).int32() & 0xffffffffL;
        }
        int width = version == 3 ? 4 : 8;
        if (count == 0 || count > (source.size - 4) / (LEAST_SHAPE + width)) {
            throw source.failure("has " + count + " shapes by its last four bytes, which is "
                    + (count == 0 ? "too few" : "more than the file holds"));
        }
        long table = source.size - 4 - width * count;
        offsets = new long[(int) count + 1];
        try (InputStream stream = source.open(table)) {
            BinaryInput numbers = input(stream, width * count);
            for (int i = 0; i < count; i++) {
                offsets[i] = version == 3 ? numbers.int32() & 0xffffffffL : numbers.int64();
            }
        }
        offsets[(int) count] = table;
        for (shape = 0; shape < count; shape++) {
            boolean isRight = shape == 0 ? offsets[0] == 0 : offsets[shape] >= offsets[shape - 1] + LEAST_SHAPE;
            if (!isRight || offsets[shape] > table - LEAST_SHAPE) {
                throw source.failure(
                        place() + " begins at byte " + offsets[shape] + ", where the table of shapes may not have it");
            }
        }
    }

    private BinaryInput input(InputStream stream, long size) {
        return new BinaryInput(source, stream, size, ByteOrder.LITTLE_ENDIAN, this::place);
    }

    private int version(BinaryInput header) throws IOException {
        int magic = header.int16() & 0xffff;
        int found = header.int16() & 0xffff;
        if (magic != MAGIC) {
            throw header.failure("begins with 0x" + Integer.toHexString(magic) + " where 0x41c is expected");
        }
        if (found < 3 || found > 5) {
            throw header.failure("has the version " + found + "; 3, 4 and 5 can be read");
        }
        return found;
    }

    private MeshFiles.Part part(int number) throws IOException {
        shape = number;
        element = "";
        long size = offsets[number + 1] - offsets[number];
        try (InputStream stream = new Piece(source.open(offsets[number]), size)) {
            byte[] header = stream.readNBytes(4);
            if (version(input(new ByteArrayInputStream(header), 4)) != version) {
                throw source.failure(place() + " has another version than the first");
            }
            try (InflaterInputStream inflated = new InflaterInputStream(stream)) {
                in = input(inflated, MOST_INFLATED * (size - 4));
                MeshMaking making = version == 5 ? this::packed : this::arrays;
                TriangleMesh mesh =
                        making.withArea(source).orElseThrow(() -> in.failure("has no triangle with an area"));
                return new MeshFiles.Part("", mesh);
            }
        }
    }

    /** Versions 3 and 4: an array for each quantity. */
    private TriangleMesh arrays() throws IOException {
        int flags = in.int32();
        if (version == 4) {
            skipTerminated();
        }
        boolean isDouble = (flags & DOUBLES) != 0;
        int width = isDouble ? 8 : 4;
        boolean hasNormals = (flags & NORMALS) != 0;
        boolean hasUv = (flags & UV) != 0;
        boolean hasColors = (flags & COLORS) != 0;
        int numbers = 3 + (hasNormals ? 3 : 0) + (hasUv ? 2 : 0) + (hasColors ? 3 : 0);
        int vertices = count("vertices", Floats.LONGEST / 3, numbers * width);
        int faces = count("triangles", Math.min(Floats.LONGEST / 3, maxTriangles - triangles), 12);
        float[] positions = isDouble ? null : floats(3 * vertices, false);
        double[] longPositions = isDouble ? doubles(3 * vertices) : null;
        float[] normals = null;
        if (hasNormals && (flags & FACE_NORMALS) == 0) {
            normals = floats(3 * vertices, isDouble);
        } else if (hasNormals) {
            in.skip(3L * width * vertices);
        }
        float[] uv = hasUv ? floats(2 * vertices, isDouble) : null;
        in.skip(hasColors ? 3L * width * vertices : 0);
        int[] indices = indices(faces, vertices, false);
        VertexArrays read =
                isDouble ? VertexArrays.of(longPositions, normals, uv) : new VertexArrays(positions, null, normals, uv);
        return new TriangleMesh(read, indices);
    }

    /** Version 5: records of 8 floats for each vertex and 4 integers for each triangle. What follows them is not needed. */
    private TriangleMesh packed() throws IOException {
        int flags = in.int32();
        long length = in.int32() & 0xffffffffL;
        if (length > LONGEST_NAME) {
            throw in.failure("has a name of " + length + " bytes; there may be at most " + LONGEST_NAME);
        }
        in.skip(length);
        if ((flags & FLOATS) == 0) {
            throw in.failure("has numbers that are no floats, which version 5 does not have");
        }
        if ((flags & TANGENTS) != 0) {
            throw in.failure("has tangents, whose encoding cannot be read");
        }
        int vertices = count("vertices", Floats.LONGEST / 3, 8 * 4);
        int faces = count("triangles", Math.min(Floats.LONGEST / 3, maxTriangles - triangles), 4 * 4);
        in.skip(16);
        boolean hasNormals = (flags & NORMALS) != 0 && (flags & FACE_NORMALS) == 0;
        Floats positions = new Floats(12);
        Floats normals = new Floats(hasNormals ? 12 : 0);
        Floats uv = new Floats((flags & PACKED_UV) != 0 ? 8 : 0);
        for (int v = 0; v < vertices; v++) {
            for (int lane = 0; lane < 8; lane++) {
                float value = in.float32();
                if (lane < 3) {
                    positions.add(value);
                } else if (lane < 6 && hasNormals) {
                    normals.add(value);
                } else if (lane >= 6 && (flags & PACKED_UV) != 0) {
                    uv.add(value);
                }
            }
        }
        int[] indices = indices(faces, vertices, true);
        VertexArrays read = new VertexArrays(
                positions.toArray(),
                null,
                hasNormals ? normals.toArray() : null,
                (flags & PACKED_UV) != 0 ? uv.toArray() : null);
        return new TriangleMesh(read, indices);
    }

    private void skipTerminated() throws IOException {
        for (int i = 0; in.uint8() != 0; i++) {
            if (i == LONGEST_NAME) {
                throw in.failure("has a name of more than " + LONGEST_NAME + " bytes");
            }
        }
    }

    /** A count of elements of some bytes each, which the rest of the data can hold. */
    private int count(String what, long most, int each) throws IOException {
        long n = in.int64();
        if (n <= 0 || n > most) {
            throw in.failure("has " + Long.toUnsignedString(n) + " " + what + "; there may be 1 to " + most);
        }
        if (n > in.left() / each) {
            throw in.failure("has " + n + " " + what + " by its header, which is more than its data can hold");
        }
        return (int) n;
    }

    /** The next numbers, rounded to floats; memory is taken as they come. */
    private float[] floats(int n, boolean areDoubles) throws IOException {
        float[] all = new float[Math.min(n, 1 << 16)];
        for (int i = 0; i < n; i++) {
            if (i == all.length) {
                all = Arrays.copyOf(all, (int) Math.min(n, 2L * i));
            }
            all[i] = areDoubles ? (float) in.float64() : in.float32();
        }
        return all;
    }

    private double[] doubles(int n) throws IOException {
        double[] all = new double[Math.min(n, 1 << 16)];
        for (int i = 0; i < n; i++) {
            if (i == all.length) {
                all = Arrays.copyOf(all, (int) Math.min(n, 2L * i));
            }
            all[i] = in.float64();
        }
        return all;
    }

    private int[] indices(int faces, int vertices, boolean arePacked) throws IOException {
        Ints all = new Ints(12);
        for (int t = 0; t < faces; t++) {
            for (int k = 0; k < 3; k++) {
                int v = in.int32();
                if (v < 0 || v >= vertices) {
                    element = ", triangle " + t;
                    throw in.failure(
                            "has the vertex " + Integer.toUnsignedString(v) + "; there are " + vertices + " from 0");
                }
                all.add(v);
            }
            in.skip(arePacked ? 4 : 0);
        }
        triangles += faces;
        return all.toArray();
    }

    /** A stream of the first bytes of another, which it closes. */
    private static final class Piece extends FilterInputStream {
        private long left;

        Piece(InputStream in, long size) {
            super(in);
            left = size;
        }

        @Override
        public int read() throws IOException {
            left--;
            return left < 0 ? -1 : in.read();
        }

        @Override
        public int read(byte[] to, int from, int length) throws IOException {
            int n = left <= 0 ? -1 : in.read(to, from, (int) Math.min(length, left));
            left -= Math.max(n, 0);
            return n;
        }
    }
}
