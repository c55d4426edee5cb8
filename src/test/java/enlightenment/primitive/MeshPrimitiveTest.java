package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Transform;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.TriangleTree;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Instances of meshes, against shapes and vertices that are placed one by one. */
class MeshPrimitiveTest {
    private static final Map<String, Transform> PLACINGS = MeshLeavingTest.placings();

    private static double determinant(Transform t) {
        return t.row(0).cross(t.row(1)).dot(t.row(2));
    }

    @Test
    void theVolumeOfACubeIsThatOfItsEdges() {
        PLACINGS.forEach((how, transform) -> {
            double volume = MeshLeavingTest.placed(TestMeshes.cube(), transform).volume();
            double expected = Math.abs(determinant(transform));
            assertEquals(expected, volume, 1e-12 * expected, how);
        });
        TriangleMesh far = TestMeshes.moved(TestMeshes.cube(), false, v -> v.plus(new Vec3(1e6, -3e6, 2e6)));
        assertEquals(1, MeshLeavingTest.placed(far, Transform.IDENTITY).volume(), 1e-12);
    }

    @Test
    void pointsOfACubeAreInsideAndOthersOutside() {
        PLACINGS.forEach((how, transform) -> {
            MeshPrimitive cube = MeshLeavingTest.placed(TestMeshes.cube(), transform);
            RandomRays random = new RandomRays(3);
            for (int k = 0; k < 2_000; k++) {
                Vec3 v = random.inCube().times(1.5);
                // Roundings of places as far as 4e4 are 1e-11 of a length.
                double margin = 1e-9;
                double nearest = Math.min(Math.min(distance(v.x()), distance(v.y())), distance(v.z()));
                if (nearest < margin) {
                    continue;
                }
                boolean inside = isInside(v.x()) && isInside(v.y()) && isInside(v.z());
                Vec3 p = MeshLeavingTest.world(transform, v);
                assertEquals(inside, cube.contains(p.x(), p.y(), p.z()), how + ", " + v);
            }
            assertTrue(cube.isSolid() && !cube.isConvex() && !cube.isFlat());
        });
        MeshPrimitive open = MeshLeavingTest.placed(TestMeshes.grid(2), Transform.IDENTITY);
        assertFalse(open.contains(0, 0, 0) || open.isSolid());
    }

    private static double distance(double v) {
        return Math.min(Math.abs(v), Math.abs(v - 1));
    }

    private static boolean isInside(double v) {
        return v > 0 && v < 1;
    }

    @Test
    void boundsEncloseAllVerticesTightlyWhereAxesStayAxes() {
        TriangleMesh ball = TestMeshes.icosphere(2);
        PLACINGS.forEach((how, transform) -> {
            Bounds bounds = MeshLeavingTest.placed(ball, transform).bounds();
            Bounds tight = null;
            for (int v = 0; v < ball.vertices(); v++) {
                Bounds point = Bounds.of(MeshLeavingTest.world(transform, ball.position(v)));
                tight = tight == null ? point : tight.union(point);
            }
            for (int axis = 0; axis < 3; axis++) {
                double size = tight.extent().component(axis);
                double rounding = 1e-14 * tight.maxAbs();
                // A turned ball's parts have boxes of their own: less than a quarter of it is added on each side.
                double slack = rounding + (how.equals("as it stands") || how.equals("moved") ? 0 : 0.25 * size);
                double low = tight.min().component(axis) - bounds.min().component(axis);
                double high = bounds.max().component(axis) - tight.max().component(axis);
                // Places of vertices are rounded here, too.
                assertTrue(low >= -rounding / 64 && high >= -rounding / 64, how + ": " + low + ", " + high);
                assertTrue(low <= slack && high <= slack, how + ": " + low + ", " + high + " of " + size);
            }
        });
    }

    /** Meshes that glow are triangles of their own: textures lie on them as on the mesh. */
    @Test
    void trianglesKeepTheTextureCoordinatesOfTheirMesh() {
        for (boolean hasUv : List.of(true, false)) {
            MeshBuilder quad = new MeshBuilder();
            double[][] corners = {{0, 0, 0}, {2, 0, 1}, {2, 3, 0}, {0, 2, 0}};
            double[][] uv = {{-0.5, 0.25}, {1.25, 0}, {1, 1.5}, {0, 1}};
            for (int k = 0; k < corners.length; k++) {
                quad.vertex(corners[k][0], corners[k][1], corners[k][2]);
                if (hasUv) {
                    quad.uv(uv[k][0], uv[k][1]);
                }
            }
            quad.triangle(0, 1, 2);
            quad.triangle(0, 2, 3);
            Mesh shape = Mesh.of(quad.build());
            Primitive mesh = Primitives.place(shape, SceneFrame.WORLD);
            Hit hit = new Hit();
            Hit other = new Hit();
            for (int k = 0; k < 100; k++) {
                Ray ray = Ray.of(new Vec3(k % 10 / 5.0 + 0.0625, k / 10 / 5.0 + 0.03125, -5), Vec3.Z);
                assertTrue(mesh.intersect(ray, hit));
                Primitive triangle =
                        Primitives.triangles(shape, SceneFrame.WORLD).get(hit.element);
                assertTrue(triangle.intersect(ray, other));
                mesh.textureCoordinates(hit);
                triangle.textureCoordinates(other);
                assertEquals(hit.u, other.u, 1e-14);
                assertEquals(hit.v, other.v, 1e-14);
                assertEquals(mesh.repeatsTextures(), triangle.repeatsTextures());
                mesh.textureDirections(hit);
                triangle.textureDirections(other);
                assertEquals(hit.ux, other.ux, 1e-14);
                assertEquals(hit.vz, other.vz, 1e-14);
            }
        }
    }

