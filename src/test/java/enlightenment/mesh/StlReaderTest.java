package enlightenment.mesh;

import static enlightenment.mesh.SmallMeshFiles.HALVES;
import static enlightenment.mesh.SmallMeshFiles.SQUARE;
import static enlightenment.mesh.SmallMeshFiles.binaryStl;
import static enlightenment.mesh.SmallMeshFiles.mesh;
import static enlightenment.mesh.SmallMeshFiles.problem;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class StlReaderTest {
    private static final TriangleMesh SQUARE_MESH = TriangleMesh.of(SQUARE, HALVES);

    /** The unit square with zeros of both signs. */
    private static final float[] CORNERS = {0, 0, 0, 1, -0f, 0, 1, 1, 0, -0f, 0, -0f, 1, 1, 0, 0, 1, -0f};

    private static String ascii() {
        StringBuilder text = new StringBuilder("solid a square\n");
        for (int t = 0; t < 2; t++) {
            text.append(" facet normal 0 nan 1\n  outer loop\n");
            for (int k = 0; k < 3; k++) {
                text.append("   vertex");
                for (int axis = 0; axis < 3; axis++) {
                    text.append(' ').append(CORNERS[9 * t + 3 * k + axis]);
                }
                text.append('\n');
            }
            text.append("  endloop\n endfacet\n");
        }
        return text.append("endsolid a square\n").toString();
    }

    @Test
    void bothFormsAreReadAndEqualPlacesAreOneVertex() throws IOException {
        assertEquals(SQUARE_MESH, mesh(binaryStl(CORNERS), "a.stl"));
        assertEquals(SQUARE_MESH, mesh(binaryStl(CORNERS), "a file without an ending"));
        assertEquals(SQUARE_MESH, mesh(ascii(), "a.stl"));
        assertEquals(SQUARE_MESH, mesh(ascii().replace("\n", "\r\n").toUpperCase(Locale.ROOT), "a"));
    }

    @Test
    void trianglesWithoutAnAreaAreCounted() throws IOException {
        TriangleMesh read = mesh(binaryStl(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2), "a.stl");
        assertEquals(1, read.triangles());
        assertEquals(1, read.dropped());
    }

    @Test
    void aBinaryFileOfAnotherSizeIsRefused() {
        byte[] file = binaryStl(CORNERS);
        file[0] = 'x';
        assertEquals(
                "neither begins with solid nor has the size of a binary STL file, 84 + 50 bytes a triangle",
                problem(Arrays.copyOf(file, file.length - 1), "a.stl"));
        file[80] = 0;
        assertEquals("has no triangles", problem(Arrays.copyOf(file, 84), "a.stl"));
    }

    @Test
    void numbersThatAreNotFiniteAreRefusedWithTheirTriangle() {
        float[] corners = CORNERS.clone();
        corners[10] = Float.POSITIVE_INFINITY;
        assertEquals(
                "triangle 1 has the corner (-0.0, Infinity, -0.0), which is not finite",
                problem(binaryStl(corners), "a.stl"));
    }

    @Test
    void brokenTextIsRefusedWithItsLine() {
        String[][] cases = {
            {"vertex 1.0 1.0 0.0\n", "vertex 1.0 nan 0.0\n", "line 6: has \"nan\" where a number is expected"},
            {"   vertex 1.0 1.0 0.0\n", "", "line 6: ends a triangle of 2 corners"},
            {"  endloop\n endfacet\n", "", "line 9: has a triangle of more than 3 corners"},
            {"vertex 1.0 1.0", "vertices 1.0 1.0", "line 6: has a word that STL does not have: \"vertices\""},
            {"vertex 1.0 1.0 0.0", "vertex 1.0 1.0", "line 6: has the end of the line where a number is expected"},
        };
        for (String[] c : cases) {
            assertEquals(c[2], problem(ascii().replace(c[0], c[1]), "a.stl"));
        }
        assertEquals(
                "line 6: ends in the middle of a triangle",
                problem(ascii().substring(0, ascii().indexOf("   vertex 1.0 1.0")), "a.stl"));
        assertEquals("has no triangles", problem("solid nothing\nendsolid\n", "a.stl"));
    }

    @Test
    void moreTrianglesThanTheLimitAreRefused() {
        for (byte[] file : new byte[][] {binaryStl(CORNERS), SmallMeshFiles.bytes(ascii())}) {
            IOException refused = assertThrows(IOException.class, () -> MeshFiles.read(file, "a.stl", 1));
            assertTrue(refused.getMessage().contains("exceeds the limit of 1"), refused.getMessage());
        }
    }
}
