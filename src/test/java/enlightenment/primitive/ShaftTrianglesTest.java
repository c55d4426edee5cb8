package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.MeshRay;
import enlightenment.mesh.tree.ShaftTriangles;
import enlightenment.mesh.tree.TriangleTree;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Segments from one point to several others are blocked by the triangles of their shaft if they are blocked by the mesh. */
class ShaftTrianglesTest {
    private static final int FEW = 1_000;
    private static final int SEGMENTS = 6;

    /** Segments that end on a triangle do not cross it, but a ray of their length may meet it. */
    private static final double BEFORE_END = 1 - 0x1p-20;

    private static final double[] SIZES = {1, 1e-25, 1e25};

    /** By name: a mesh, of which some shafts meet few triangles and others none. */
    private static Map<String, TriangleMesh> meshes() {
        Map<String, TriangleMesh> all = MeshRayTest.meshes();
        all.put("crumbs", TestMeshes.soup(50, 1e-9, 5));
        return all;
    }

    @Test
    void theyBlockWhatTheMeshBlocks() {
        compare(FEW);
    }

    @Test
    @Tag("full")
    void inManyTriesTheyBlockWhatTheMeshBlocks() {
        compare(200_000);
    }

    private static void compare(int shafts) {
        meshes().forEach((name, mesh) -> {
            for (double size : SIZES) {
                new Comparison(name + " of size " + size, TestMeshes.times(mesh, size))
                        .run(size == 1 ? shafts : shafts / 10);
            }
        });
    }

    /** Shafts among one mesh. */
    private static final class Comparison {
        private final String name;
        private final TriangleMesh mesh;
        private final TriangleTree tree;
        private final RandomRays random = new RandomRays(23);
        private final ShaftTriangles triangles = new ShaftTriangles();
        private final MeshRay ray = new MeshRay();

        /** The triangle that segments start on; {@link MeshRay#NONE} for none. */
        private int start;

        private int side;
        private int known;
        private int clear;

        Comparison(String name, TriangleMesh mesh) {
            this.name = name;
            this.mesh = mesh;
            tree = TriangleTree.of(mesh, () -> {});
        }

        void run(int shafts) {
            for (int k = 0; k < shafts; k++) {
                shaft(k);
            }
            assertTrue(known > shafts / 10 && clear > 0 && clear < known, name + ": " + known + ", " + clear);
        }

        private void shaft(int k) {
            Vec3 from = start(k);
            Vec3 middle = point(k / 2);
            double width = k % 5 == 0 ? 0 : k % 5 == 1 ? 1 : 0.05;
            Vec3[] to = new Vec3[SEGMENTS];
            for (int j = 0; j < SEGMENTS; j++) {
                to[j] = middle.plus(random.inCube().times(width * mesh.maxAbs()));
            }
            Vec3 low = Bounds.of(to).min();
            Vec3 high = Bounds.of(to).max();
            double[] box = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
            if (!triangles.find(tree, from.x(), from.y(), from.z(), box, 0, 0, 0)) {
                return;
            }
            known++;
            clear += triangles.size() == 0 ? 1 : 0;
            for (Vec3 end : to) {
                compare(from, end, k);
            }
        }

        private void compare(Vec3 from, Vec3 to, int k) {
            Vec3 d = to.minus(from);
            if (!(d.maxAbs() > 0)) {
                return;
            }
            set(from, d);
            boolean isBlocked = ray.isBlocked(BEFORE_END);
            set(from, d);
            assertEquals(
                    isBlocked,
                    ray.isBlockedBy(triangles, BEFORE_END),
                    name + ", shaft " + k + " from " + from + " to " + to);
        }

        private void set(Vec3 from, Vec3 d) {
            ray.set(mesh, from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), 0);
            if (start != MeshRay.NONE) {
                ray.startOn(start, side, 0x1p-48 * mesh.maxAbs());
            }
        }

        /** A point that segments start at: on a triangle, which they leave, or anywhere. */
        private Vec3 start(int k) {
            start = MeshRay.NONE;
            if (k % 3 == 0) {
                return random.inCube().times((k % 2 == 0 ? 1.5 : 1e3) * mesh.maxAbs());
            }
            start = random.index(mesh.triangles());
            side = random.index(2) == 0 ? 1 : -1;
            return on(start);
        }

        private Vec3 on(int triangle) {
            Vec3 a = mesh.position(mesh.vertex(triangle, 0));
            Vec3 b = mesh.position(mesh.vertex(triangle, 1));
            Vec3 c = mesh.position(mesh.vertex(triangle, 2));
            double root = Math.sqrt(random.uniform());
            double u = root * random.uniform();
            return a.plus(b.minus(a).times(u)).plus(c.minus(a).times(root - u));
        }

        private Vec3 point(int k) {
            return k % 2 == 0
                    ? on(random.index(mesh.triangles()))
                    : random.inCube().times(2 * mesh.maxAbs());
        }
    }
}
