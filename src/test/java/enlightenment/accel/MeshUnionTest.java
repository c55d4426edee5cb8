package enlightenment.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.BallCone;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Transform;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.primitive.Hit;
import enlightenment.primitive.MeshPrimitive;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Meshes that are searched together are met where each of them is met by itself. */
final class MeshUnionTest {
    private static final int RAYS = 20_000;
    private static final int SEGMENTS = 20;

    private static final Transform HALF = Transform.of(new Transform.Scale(new Vec3(0.5, 0.5, 0.5)));

    /** Three that overlap, one that is scaled, one that lies elsewhere, and a ball. */
    private static Primitive[] primitives() {
        SceneFrame frame = SceneFrame.WORLD;
        TriangleMesh ball = TestMeshes.icosphere(2);
        TriangleMesh soup = TestMeshes.soup(60, 0.7, 5);
        return new Primitive[] {
            Primitives.place(Mesh.of(ball), frame),
            Primitives.place(new Sphere(ExactPoint.of(0.5, 0, 0), 0.9, 0), frame),
            Primitives.place(Mesh.of(soup), frame),
            Primitives.place(Mesh.of(TestMeshes.cube()), frame),
            Primitives.place(Mesh.of(ball, Transform.of(new Transform.Scale(new Vec3(2, 0.5, 1)))), frame),
            Primitives.place(
                    Mesh.of(soup, Transform.of(new Transform.Translate(ExactPoint.of("0.3", "0", "0")))), frame)
        };
    }

    /** Three that are each placed once: one stretched, one mirrored and turned, one moved; and a ball. */
    private static Primitive[] lone() {
        SceneFrame frame = SceneFrame.WORLD;
        Transform stretched = Transform.of(new Transform.Scale(new Vec3(2, 0.5, 1)));
        Transform mirrored =
                Transform.of(new Transform.Scale(new Vec3(-0.7, 0.7, 0.7)), new Transform.Rotate(new Vec3(10, 20, 30)));
        Transform moved = Transform.of(new Transform.Translate(ExactPoint.of("0.3", "0.1", "0")));
        return new Primitive[] {
            Primitives.place(new Sphere(ExactPoint.of(0.5, 0, 0), 0.9, 0), frame),
            Primitives.place(Mesh.of(TestMeshes.icosphere(2), stretched), frame),
            Primitives.place(Mesh.of(TestMeshes.soup(60, 0.7, 5), mirrored), frame),
            Primitives.place(Mesh.of(TestMeshes.cube(), moved), frame)
        };
    }

    private static double signed(SplittableRandom random) {
        return 2 * random.nextDouble() - 1;
    }

    @Test
    void thoseThatWerePlacedAlikeAreTheUnion() {
        MeshUnion union = MeshUnion.of(primitives(), () -> {});
        assertNotNull(union);
        assertEquals(3, union.size());
        assertEquals(0, union.id(0));
        assertEquals(2, union.id(1));
        assertEquals(3, union.id(2));
        Primitive[] alone = {primitives()[0], primitives()[1]};
        assertNull(MeshUnion.of(alone, () -> {}));
    }

    @Test
    void smallMeshesThatArePlacedOnceAreAUnion() {
        MeshUnion union = MeshUnion.of(lone(), () -> {});
        assertNotNull(union);
        assertEquals(3, union.size());
        Primitive[] twice = {primitives()[0], primitives()[4], primitives()[1]};
        Primitive[] shared = {
            twice[0], Primitives.place(Mesh.of(((MeshPrimitive) twice[0]).mesh(), HALF), SceneFrame.WORLD)
        };
        assertNull(MeshUnion.of(shared, () -> {}), "an instance is not copied");
        Transform away = Transform.of(new Transform.Translate(ExactPoint.of("1e9", "0", "0")));
        Primitive[] far = {twice[0], Primitives.place(Mesh.of(TestMeshes.cube(), away), SceneFrame.WORLD)};
        assertNull(MeshUnion.of(far, () -> {}), "vertices far away would lose digits");
    }

    @Test
    void aHierarchyOfPlacedTrianglesAnswersAsALoopDoes() {
        // Vertices are rounded where they are placed, by 2^-52 of their size; what a ray meets at a small angle moves
        // by that over the angle.
        check(lone(), 1e-9);
    }

