package enlightenment.mesh;

import static enlightenment.mesh.SmallMeshFiles.HALVES;
import static enlightenment.mesh.SmallMeshFiles.SQUARE;
import static enlightenment.mesh.SmallMeshFiles.little;
import static enlightenment.mesh.SmallMeshFiles.mesh;
import static enlightenment.mesh.SmallMeshFiles.problem;
import static enlightenment.mesh.SmallMeshFiles.serialized;
import static enlightenment.mesh.SmallMeshFiles.shape;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.math.Vec3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SerializedReaderTest {
    private static final float[] NORMALS = {0, 0, 1, 0, 0, 2, 0, 1, 0, 1, 0, 0};
    private static final float[] UV = {0, 0, 1, 0, 1, 1, 0, 1};

    @TempDir
    Path folder;

    /** The square in the form of versions 3 and 4. */
    private static byte[] square(int version, int flags) {
        boolean isDouble = (flags & 0x2000) != 0;
        List<Object> all = new ArrayList<>(List.of(flags));
        if (version == 4) {
            all.add("my square\0");
        }
        all.addAll(List.of(4L, 2L));
        add(all, SQUARE, isDouble);
        add(all, (flags & 1) != 0 ? NORMALS : new float[0], isDouble);
        add(all, (flags & 2) != 0 ? UV : new float[0], isDouble);
        add(all, (flags & 8) != 0 ? new float[12] : new float[0], isDouble);
        Arrays.stream(HALVES).forEach(all::add);
        return little(all.toArray());
    }

    private static void add(List<Object> all, float[] values, boolean areDoubles) {
        for (float value : values) {
            all.add(areDoubles ? (Object) (double) value : (Object) value);
        }
    }

    @Test
    void eachCombinationOfFlagsIsRead() throws IOException {
        for (int version = 3; version <= 4; version++) {
            for (int flags = 0; flags < 64; flags++) {
                int precision = (flags & 32) != 0 ? 0x2000 : 0x1000;
                int content = flags & 0x1b;
                TriangleMesh expected = TriangleMesh.of(SQUARE, HALVES);
                expected = (flags & 0x11) == 1 ? expected.withNormals(NORMALS) : expected;
                expected = (flags & 2) != 0 ? expected.withUv(UV) : expected;
                TriangleMesh read = mesh(serialized(version, square(version, content | precision)), "a");
                assertEquals(expected, read);
                assertEquals(expected.hasNormals(), read.hasNormals());
            }
        }
    }

    @Test
    void doublesAreKept() throws IOException {
        byte[] shape = little(0x2000, 3L, 1L, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0, 1, 2);
        TriangleMesh read = mesh(serialized(3, shape), "a.serialized");
        assertFalse(read.isOfFloats());
        assertEquals(new Vec3(0.1, 0, 0), read.position(0));
    }

    @Test
    void packedRecordsOfVersion5AreRead() throws IOException {
        List<Object> all = new ArrayList<>(List.of(0x1005, 9, "my square", 4L, 2L, 4L, 0L));
        for (int v = 0; v < 4; v++) {
            for (int lane = 0; lane < 8; lane++) {
                all.add(lane < 3 ? SQUARE[3 * v + lane] : lane < 6 ? NORMALS[3 * v + lane - 3] : UV[2 * v + lane - 6]);
            }
        }
        all.addAll(List.of(0, 1, 2, 7, 0, 2, 3, 7, 0, 1, 2, 3, 0));
        TriangleMesh square = TriangleMesh.of(SQUARE, HALVES);
        assertEquals(square.withNormals(NORMALS).withUv(UV), mesh(serialized(5, little(all.toArray())), "a"));
        all.set(0, 0x1010);
        assertEquals(square, mesh(serialized(5, little(all.toArray())), "a"));
        all.set(0, 5);
        assertEquals(
                "shape 0 has numbers that are no floats, which version 5 does not have",
                problem(serialized(5, little(all.toArray())), "a"));
        all.set(0, 0x1003);
        assertEquals(
                "shape 0 has tangents, whose encoding cannot be read",
                problem(serialized(5, little(all.toArray())), "a"));
    }

    @Test
    void shapesArePartsInTheOrderOfTheFileAndAreFoundByTheirNumber() throws IOException {
        byte[] three = serialized(4, shape(1), shape(2), shape(3));
        List<MeshFiles.Part> parts = MeshFiles.read(three, "a.serialized", 3);
        assertEquals(3, parts.size());
        Path file = folder.resolve("a.serialized");
        Files.write(file, three);
        for (int i = 0; i < 3; i++) {
            assertEquals(i + 1, parts.get(i).mesh().coordinate(1, 0));
            assertEquals(parts.get(i), MeshFiles.readShape(file, i, 1));
        }
        for (int none : new int[] {-1, 3}) {
            IOException refused = assertThrows(IOException.class, () -> MeshFiles.readShape(file, none, 1));
            assertEquals(file + ": has no shape " + none + "; there are 3 from 0", refused.getMessage());
        }
        IOException tooMany = assertThrows(IOException.class, () -> MeshFiles.read(three, "a", 2));
        assertEquals("a: shape 2 has 1 triangles; there may be 1 to 0", tooMany.getMessage());
    }

    @Test
    void brokenShapesAreRefusedWithTheirNumber() {
        byte[] good = shape(1);
        byte[] many = little(0x1000, "a\0", 200_000_000L, 1L, 0f);
        Object[][] cases = {
            {
                little(0x1000, "a\0", 3L, 1L, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f, 0, 1, 3),
                "shape 1, triangle 0 has the vertex 3; there are 3 from 0"
            },
            {
                little(0x1000, "a\0", 3L, 1L, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f, 0, 1, -1),
                "shape 1, triangle 0 has the vertex 4294967295; there are 3 from 0"
            },
            {
                little(0x1000, "a\0", 3L, 1L, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f, 0, 1),
                "shape 1 is incomplete: the data end there"
            },
            {little(0x1000, "a\0", 3L, -1L), "shape 1 has 18446744073709551615 triangles; there may be 1 to 99999999"},
            {little(0x1000, "a\0", 0L, 1L), "shape 1 has 0 vertices; there may be 1 to 715827861"},
            {many, "shape 1 has 200000000 vertices by its header, which is more than its data can hold"},
            {little(0x1000, "a".repeat(5000), 0L), "shape 1 has a name of more than 4096 bytes"},
            {shape(0), "shape 1 has no triangle with an area"},
            {shape(Float.NaN), "positions: vertex 1 has a coordinate that is not finite: NaN"},
        };
        for (Object[] c : cases) {
            assertEquals(c[1], problem(serialized(4, good, (byte[]) c[0]), "a.serialized"));
        }
    }

    @Test
    void brokenFilesAreRefused() {
        byte[] good = serialized(4, shape(1));
        byte[] version = good.clone();
        version[2] = 6;
        assertEquals("shape 0 has the version 6; 3, 4 and 5 can be read", problem(version, "a"));
        byte[] count = good.clone();
        count[count.length - 2] = 1;
        assertEquals("has 65537 shapes by its last four bytes, which is more than the file holds", problem(count, "a"));
        byte[] none = good.clone();
        none[none.length - 4] = 0;
        assertEquals("has 0 shapes by its last four bytes, which is too few", problem(none, "a"));
        byte[] offset = good.clone();
        offset[offset.length - 12] = 1;
        assertEquals("shape 0 begins at byte 1, where the table of shapes may not have it", problem(offset, "a"));
        byte[] zlib = good.clone();
        zlib[4] ^= 1;
        assertEquals("shape 0 is broken: its compressed data cannot be inflated", problem(zlib, "a"));
        assertEquals("is too short for a .serialized file: 5 bytes", problem(Arrays.copyOf(good, 5), "a"));
        assertEquals(
                "shape 0 begins with 0x706c where 0x41c is expected".replace("706c", "6c70"),
                problem("ply\n" + "x".repeat(30), "a.serialized"));
    }

    @Test
    void memoryIsTakenAsDataComeAndNotAsTheyAreClaimed() {
        // Noise does not compress: 32 KiB could inflate to 2 million vertices, and do not.
        byte[] noise = new byte[1 << 15];
        new Random(1).nextBytes(noise);
        byte[] shape = little(0x1000, "a\0", 2_000_000L, 1L, noise);
        assertEquals("shape 0 is incomplete: the data end there", problem(serialized(4, shape), "a"));
    }
}
