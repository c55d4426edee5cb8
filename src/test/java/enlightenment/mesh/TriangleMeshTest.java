package enlightenment.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import org.junit.jupiter.api.Test;

/** What a mesh says of itself. */
class TriangleMeshTest {
    private static final Vec3[] CORNERS = {Vec3.ZERO, Vec3.X, Vec3.Y, Vec3.Z};
    private static final int[] FACES = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    @Test
    void trianglesWithoutAnAreaAreLeftOutAndCounted() {
        Vec3[] v = {Vec3.ZERO, Vec3.X, Vec3.Y, Vec3.X.times(2), Vec3.X};
        TriangleMesh mesh = TestMeshes.of(v, 0, 1, 3, 0, 1, 2, 0, 0, 1, 1, 2, 4, 2, 1, 3);
        assertEquals(2, mesh.triangles());
        assertEquals(3, mesh.dropped());
        assertEquals(Vec3.Z, mesh.areaNormal(0));
        assertEquals(2, mesh.vertex(1, 0));
        assertEquals(3, mesh.smooth().dropped());
        assertThrows(InvalidValueException.class, () -> TestMeshes.of(v, 0, 1, 3));
        assertThrows(InvalidValueException.class, () -> TestMeshes.of(v));
    }

    @Test
    void aTriangleIsKeptHoweverSmallOrThinItIs() {
        for (double size : new double[] {1e-25, 1, 1e25}) {
            Vec3[] v = {Vec3.X.times(size), Vec3.X.times(size * (1 + 0x1p-20)), new Vec3(1, 0x1p-40, 0).times(size)};
            assertEquals(0, TestMeshes.of(v, 0, 1, 2).dropped(), "size " + size);
        }
    }

    @Test
    void aTetrahedronIsClosedAndItsAreasAddUpToNothing() {
        TriangleMesh mesh = TestMeshes.tetrahedron();
        assertEquals(0, mesh.openEdges());
        assertTrue(mesh.isClosed());
        Vec3 sum = Vec3.ZERO;
        for (int t = 0; t < 4; t++) {
            sum = sum.plus(mesh.areaNormal(t));
        }
        assertEquals(0, sum.maxAbs());
        assertTrue(mesh.isOfFloats());
    }

    /** Its three edges run the same way as those of its neighbours. */
    @Test
    void aFaceThatIsTurnedOverOpensItsThreeEdges() {
        int[] faces = FACES.clone();
        faces[1] = 1;
        faces[2] = 2;
        TriangleMesh mesh = TestMeshes.of(CORNERS, faces);
        assertEquals(3, mesh.openEdges());
        assertFalse(mesh.isClosed());
    }

    @Test
    void aMissingFaceOpensThreeEdgesAndAFaceThatIsThereTwiceDoesSo() {
        assertEquals(3, TestMeshes.of(CORNERS, 0, 2, 1, 0, 1, 3, 0, 3, 2).openEdges());
        assertEquals(
                3,
                TestMeshes.of(CORNERS, 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 3, 1, 2)
                        .openEdges());
    }

    @Test
    void verticesInOnePlaceAreOne() {
        Vec3[] twelve = new Vec3[12];
        int[] indices = new int[12];
        for (int i = 0; i < 12; i++) {
            Vec3 v = CORNERS[FACES[i]];
            twelve[i] = i % 2 == 0 ? v : new Vec3(negativeZero(v.x()), negativeZero(v.y()), negativeZero(v.z()));
            indices[i] = i;
        }
        TriangleMesh mesh = TestMeshes.of(twelve, indices);
        assertEquals(12, mesh.vertices());
        assertTrue(mesh.isClosed());
        twelve[5] = twelve[5].plus(Vec3.X.times(0x1p-40));
        assertFalse(TestMeshes.of(twelve, indices).isClosed());
    }

    private static double negativeZero(double v) {
        return v == 0 ? -0.0 : v;
    }

    @Test
    void solidsThatTouchInAnEdgeAreClosed() {
        TriangleMesh cube = TestMeshes.cube();
        TriangleMesh other = TestMeshes.moved(cube, false, v -> v.plus(new Vec3(1, 1, 0)));
        MeshBuilder both = new MeshBuilder();
        for (TriangleMesh m : new TriangleMesh[] {cube, other}) {
            int first = both.vertices();
            for (int v = 0; v < m.vertices(); v++) {
                both.vertex(m.coordinate(v, 0), m.coordinate(v, 1), m.coordinate(v, 2));
            }
            for (int t = 0; t < m.triangles(); t++) {
                both.triangle(first + m.vertex(t, 0), first + m.vertex(t, 1), first + m.vertex(t, 2));
            }
        }
        assertEquals(0, both.build().openEdges());
    }

    @Test
    void normalsOfACubeWithCreasesAreThoseOfItsFaces() {
        TriangleMesh mesh = TestMeshes.cube().smooth(45);
        assertEquals(24, mesh.vertices());
        for (int t = 0; t < 12; t++) {
            for (int k = 0; k < 3; k++) {
                assertEquals(mesh.areaNormal(t), mesh.normal(mesh.vertex(t, k)));
            }
        }
        assertTrue(mesh.isClosed());
    }