    /** Rays meet an instance where they meet the triangles whose vertices are placed: to a few roundings of coordinates. */
    @Test
    void anInstanceIsMetWhereItsPlacedTrianglesAre() {
        TriangleMesh mesh = TestMeshes.icosphere(1);
        PLACINGS.forEach((how, transform) -> {
            Mesh shape = Mesh.of(mesh, transform);
            MeshPrimitive instance = (MeshPrimitive) Primitives.place(shape, SceneFrame.WORLD);
            List<Primitive> triangles = Primitives.triangles(shape, SceneFrame.WORLD);
            double size = instance.bounds().extent().maxAbs();
            double rounding = 1e-14 * instance.bounds().maxAbs();
            int mirrored = determinant(transform) < 0 ? -1 : 1;
            RandomRays random = new RandomRays(4);
            int met = 0;
            for (int k = 0; k < 1_000; k++) {
                Vec3 to = MeshLeavingTest.world(transform, random.direction().times(1.1 * random.uniform()));
                Vec3 d = random.direction();
                Ray ray = Ray.of(to.minus(d.times(size)), d);
                Hit hit = new Hit();
                Hit other = new Hit();
                double t = Primitive.MISS;
                int element = -1;
                for (int i = 0; i < triangles.size(); i++) {
                    if (triangles.get(i).intersect(ray, other) && other.t < t) {
                        t = other.t;
                        element = i;
                    }
                }
                if (!instance.intersect(ray, hit)) {
                    assertEquals(-1, element, how);
                    continue;
                }
                met++;
                triangles.get(element).intersect(ray, other);
                if (element != hit.element) {
                    continue;
                }
                double cosine = Math.abs(hit.normal().dot(d));
                assertEquals(t, hit.t, rounding / cosine, how);
                assertEquals(0, other.point().minus(hit.point()).maxAbs(), 2 * rounding / cosine, how);
                assertEquals(
                        0, other.normal().times(mirrored).minus(hit.normal()).maxAbs(), 1e-10 + rounding / size, how);
                assertEquals(other.side * mirrored, hit.side, how);
                assertEquals(hit.side, -(int) Math.signum(hit.normal().dot(d)), how);
            }
            assertTrue(met > 500, how + ": " + met);
        });
    }

    /** Normals of vertices go by the inverse transpose; those of a ball of the sphere, so, are those of an ellipsoid. */
    @Test
    void shadingNormalsOfAnEllipsoidAreThoseOfItsSurface() {
        TriangleMesh ball = TestMeshes.ball(4);
        PLACINGS.forEach((how, transform) -> {
            MeshPrimitive placed = MeshLeavingTest.placed(ball, transform);
            RandomRays random = new RandomRays(5);
            int smooth = 0;
            for (int k = 0; k < 500; k++) {
                Vec3 local = random.direction();
                Vec3 to = MeshLeavingTest.world(transform, Vec3.ZERO);
                Vec3 from = MeshLeavingTest.world(transform, local.times(2));
                Hit hit = new Hit();
                assertTrue(placed.intersect(Ray.of(from, to.minus(from)), hit));
                assertEquals(Ray.OUTSIDE, hit.side, how);
                // M⁻ᵀ·n is proportional to the cross products of the other two rows' images.
                Vec3 n = inverseTranspose(transform, local);
                smooth += placed.shadingNormal(hit) ? 1 : 0;
                Vec3 s = new Vec3(hit.sx, hit.sy, hit.sz);
                assertTrue(s.dot(n) > 1 - 1e-4, how + ": " + s + " instead of " + n);
                assertEquals(1, s.length(), 1e-14);
                assertTrue(s.dot(hit.normal()) > 0);
            }
            assertEquals(500, smooth, how);
        });
    }

