package enlightenment.mesh;

import static enlightenment.mesh.MutatedFiles.mutated;
import static enlightenment.mesh.SmallMeshFiles.HALVES;
import static enlightenment.mesh.SmallMeshFiles.SQUARE;
import static enlightenment.mesh.SmallMeshFiles.bytes;
import static enlightenment.mesh.SmallMeshFiles.little;
import static enlightenment.mesh.SmallMeshFiles.problem;
import static enlightenment.mesh.SmallMeshFiles.serialized;
import static enlightenment.mesh.SmallMeshFiles.shape;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeshFilesTest {
    private static final String OBJ =
            "mtllib a.mtl\nv 0 0 0\nv 1.5 0 0\nv 1 1e0 0\nv 0 1 -.25\nvt 0 1\nvt 1 0\nvn 0 0 1\n"
                    + "f 1/1/1 2/2/1 3/1/1 -1/1/1\nusemtl red\nf 1 2 \\\n3\nf 1//1 3//1 4//1\n";
    private static final String PLY = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty double y\n"
            + "property float z\nproperty int flag\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
            + "0 0 0 7\n1 0 0 8\n1 1 0 9\n0 1 0 -1\n4 0 1 2 3\n3 0 1 2\n";
    private static final String STL =
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                    + "endloop\nendfacet\nendsolid\n";

    @TempDir
    Path folder;

    private static byte[] binaryPly() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        TriangleMesh square = TriangleMesh.of(SQUARE, HALVES);
        MeshFiles.writePly(square.withUv(new float[8]).withNormals(SQUARE), out);
        return out.toByteArray();
    }

    private static byte[] packed() {
        Object[] all = new Object[7 + 24 + 4 + 1];
        Arrays.fill(all, 0f);
        System.arraycopy(new Object[] {0x1005, 1, "a", 3L, 1L, 0L, 0L}, 0, all, 0, 7);
        all[7 + 8] = 1f;
        all[7 + 17] = 1f;
        System.arraycopy(new Object[] {0, 1, 2, 0, 0}, 0, all, 31, 5);
        return little(all);
    }

    private static List<byte[]> files() throws IOException {
        return List.of(
                bytes(OBJ),
                bytes(PLY),
                bytes(STL),
                binaryPly(),
                SmallMeshFiles.binaryStl(0, 0, 0, 1, 0, 0, 0, 1, 0),
                serialized(4, shape(1), shape(2)),
                serialized(
                        3, little(0x2001, 3L, 1L, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, new byte[72], 0, 1, 2)),
                serialized(5, packed()));
    }

    private static final List<String> NAMES =
            List.of("a.obj", "a.ply", "a.stl", "a.ply", "a.stl", "a.serialized", "a.serialized", "a.serialized");

    @Test
    void theContentSaysWhichFormatItIs() throws IOException {
        List<byte[]> files = files();
        for (int i = 0; i < files.size(); i++) {
            List<MeshFiles.Part> parts = MeshFiles.read(files.get(i), NAMES.get(i), 10);
            assertEquals(parts, MeshFiles.read(files.get(i), i == 0 ? "b.OBJ" : "model", 10));
            Path file = folder.resolve(NAMES.get(i));
            Files.write(file, files.get(i));
            assertEquals(parts, MeshFiles.read(file, 10));
        }
        assertEquals(
                "is no PLY, STL or .serialized file, and not named .obj: it begins with \"mtllib a.mtl?v 0\"",
                problem(OBJ, "model"));
        assertEquals(
                "is no PLY, STL or .serialized file, and not named .obj: it begins with \"\"", problem("", "model"));
    }

    @Test
    void compressedFilesAndOtherEncodingsAreCalledWhatTheyAre() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream zip = new GZIPOutputStream(out)) {
            zip.write(bytes(PLY));
        }
        assertEquals(
                "is compressed by gzip; a mesh is read from what gunzip makes of it",
                problem(out.toByteArray(), "a.ply.gz"));
        for (Charset wide : List.of(StandardCharsets.UTF_16BE, StandardCharsets.UTF_16LE)) {
            assertEquals(
                    "is text of UTF-16, by the mark at its start; UTF-8 is expected",
                    problem(("\ufeff" + OBJ).getBytes(wide), "a.obj"));
        }
    }

    @Test
    void filesThatCannotBeOpenedAreNamed() {
        Path none = folder.resolve("none.ply");
        assertTrue(assertThrows(IOException.class, () -> MeshFiles.read(none, 1))
                .getMessage()
                .startsWith(none.toString()));
        assertEquals(
                folder + ": it is a folder",
                assertThrows(IOException.class, () -> MeshFiles.read(folder, 1)).getMessage());
    }

    @Test
    void messagesAreOneHarmlessLine() {
        String problem = problem(OBJ.replace("f 1 2", "f x\u00c2\u0085\u001b[31m 2"), "a.obj");
        assertEquals("line 11: has \"x?\" where an integer is expected", problem);
        assertTrue(problem(PLY.replace("element face", "element x\u001b[0m"), "a.ply")
                .chars()
                .noneMatch(c -> c < ' '));
    }

    @Test
    void cutFilesAreRefusedOrWhole() throws IOException {
        List<byte[]> files = files();
        for (int i = 0; i < files.size(); i++) {
            boolean isText = i < 3;
            for (int length = 0; length < files.get(i).length; length++) {
                byte[] cut = Arrays.copyOf(files.get(i), length);
                boolean isRefused = isRefused(cut, NAMES.get(i));
                assertTrue(isRefused || isText, NAMES.get(i) + " cut to " + length);
            }
        }
    }

    /** Reads what may be broken: any other exception than an IOException with one line fails the test. */
    private static boolean isRefused(byte[] content, String name) {
        try {
            assertFalse(MeshFiles.read(content, name, 1000).isEmpty());
            return false;
        } catch (IOException e) {
            assertTrue(e.getMessage().startsWith(name + ": "), e.getMessage());
            assertTrue(e.getMessage().length() < 300 && e.getMessage().indexOf('\n') < 0, e.getMessage());
            return true;
        }
    }

    @Test
    void mutatedFilesAreReadOrRefused() throws IOException {
        List<byte[]> files = files();
        int[] refused = new int[files.size()];
        assertTimeoutPreemptively(Duration.ofMinutes(2), () -> {
            Random random = new Random(20);
            for (int i = 0; i < 16_000; i++) {
                int which = i % files.size();
                byte[] content = mutated(files.get(which), random);
                refused[which] += isRefused(content, NAMES.get(which)) ? 1 : 0;
            }
        });
        for (int n : refused) {
            assertTrue(n > 100 && n < 2000, Arrays.toString(refused));
        }
    }

    @Test
    void mutatedShapesAreReadOrRefusedBehindTheirCompression() throws IOException {
        byte[] plain = shape(1);
        byte[] packed = packed();
        Random random = new Random(21);
        int refused = 0;
        for (int i = 0; i < 4000; i++) {
            byte[] content = i % 2 == 0
                    ? serialized(i % 4 == 0 ? 4 : 3, mutated(plain, random))
                    : serialized(5, mutated(packed, random));
            refused += isRefused(content, "a.serialized") ? 1 : 0;
        }
        assertTrue(refused > 1000 && refused < 4000, refused + " were refused");
    }
}