    @Test
    void normalsOfASmoothCubePointAlongItsDiagonals() {
        for (double crease : new double[] {91, 180}) {
            TriangleMesh mesh = TestMeshes.cube().smooth(crease);
            assertEquals(8, mesh.vertices());
            for (int v = 0; v < 8; v++) {
                Vec3 diagonal = mesh.position(v).minus(new Vec3(0.5, 0.5, 0.5)).normalized();
                assertEquals(0, diagonal.minus(mesh.normal(v)).maxAbs(), 1e-7);
            }
        }
    }

    /** Of the first order in the size of triangles at least: where the cuts of two faces of the icosahedron meet they are not regular. */
    @Test
    void smoothNormalsOfABallGoToThoseOfTheSphere() {
        double[] error = new double[5];
        for (int cuts = 1; cuts < 5; cuts++) {
            TriangleMesh mesh = TestMeshes.icosphere(cuts).smooth();
            for (int v = 0; v < mesh.vertices(); v++) {
                error[cuts] = Math.max(
                        error[cuts], mesh.normal(v).minus(mesh.position(v)).length());
            }
        }
        assertTrue(error[1] < 0.02, "" + error[1]);
        assertTrue(error[4] < 0.3 * error[2], error[2] + ", then " + error[4]);
    }

    @Test
    void aVertexThatNoTriangleHasIsNoPartOfTheBounds() {
        Vec3[] v = {Vec3.ZERO, Vec3.X, Vec3.Y, new Vec3(9, 9, 9)};
        TriangleMesh mesh = TestMeshes.of(v, 0, 1, 2);
        assertEquals(new Vec3(1, 1, 0), mesh.max());
        assertEquals(Vec3.ZERO, mesh.min());
        assertEquals(1, mesh.smooth().normal(mesh.vertex(0, 0)).z());
    }

    @Test
    void meshesOfEqualNumbersAreEqual() {
        TriangleMesh one = TestMeshes.icosphere(1);
        assertEquals(one, TestMeshes.icosphere(1));
        assertEquals(one.digest(), TestMeshes.icosphere(1).digest());
        assertEquals(one.hashCode(), TestMeshes.icosphere(1).hashCode());
        assertEquals(one, one.smooth().flat());
        assertSame(one, one.flat());
        float[] floats = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        double[] doubles = {-0.0, 0, 0, 1, 0, 0, 0, 1, 0};
        TriangleMesh triangle = TriangleMesh.of(floats, new int[] {0, 1, 2});
        assertEquals(triangle, TriangleMesh.of(doubles, new int[] {0, 1, 2}));
        doubles[3] = Math.nextUp(1.0);
        assertNotEquals(triangle, TriangleMesh.of(doubles, new int[] {0, 1, 2}));
        assertNotEquals(triangle, TriangleMesh.of(floats, new int[] {1, 2, 0}));
        assertNotEquals(triangle, triangle.smooth());
        assertNotEquals(triangle, triangle.withUv(new float[6]));
        assertNotEquals(triangle.withNormals(new float[9]), triangle.smooth());
    }

    /** 3 · 2,000 numbers of 8 bytes are more than one piece of the digest's input. */
    @Test
    void everyNumberOfALargeMeshCounts() {
        TriangleMesh grid = TestMeshes.grid(50);
        for (int changed : new int[] {0, 1300, 2600}) {
            TriangleMesh other = TestMeshes.moved(
                    grid, false, v -> v.equals(grid.position(changed)) ? v.plus(Vec3.Z.times(0x1p-30)) : v);
            assertNotEquals(grid.digest(), other.digest());
        }
    }

    @Test
    void coordinatesAreDoublesWhereOneIsNoFloat() {
        MeshBuilder builder = new MeshBuilder();
        builder.vertex(0, 0, 0);
        builder.vertex(1, 0, 0);
        builder.vertex(0, 0.1, 0);
        builder.triangle(0, 1, 2);
        TriangleMesh mesh = builder.build();
        assertFalse(mesh.isOfFloats());
        assertEquals(0.1, mesh.coordinate(2, 1));
        assertEquals(1, mesh.coordinate(1, 0));
        assertEquals(0, builder.vertices());
    }

    @Test
    void whatIsNoMeshIsRefused() {
        float[] p = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        assertRefused("indices", () -> TriangleMesh.of(p, new int[] {0, 1, 3}));
        assertRefused("indices", () -> TriangleMesh.of(p, new int[] {0, 1, -1}));
        assertRefused("indices", () -> TriangleMesh.of(p, new int[] {0, 1}));
        assertRefused("positions", () -> TriangleMesh.of(new float[8], new int[] {0, 1, 2}));
        assertRefused("positions", () -> TestMeshes.times(TestMeshes.cube(), 1e31));
        assertRefused("positions", () -> TestMeshes.times(TestMeshes.cube(), 1e-31));
        float[] infinite = p.clone();
        infinite[4] = Float.POSITIVE_INFINITY;
        assertRefused("positions", () -> TriangleMesh.of(infinite, new int[] {0, 1, 2}));
        TriangleMesh mesh = TriangleMesh.of(p, new int[] {0, 1, 2});
        assertRefused("normals", () -> mesh.withNormals(new float[6]));
        assertRefused("normals", () -> mesh.withNormals(infinite));
        assertRefused("uv", () -> mesh.withUv(new float[3]));
        assertRefused("crease", () -> mesh.smooth(181));
    }

    private static void assertRefused(String key, Runnable what) {
        assertEquals(key, assertThrows(InvalidValueException.class, what::run).key());
    }
}
