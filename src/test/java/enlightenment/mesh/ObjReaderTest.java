package enlightenment.mesh;

import static enlightenment.mesh.SmallMeshFiles.HALVES;
import static enlightenment.mesh.SmallMeshFiles.SQUARE;
import static enlightenment.mesh.SmallMeshFiles.bytes;
import static enlightenment.mesh.SmallMeshFiles.mesh;
import static enlightenment.mesh.SmallMeshFiles.problem;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ObjReaderTest {
    private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    private static final TriangleMesh SQUARE_MESH = TriangleMesh.of(SQUARE, HALVES);

    @TempDir
    Path folder;

    @Test
    void eachFormOfACornerIsRead() throws IOException {
        String more = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
        String[] faces = {
            "f 1 2 3 4", "f -4 -3 -2 -1", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/-1 4/-1/-1"
        };
        for (int i = 0; i < faces.length; i++) {
            TriangleMesh read = mesh("# by hand\n" + CORNERS + more + faces[i], "a.obj");
            assertEquals(i == 2 || i == 4, read.hasUv());
            assertEquals(i >= 3, read.hasNormals());
            assertEquals(SQUARE_MESH, read.flat().hasUv() ? withoutUv(read) : read.flat());
            if (i == 4) {
                assertEquals(1, read.uv(3, 1));
                assertEquals(0, read.uv(3, 0));
                assertEquals(new Vec3(0, 0, 1), read.normal(3));
            }
        }
    }

    private static TriangleMesh withoutUv(TriangleMesh mesh) {
        float[] positions = new float[3 * mesh.vertices()];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = (float) mesh.coordinate(i / 3, i % 3);
        }
        return TriangleMesh.of(positions, mesh.data().indices);
    }

    @Test
    void linesGoOnBehindABackslashAndMayEndWithCarriageReturns() throws IOException {
        String text = CORNERS + "f 1 2 \\\n 3\\\n 4 # the end\n";
        assertEquals(SQUARE_MESH, mesh(text, "a.obj"));
        assertEquals(SQUARE_MESH, mesh(text.replace("\n", "\r\n"), "a.obj"));
        assertEquals(SQUARE_MESH, mesh("\u00ef\u00bb\u00bf" + text, "A.OBJ"));
        assertEquals("line 7: has the vertex 9; there are 4, from 1", problem(text.replace(" 4 #", " 9 #"), "a.obj"));
    }

    @Test
    void otherLinesAreSkippedAndFurtherNumbersIgnored() throws IOException {
        String text =
                "o square\ng a b\ns 1\n\n   \nv 0 0 0 1 0.5 0.5 0.5\nv\t1 0 0\nv 1 1 0\nv 0 1 0 1\nl 1 2\np 1\ncstype bezier\n"
                        + "curv 0 1 1 2\nf 1 2 3 4\n# f 9 9 9\nvp 1 2";
        assertEquals(SQUARE_MESH, mesh(text, "a.obj"));
    }

    @Test
    void verticesAreTheCombinationsInUse() throws IOException {
        TriangleMesh read =
                mesh(CORNERS + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\nf 1/2 3/1 4/1\nv 7 7 7\n", "a.obj");
        assertEquals(5, read.vertices());
        assertEquals(3, read.triangles());
    }

    @Test
    void someCornersWithoutNormalsHaveTheZeroNormalAndWithoutUvThereIsNone() throws IOException {
        TriangleMesh read = mesh(CORNERS + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\n", "a.obj");
        assertFalse(read.hasUv());
        assertEquals(new Vec3(0, 0, 1), read.normal(0));
        assertEquals(new Vec3(0, 0, 0), read.normal(2));
    }

    @Test
    void materialsArePartsInTheOrderOfFirstUse() throws IOException {
        String text = "mtllib a.mtl b.mtl\nmtllib my colours\n" + CORNERS
                + "usemtl unused\nusemtl blue \nf 1 2 3\nusemtl red one\nf 1 2 3\nf 1 3 4\nusemtl blue\nf 1 3 4\nusemtl flat\nf 1 1 2\n";
        Path file = folder.resolve("a.obj");
        Files.writeString(file, text);
        MeshFiles.Contents read = MeshFiles.readFile(file, 6);
        assertEquals(List.of("a.mtl", "b.mtl", "my colours"), read.materialLibraries());
        assertEquals(
                List.of("blue", "red one"),
                read.parts().stream().map(MeshFiles.Part::material).toList());
        assertEquals(SQUARE_MESH, read.parts().get(0).mesh());
        assertEquals(SQUARE_MESH, read.parts().get(1).mesh());
        List<MeshFiles.Part> first = MeshFiles.read(bytes(CORNERS + "f 1 2 3\nusemtl a\nf 1 3 4\n"), "a.obj", 2);
        assertEquals("", first.get(0).material());
        assertEquals("a", first.get(1).material());
    }

    @Test
    void textIsRoundedToFloats() throws IOException {
        TriangleMesh read = mesh("v 0.1 1e-3 -12345678.9\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
        assertTrue(read.isOfFloats());
        assertEquals(new Vec3(0.1f, 1e-3f, -12345678.9f), read.position(0));
    }

    @Test
    void facesMayNameVerticesThatComeAfterThem() throws IOException {
        assertEquals(SQUARE_MESH, mesh("f 1 2 3 4\n" + CORNERS, "a.obj"));
    }

    @Test
    void indicesThatAreNoVertexAreRefusedWithTheirLine() {
        String[][] cases = {
            {"f 1 2 0", "line 5: has the vertex 0; there are 4 so far, from 1"},
            {"f 1 2 -5", "line 5: has the vertex -5; there are 4 so far, from 1"},
            {"f 1 2 5", "line 5: has the vertex 5; there are 4, from 1"},
            {"f 1 2 99999999999", "line 5: has the vertex 99999999999; there are 4 so far, from 1"},
            {"f 1 2 9999999999999999999", "line 5: has \"9999999999999999999\" where an integer is expected"},
            {"f 1/1 2/1 3/1", "line 5: has the texture vertex 1; there are 0, from 1"},
            {"f 1//1 2//1 3//1", "line 5: has the normal 1; there are 0, from 1"},
            {"f 1 2 3.5", "line 5: has \".5\" directly behind a number"},
            {"f 1 2 3/", "line 5: has the end of the text where an integer is expected"},
            {"f 1 2", "line 5: has a face of 2 corners; at least 3 are expected"},
            {"f 1 2 x", "line 5: has \"x\" where an integer is expected"},
            {"v 1 2", "line 5: has the end of the text where a number is expected"},
            {"f 1 1 1", "has no triangle with an area"},
            {"", "has 4 vertices and no faces (f); nothing else makes a mesh"},
        };
        for (String[] c : cases) {
            assertEquals(c[1], problem(CORNERS + c[0], "a.obj"));
        }
    }

    @Test
    void linesNumbersAndNamesHaveALimit() throws IOException {
        String face = "f 1 2 3 4\n";
        assertEquals(SQUARE_MESH, mesh("#" + "x".repeat((1 << 20) - 1) + "\n" + CORNERS + face, "a.obj"));
        assertEquals(
                "line 1: is longer than 1 MiB", problem("#" + "x".repeat(1 << 20) + "\n" + CORNERS + face, "a.obj"));
        assertEquals("line 2: is longer than 1 MiB", problem("\nv" + " ".repeat(6_000_000) + "1 1 1", "a.obj"));
        assertEquals(
                "line 5: is longer than 1 MiB",
                problem(CORNERS + "f " + "1 ".repeat(60_000) + " ".repeat(1 << 20), "a.obj"));
        assertEquals(SQUARE_MESH, mesh(CORNERS.replace("v 1 0 0", "v 1." + "0".repeat(398) + " 0 0") + face, "a.obj"));
        assertEquals(
                "line 5: has a number of more than 400 characters",
                problem(CORNERS + "v 1." + "0".repeat(399) + " 0 0", "a.obj"));
        assertEquals(
                "line 1: has a number of more than 400 characters",
                problem("v " + "1".repeat(1_000_000) + " 0 0", "a.obj"));
        assertEquals("line 1: has a name of more than 4096 bytes", problem("usemtl " + "x".repeat(1_000_000), "a.obj"));
        assertEquals(
                "line 5: has a face of more than 65536 corners", problem(CORNERS + "f" + " 1".repeat(65537), "a.obj"));
    }

    @Test
    void theLimitOfTrianglesHoldsForAllPartsTogether() throws IOException {
        byte[] text = bytes(CORNERS + "f 1 2 3 4\nusemtl a\nf 1 2 3\n");
        assertEquals(2, MeshFiles.read(text, "a.obj", 3).size());
        IOException refused = assertThrows(IOException.class, () -> MeshFiles.read(text, "a.obj", 2));
        assertEquals("a.obj: line 7: exceeds the limit of 2 triangles", refused.getMessage());
    }

    @Test
    void wordsThatLieAcrossPiecesAreRead() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 1; i <= 20_000; i++) {
            text.append("v ").append(i).append(".5 ").append(i % 13).append(" 0.125\n");
        }
        for (int i = 1; i + 2 <= 20_000; i++) {
            text.append("f ")
                    .append(i)
                    .append(i % 3 == 0 ? " \\\r\n " : " ")
                    .append(i + 1)
                    .append(' ')
                    .append(i + 2)
                    .append("\r\n");
        }
        TriangleMesh read = mesh(text.toString(), "a.obj");
        assertEquals(19_998, read.triangles() + read.dropped());
        assertEquals(new Vec3(17_001.5, 17_001 % 13, 0.125), read.position(17_000));
    }
}