    private static Vec3 inverseTranspose(Transform t, Vec3 n) {
        Vec3 x = t.row(1).cross(t.row(2));
        Vec3 y = t.row(2).cross(t.row(0));
        Vec3 z = t.row(0).cross(t.row(1));
        Vec3 v = new Vec3(x.dot(n), y.dot(n), z.dot(n));
        return v.times(Math.signum(determinant(t))).normalized();
    }

    @Test
    void aVertexWithoutADirectionLeavesTheTriangleFlat() {
        Vec3[] v = {Vec3.ZERO, Vec3.X, Vec3.Y};
        TriangleMesh mesh = TestMeshes.of(v, 0, 1, 2);
        Hit hit = new Hit();
        for (float[] normals : new float[][] {new float[9], {0, 0, -1, 0, 0, -1, 0, 0, -1}}) {
            MeshPrimitive placed = MeshLeavingTest.placed(mesh.withNormals(normals), Transform.IDENTITY);
            assertTrue(placed.intersect(Ray.of(new Vec3(0.2, 0.3, 1), new Vec3(0, 0, -1)), hit));
            assertFalse(placed.shadingNormal(hit));
        }
    }

    @Test
    void textureCoordinatesAreInterpolatedWithVDownwards() {
        Vec3[] v = {Vec3.ZERO, Vec3.X, Vec3.Y};
        TriangleMesh mesh = TestMeshes.of(v, 0, 1, 2).withUv(new float[] {0.5f, 0.25f, 1, 0.25f, 0.5f, 0.75f});
        MeshPrimitive placed = MeshLeavingTest.placed(mesh, Transform.of(new Transform.Scale(new Vec3(2, 2, 2))));
        Hit hit = new Hit();
        assertTrue(placed.intersect(Ray.of(new Vec3(0.5, 1, 1), new Vec3(0, 0, -1)), hit));
        placed.textureCoordinates(hit);
        assertEquals(0.5 + 0.25 * 0.5, hit.u, 1e-15);
        assertEquals(1 - (0.25 + 0.5 * 0.5), hit.v, 1e-15);
    }

    /** Everything commutes with powers of two. */
    @Test
    void aMeshOfAnExtremeSizeIsMetAsOneOfAnOrdinarySize() {
        TriangleMesh mesh = TestMeshes.icosphere(1);
        Transform turn = Transform.of(new Transform.Rotate(new Vec3(20, 50, -70)));
        for (int k : new int[] {-70, 80, 250, -400}) {
            int split = Math.max(-90, Math.min(90, k));
            TriangleMesh scaled = TestMeshes.times(mesh, Math.scalb(1.0, split));
            SceneFrame frame = new SceneFrame(ExactPoint.ORIGIN, split - k);
            MeshPrimitive one = MeshLeavingTest.placed(mesh, turn);
            MeshPrimitive other = (MeshPrimitive) Primitives.place(Mesh.of(scaled, turn), frame);
            RandomRays random = new RandomRays(6);
            for (int i = 0; i < 200; i++) {
                Vec3 from = random.inCube().times(3);
                Vec3 d = random.inCube().minus(from);
                Hit a = new Hit();
                Hit b = new Hit();
                boolean met = one.intersect(Ray.of(from, d), a);
                assertEquals(met, other.intersect(Ray.of(from.scaledBy(k), d), b), "2^" + k);
                if (met) {
                    assertEquals(a.point().scaledBy(k), b.point());
                    assertEquals(a.normal(), b.normal());
                    assertEquals(a.element, b.element);
                    Vec3 out = a.normal().times(a.side).plus(random.direction().times(0.9));
                    Ray p = new Ray()
                            .set(a.px, a.py, a.pz, out.x(), out.y(), out.z(), 0)
                            .from(a, a.side);
                    Ray q = new Ray()
                            .set(b.px, b.py, b.pz, out.x(), out.y(), out.z(), 0)
                            .from(b, b.side);
                    assertEquals(one.blocks(p, Double.MAX_VALUE), other.blocks(q, Double.MAX_VALUE), "2^" + k);
                }
            }
        }
    }

    @Test
    void instancesOfOneMeshShareItsHierarchyAndDifferByTheirPlace() {
        TriangleMesh mesh = TestMeshes.icosphere(1);
        MeshPrimitive a = MeshLeavingTest.placed(mesh, Transform.IDENTITY);
        MeshPrimitive b = MeshLeavingTest.placed(TestMeshes.icosphere(1), Transform.IDENTITY);
        MeshPrimitive c = MeshLeavingTest.placed(mesh, PLACINGS.get("moved"));
        assertArrayEquals(a.parameters(), b.parameters());
        assertFalse(Arrays.equals(a.parameters(), c.parameters()));
        assertEquals(a.parameters()[0], a.firstParameter());
        assertEquals(c.parameters()[0], c.firstParameter());
        assertEquals(TriangleTree.of(mesh, () -> {}), TriangleTree.of(mesh, () -> {}));
    }
}
