package enlightenment.mesh;

import static enlightenment.mesh.SmallMeshFiles.HALVES;
import static enlightenment.mesh.SmallMeshFiles.SQUARE;
import static enlightenment.mesh.SmallMeshFiles.mesh;
import static enlightenment.mesh.SmallMeshFiles.numbers;
import static enlightenment.mesh.SmallMeshFiles.problem;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

class PlyReaderTest {
    private static final String VERTICES = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    private static final String FACES = "property list uchar int vertex_indices\nend_header\n";
    private static final String ASCII = "ply\nformat ascii 1.0\ncomment by hand\n" + VERTICES;
    private static final String CORNERS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    private static final String ONE_FACE = "element face 1\n" + FACES;

    private static TriangleMesh square() {
        return TriangleMesh.of(SQUARE, HALVES);
    }

    @Test
    void aPolygonOfTextIsAFan() throws IOException {
        assertEquals(square(), mesh(ASCII + ONE_FACE + CORNERS + "4 0 1 2 3\n", "a.ply"));
        assertEquals(square(), mesh(ASCII + ONE_FACE + CORNERS + "4 0 1 2 3", "no ending"));
    }

    @Test
    void linesMayEndWithCarriageReturns() throws IOException {
        String text = ASCII + ONE_FACE + CORNERS + "4 0 1 2 3\n";
        assertEquals(square(), mesh(text.replace("\n", "\r\n"), "a.ply"));
        assertEquals(square(), mesh(text.replace("\n", "\r"), "a.ply"));
    }