    @Test
    void aHierarchyAnswersAsALoopDoes() {
        check(primitives(), 0);
    }

    /** Where many segments of a cone are to come, the union is narrowed to what they may hit. */
    @Test
    void aNarrowedUnionBlocksWhatAllBlocks() {
        for (Primitive[] primitives : List.of(primitives(), lone())) {
            Bvh bvh = Bvh.build(primitives);
            int[] kinds = new int[primitives.length];
            BvhQuery narrowed = new BvhQuery(kinds, new long[1]);
            BvhQuery query = new BvhQuery(kinds, new long[1]);
            SplittableRandom random = new SplittableRandom(31);
            BallCone cone = new BallCone();
            int blocked = 0;
            int clear = 0;
            for (int k = 0; k < RAYS; k += SEGMENTS) {
                double[] from = {3 * signed(random), 3 * signed(random), 3 * signed(random)};
                double[] to = {2 * signed(random), 2 * signed(random), 2 * signed(random)};
                cone.set(to[0], to[1], to[2], 0.1, from[0], from[1], from[2]);
                int left = bvh.narrow(cone, id -> ConeJudge.MAY_BLOCK, SEGMENTS, narrowed);
                clear += left == 0 ? 1 : 0;
                for (int j = 0; j < SEGMENTS; j++) {
                    Ray ray = new Ray()
                            .set(
                                    from[0],
                                    from[1],
                                    from[2],
                                    to[0] + 0.05 * signed(random) - from[0],
                                    to[1] + 0.05 * signed(random) - from[1],
                                    to[2] + 0.05 * signed(random) - from[2],
                                    0);
                    boolean isBlocked = bvh.occluded(ray, 1, query);
                    assertEquals(isBlocked, left > 0 && bvh.occludedWithin(ray, 1, narrowed), "cone " + k);
                    blocked += isBlocked ? 1 : 0;
                }
            }
            assertTrue(clear > 0 && blocked > RAYS / 4 && blocked < RAYS, clear + " clear, " + blocked + " blocked");
        }
    }

    /** Rays from anywhere, and rays that leave what the ray before has met. */
    private static void check(Primitive[] primitives, double error) {
        Bvh bvh = Bvh.build(primitives);
        int[] kinds = new int[primitives.length];
        PrimitiveList loop = PrimitiveList.of(primitives, kinds);
        Closest a = new Closest(kinds, new long[1]);
        Closest b = new Closest(kinds, new long[1]);
        BvhQuery query = new BvhQuery(kinds, new long[1]);
        SplittableRandom random = new SplittableRandom(17);
        Ray ray = new Ray();
        Hit hit = new Hit();
        Hit other = new Hit();
        int met = 0;
        boolean leaves = false;
        for (int k = 0; k < RAYS; k++) {
            if (leaves) {
                double x = hit.px;
                double y = hit.py;
                double z = hit.pz;
                ray.set(x, y, z, signed(random), signed(random), signed(random), 0);
                double cosine = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz;
                ray.from(hit, cosine > 0 ? Ray.OUTSIDE : Ray.INSIDE);
            } else {
                ray.set(
                        3 * signed(random),
                        3 * signed(random),
                        3 * signed(random),
                        signed(random),
                        signed(random),
                        signed(random),
                        0);
            }
            int found = bvh.closest(ray, a);
            assertEquals(loop.closest(ray, b), found, "ray " + k);
            double tMax = 3 * random.nextDouble();
            assertEquals(loop.occluded(ray, tMax, query), bvh.occluded(ray, tMax, query), "shadow ray " + k);
            leaves = found >= 0;
            if (leaves) {
                met++;
                assertTrue(Math.abs(b.t() - a.t()) <= error * (1 + b.t()), "ray " + k);
                a.complete(ray, hit);
                b.complete(ray, other);
                assertEquals(other.element, hit.element, "ray " + k);
                assertEquals(other.primitive, hit.primitive, "ray " + k);
            }
        }
        assertTrue(met > RAYS / 4, met + " rays met something");
    }
}