    @Test
    void bothOrdersOfBytesAreRead() throws IOException {
        for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
            String format = order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian";
            for (String lineEnd : new String[] {"\n", "\r\n", "\r"}) {
                String header = ("ply\nformat " + format + " 1.0\n" + VERTICES + ONE_FACE).replace("\n", lineEnd);
                byte[] file =
                        numbers(order, header, 0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f, (byte) 4, 0, 1, 2, 3);
                assertEquals(square(), mesh(file, "a.ply"));
            }
        }
    }

    @Test
    void eachTypeIsReadAndTheUnknownIsSkipped() throws IOException {
        String header =
                "ply\nformat binary_big_endian 1.0\nelement camera 2\nproperty double f\nproperty list int8 short l\n"
                        + "element face 1\nproperty list uchar float texcoord\nproperty list ushort uint vertex_index\n"
                        + "property uchar flag\nelement vertex 4\nproperty char x\nproperty list uchar uchar more\n"
                        + "property uint16 y\nproperty double z\nproperty uint8 red\nelement edge 1\nproperty int a\nend_header\n";
        byte[] cameras = numbers(ByteOrder.BIG_ENDIAN, 1.5, (byte) 1, (short) 5, 2.5, (byte) 0);
        byte[] face = numbers(ByteOrder.BIG_ENDIAN, (byte) 1, 0.5f, (short) 4, 0, 1, 2, 3, (byte) 9);
        byte[] file = numbers(
                ByteOrder.BIG_ENDIAN,
                header,
                cameras,
                face,
                new byte[] {-1, 0, 0, 0},
                0.25,
                new byte[] {1, 1, 2, 7, 8, 0, 0},
                0.25,
                new byte[] {1, 1, 0, -1, -1},
                0.25,
                new byte[] {1, -1, 0, -1, -1},
                0.1,
                (byte) 1,
                7);
        TriangleMesh read = mesh(file, "a.ply");
        assertEquals(new Vec3(-1, 0, 0.25), read.position(0));
        assertEquals(new Vec3(1, 0, 0.25), read.position(1));
        assertEquals(new Vec3(-1, 65535, 0.1), read.position(3));
        assertFalse(read.isOfFloats());
        assertEquals(2, read.triangles());
    }

    @Test
    void floatsInTextAreRoundedOnceAndDoublesAreKept() throws IOException {
        String corners = "0.1 0 0\n1 0 0\n1 1 0\n0 1.00000005960464477540 0\n";
        TriangleMesh floats = mesh(ASCII + ONE_FACE + corners + "4 0 1 2 3\n", "a.ply");
        assertTrue(floats.isOfFloats());
        assertEquals(0.1f, floats.coordinate(0, 0));
        // Just above 1 + 2^-24, halfway between floats: twice rounded it would be 1.
        assertEquals(1 + 0x1p-23, floats.coordinate(3, 1));
        TriangleMesh doubles = mesh((ASCII + ONE_FACE).replace("float", "double") + corners + "4 0 1 2 3", "a.ply");
        assertEquals(0.1, doubles.coordinate(0, 0));
    }

    @Test
    void normalsAndTextureCoordinatesAreReadByAllTheirNames() throws IOException {
        for (String names : new String[] {"u v", "s t", "texture_u texture_v", "texture_s texture_t"}) {
            String[] uv = names.split(" ");
            String more = "property float nx\nproperty float ny\nproperty float nz\nproperty float " + uv[1]
                    + "\nproperty float " + uv[0] + "\n";
            TriangleMesh read = mesh(
                    ASCII.replace("vertex 4", "vertex 3") + more + ONE_FACE
                            + "0 0 0 0 0 2 .25 .5\n1 0 0 0 1 0 0 1\n0 1 0 0 0 0 0 0\n3 0 1 2\n",
                    "a.ply");
            assertEquals(new Vec3(0, 0, 2), read.normal(0));
            assertEquals(new Vec3(0, 0, 0), read.normal(2));
            assertEquals(0.5, read.uv(0, 0));
            assertEquals(0.25, read.uv(0, 1));
        }
    }

    @Test
    void trianglesWithoutAnAreaAreCounted() throws IOException {
        TriangleMesh read =
                mesh(ASCII + "element face 4\n" + FACES + CORNERS + "3 0 1 2\n3 0 0 1\n2 0 1\n4 0 1 1 2\n", "a.ply");
        assertEquals(2, read.triangles());
        assertEquals(2, read.dropped());
    }

    @Test
    void aHeaderThatClaimsMoreThanTheFileHoldsIsRefused() {
        String claim =
                "has 2000000000 elements \"vertex\" of at least 12 bytes by its header, which is more than the file holds";
        String header = "ply\nformat binary_little_endian 1.0\n" + VERTICES.replace(" 4", " 2000000000");
        assertEquals(
                "has 2000000000 elements vertex; there may be at most 715827861", problem(header + ONE_FACE, "a.ply"));
        assertEquals(
                claim.replace("2000000000", "700000000"),
                problem(header.replace("2000000000", "700000000") + ONE_FACE, "a.ply"));
        String face = (ASCII + ONE_FACE).replace("face 1", "face 700000000");
        assertEquals(
                "has 700000000 elements \"face\" of at least 2 bytes by its header, which is more than the file holds",
                problem(face + CORNERS, "a.ply"));
    }

    @Test
    void aListThatIsLongerThanTheFileIsRefused() {
        String header = "ply\nformat binary_little_endian 1.0\n" + VERTICES + ONE_FACE.replace("uchar int", "int int");
        byte[] floats = new byte[48];
        assertEquals(
                "face 0 has a list of 2147483647 numbers, which is more than the file holds",
                problem(SmallMeshFiles.little(header, floats, Integer.MAX_VALUE), "a.ply"));
        assertEquals(
                "face 0 has a list of -1 numbers, which is less than none",
                problem(SmallMeshFiles.little(header, floats, -1), "a.ply"));
        assertEquals(
                "face 0 is incomplete: the data end there",
                problem(
                        SmallMeshFiles.little(
                                header.replace("end_header", "property int8 flag\nend_header"), floats, 1, 2),
                        "a.ply"));
    }

    @Test
    void indicesThatAreNoVertexAreRefusedWithTheirFace() {
        String two = ASCII + "element face 2\n" + FACES + CORNERS + "3 0 1 2\n";
        assertEquals("line 16: face 1 has the vertex -7; there are 4 from 0", problem(two + "3 0 1 -7\n", "a.ply"));
        assertEquals("line 16: face 1 has the vertex 4; there are 4 from 0", problem(two + "3 0 1 4\n", "a.ply"));
    }

    @Test
    void whatIsNoNumberIsRefusedWithItsLine() {
        for (String word : new String[] {"nan", "inf", "-Infinity", "0x1p3", "1d", "1f", "1e", "--1", ".", "1_0"}) {
            assertEquals(
                    "line 13: has \"" + word + "\" where a number is expected",
                    problem(ASCII + ONE_FACE + CORNERS.replace("1 1 0", "1 " + word + " 0") + "4 0 1 2 3\n", "a.ply"));
        }
        assertEquals(
                "line 13: has the number \"1e39\", which is beyond the range of floats",
                problem(ASCII + ONE_FACE + CORNERS.replace("1 1 0", "1 1e39 0") + "4 0 1 2 3\n", "a.ply"));
        assertEquals(
                "line 15: has \".5\" directly behind a number",
                problem(ASCII + ONE_FACE + CORNERS + "4 0 1 2.5 3\n", "a.ply"));
        assertEquals(
                "line 15: face 0 has a list of 4 numbers, which is more than the file holds",
                problem(ASCII + ONE_FACE + CORNERS + "4 0 1 2", "a.ply"));
    }

    @Test
    void binaryNumbersThatAreNotFiniteAreRefused() {
        String header = "ply\nformat binary_little_endian 1.0\n" + VERTICES + ONE_FACE;
        byte[] file =
                SmallMeshFiles.little(header, 0f, 0f, 0f, 1f, Float.NaN, 0f, 1f, 1f, 0f, 0f, 1f, 0f, (byte) 3, 0, 1, 2);
        assertEquals("positions: vertex 1 has a coordinate that is not finite: NaN", problem(file, "a.ply"));
    }

    @Test
    void brokenHeadersAreRefusedWithTheirLine() {
        String body = CORNERS + "4 0 1 2 3\n";
        String good = ASCII + ONE_FACE;
        String[][] cases = {
            {"ascii", "binary", "line 2: has the format \"binary\""},
            {"ascii 1.0", "ascii 2.0", "line 2: must be a format and its version 1.0"},
            {"format ascii 1.0\n", "", "its header has no format"},
            {"float x", "real x", "line 5: has the unknown type \"real\""},
            {"vertex 4", "vertex -4", "line 4: must be an element with its name and its count"},
            {"property float y", "remark", "line 6: has \"remark\" where element or property is expected"},
            {"list uchar", "list float", "line 9: has a list whose count is no integer"},
            {"property float z\n", "", "has vertices without properties x, y and z"},
            {"float y", "float x", "element \"vertex\" has two properties \"x\""},
            {"face 1", "vertex 1", "line 8: is a second element \"vertex\""},
            {"uchar int", "uchar float", "has faces without a list vertex_indices of integers"},
            {"end_header\n", "", "line 10: has \"0\" where element or property is expected"},
            {"face 1", "face 0", "has 4 vertices and 0 faces; a mesh needs some of both, elements vertex and face"},
        };
        for (String[] c : cases) {
            String problem = problem(good.replace(c[0], c[1]) + body, "a.ply");
            assertTrue(problem.startsWith(c[2]), problem);
        }
        assertEquals(
                "its header has no end_header within the first 64 KiB",
                problem("ply\nformat ascii 1.0\n" + "comment\n".repeat(10_000) + "end_header\n", "a.ply"));
        assertEquals("line 1: begins with \"plyx\" where ply is expected", problem("plyx\n", "a.ply"));
    }

    @Test
    void headersOfSomeOldProgramsAreRead() throws IOException {
        String good = ASCII + ONE_FACE + CORNERS + "4 0 1 2 3\n";
        TriangleMesh mesh = mesh(good, "a.ply");
        assertEquals(mesh, mesh(good.replace("ply\n", "PLY\n"), "a"));
        assertEquals(mesh, mesh(good.replace("comment", "Created by a program without the word"), "a.ply"));
    }

    @Test
    void polygonsHaveAtMost65536Corners() throws IOException {
        String header = (ASCII + ONE_FACE).replace("uchar int", "int int") + CORNERS;
        TriangleMesh read = mesh(header + "65536" + " 0 1 2 3".repeat(16384), "a.ply");
        assertEquals(65534, read.triangles() + read.dropped());
        assertEquals(
                "line 15: face 0 has 65537 corners; there may be at most 65536",
                problem(header + "65537" + " 0 1 2 3".repeat(16385), "a.ply"));
    }

    @Test
    void whatIsWrittenReadsBackAsAnEqualMesh() throws IOException {
        TriangleMesh floats = square();
        TriangleMesh doubles = TriangleMesh.of(new double[] {0.1, 0, 0, 1, 0, 0, 1, 1, -0.0}, new int[] {0, 1, 2});
        float[] normals = {0, 0, 1, 0, 3, 0, 0, 0, 0, 1, 1, 1};
        float[] uv = {0, 0.1f, 1, 0, 0.5f, 2, -1, 1};
        TriangleMesh[] meshes = {
            floats,
            doubles,
            floats.withNormals(normals),
            floats.withUv(uv),
            floats.withUv(uv).withNormals(normals)
        };
        for (TriangleMesh mesh : meshes) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            MeshFiles.writePly(mesh, out);
            TriangleMesh read = mesh(out.toByteArray(), "a.ply");
            assertEquals(mesh, read);
            assertEquals(mesh.isOfFloats(), read.isOfFloats());
            assertEquals(mesh.hasNormals(), read.hasNormals());
            assertEquals(mesh.hasUv(), read.hasUv());
        }
    }

    @Test
    void largeMeshesAreWrittenInPiecesAndReadBack() throws IOException {
        MeshBuilder builder = new MeshBuilder();
        for (int i = 0; i < 30_000; i++) {
            builder.vertex(i, i % 7, i % 11);
        }
        for (int i = 0; i + 2 < 30_000; i++) {
            builder.triangle(i, i + 1, i + 2);
        }
        TriangleMesh mesh = builder.build();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        MeshFiles.writePly(mesh, out);
        assertEquals(mesh, mesh(out.toByteArray(), "a.ply"));
    }
}
