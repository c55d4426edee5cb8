package enlightenment.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Box;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class BvhTest {
    private static final double REACH = 60;

    /** No test has more primitives. */
    private static final int MAX = 1_000_000;

    private final BvhQuery query = new BvhQuery(new int[MAX], new long[1]);

    @Test
    void everySearchFindsWhatTheLoopFinds() {
        compareWithLoop(20_000);
    }

    @Test
    @Tag("full")
    void everySearchFindsWhatTheLoopFindsInAMillionRays() {
        compareWithLoop(1_000_000);
    }

    /** N16: 300 primitives of size 1e-6..1e3; rays from anywhere, and rays that leave what an earlier ray met. */
    private void compareWithLoop(int rays) {
        RandomPrimitives random = new RandomPrimitives(16);
        Primitive[] all = random.ofAllKinds(300);
        Bvh bvh = Bvh.build(all);
        Closest loop = search();
        Closest tree = search();
        Hit hit = new Hit();
        int hits = 0;
        for (int i = 0; i < rays; i++) {
            Ray ray = random.ray(REACH);
            if (i % 2 == 1 && loop.id() >= 0 && hit.primitive != null) {
                Vec3 d = random.vector(1);
                int side = d.dot(hit.normal()) > 0 ? Ray.OUTSIDE : Ray.INSIDE;
                ray = Ray.leaving(hit.point(), d, hit.primitive, side);
            }
            loop(all, ray, Double.MAX_VALUE, loop);
            bvh.closest(ray, tree);
            assertEquals(loop.id(), tree.id(), "ray " + i);
            assertEquals(Double.doubleToLongBits(loop.t()), Double.doubleToLongBits(tree.t()), "t of ray " + i);
            if (loop.id() >= 0) {
                hits++;
                all[loop.id()].complete(ray, loop.t(), hit);
                assertTrue(bvh.occluded(ray, loop.t(), query), "a crossing at tMax blocks, ray " + i);
                assertFalse(bvh.occluded(ray, Math.nextDown(loop.t()), query), "nothing is nearer, ray " + i);
            } else {
                assertFalse(bvh.occluded(ray, Double.MAX_VALUE, query), "ray " + i);
            }
        }
        assertTrue(hits > rays / 4 && hits < rays, "a test of hits and misses, not of " + hits + " of " + rays);
    }

    private static Closest search() {
        return new Closest(new int[MAX], new long[1]);
    }

    private static void loop(Primitive[] all, Ray ray, double limit, Closest closest) {
        closest.reset(limit);
        for (int i = 0; i < all.length; i++) {
            closest.offer(ray, all[i], i);
        }
    }

    @Test
    void raysAlongSharedEdgesFindWhatTheLoopFinds() {
        // Tiles of two planes that meet; rays aim at their edges and corners, exactly or almost exactly.
        Primitive[] all = new Primitive[128];
        for (int i = 0; i < all.length; i++) {
            double x = i % 8 - 4;
            double y = i / 8 % 8;
            boolean floor = i < 64;
            Vec3 a = floor ? new Vec3(x, 0, y) : new Vec3(x, y, 8);
            Vec3 b = a.plus(floor ? Vec3.Z : Vec3.Y);
            Vec3[] c = {a, b, b.plus(Vec3.X), a.plus(Vec3.X)};
            ExactPoint[] p = new ExactPoint[4];
            for (int k = 0; k < 4; k++) {
                p[k] = ExactPoint.of(c[k].x(), c[k].y(), c[k].z());
            }
            all[i] = Primitives.place(new Rectangle(p[0], p[1], p[2], p[3]), SceneFrame.WORLD);
        }
        Bvh bvh = Bvh.build(all);
        RandomPrimitives random = new RandomPrimitives(31);
        Closest loop = search();
        Closest tree = search();
        for (int i = 0; i < 50_000; i++) {
            double low = StrictMath.pow(10, -17 * random.uniform());
            Vec3 o = new Vec3(0.6 * random.uniform() - 0.3, i % 3 == 0 ? low : 2 * random.uniform(), -1);
            double off = i % 2 == 0 ? 0 : StrictMath.pow(10, -17 + 3 * random.uniform());
            Vec3 floor = new Vec3(random.index(3) - 1, off, 4 + random.index(5));
            Vec3 wall = new Vec3(random.index(3) - 1 + off, random.index(8), 8 - off);
            Ray ray = Ray.of(o, (random.index(2) == 0 ? floor : wall).minus(o));
            loop(all, ray, Double.MAX_VALUE, loop);
            assertEquals(loop.id(), bvh.closest(ray, tree), "ray " + i);
            assertTrue(loop.id() >= 0, "ray " + i + " passes between tiles");
            assertEquals(loop.t(), tree.t(), "ray " + i);
        }
    }

    @Test
    void theLengthOfTheDirectionDoesNotMatter() {
        RandomPrimitives random = new RandomPrimitives(8);
        Primitive[] all = random.ofAllKinds(100);
        Bvh bvh = Bvh.build(all);
        Closest closest = search();
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            Ray ray = random.ray(REACH);
            Vec3 o = new Vec3(ray.ox, ray.oy, ray.oz);
            Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
            int id = bvh.closest(ray, closest);
            hits += id >= 0 ? 1 : 0;
            for (int k = -1000; k <= 1000; k += 50) {
                Ray scaled = Ray.of(o, d.scaledBy(k));
                assertEquals(id, bvh.closest(scaled, closest), "ray " + i + " times 2^" + k);
                assertEquals(id >= 0, bvh.occluded(scaled, Double.MAX_VALUE, query), "ray " + i + " times 2^" + k);
            }
        }
        assertTrue(hits > 50, hits + " hits");
    }

    @Test
    void anEmptyHierarchyHoldsNothing() {
        Bvh bvh = Bvh.build(new Primitive[0]);
        Ray ray = Ray.of(Vec3.ZERO, Vec3.Z);
        Closest closest = search();
        assertEquals(-1, bvh.closest(ray, closest));
        assertEquals(Double.MAX_VALUE, closest.t());
        assertFalse(bvh.occluded(ray, Double.MAX_VALUE, query));
    }

    @Test
    void aSinglePrimitiveIsFound() {
        Bvh bvh = Bvh.build(new Primitive[] {sphere(0, 0, 5, 1)});
        Closest closest = search();
        assertEquals(0, bvh.closest(Ray.of(Vec3.ZERO, Vec3.Z), closest));
        assertEquals(4, closest.t());
        assertEquals(-1, bvh.closest(Ray.of(Vec3.ZERO, Vec3.X), closest));
    }

    @Test
    void aMillionCoincidentSpheresNeedNoDeepStack() {
        Primitive one = sphere(0, 0, 5, 1);
        Primitive[] all = new Primitive[1_000_000];
        Arrays.fill(all, one);
        Bvh bvh = Bvh.build(all);
        Closest closest = search();
        assertEquals(0, bvh.closest(Ray.of(Vec3.ZERO, Vec3.Z), closest), "the lowest id wins the tie");
        assertTrue(bvh.occluded(Ray.of(Vec3.ZERO, Vec3.Z), 4, query));
    }

    @Test
    void shrinkingSpheresMakeNoDeepTree() {
        // A geometric series defeats equal bins: without a bound each split would take off only the largest few.
        Primitive[] all = new Primitive[900];
        for (int i = 0; i < all.length; i++) {
            double x = place(i);
            all[i] = sphere(x, 0, 0, x / 64);
        }
        Bvh bvh = Bvh.build(all);
        Closest closest = search();
        for (int i = 0; i < all.length; i += 7) {
            assertEquals(i, bvh.closest(Ray.of(new Vec3(place(i), 2, 0), new Vec3(0, -1, 0)), closest));
        }
    }

    private static double place(int i) {
        return StrictMath.pow(2, -i / 8.0);
    }

    @Test
    void tiesDoNotDependOnTheOrderOfThePrimitives() {
        // Two boxes share a face at x = 1, a rectangle lies in it, and a box repeats the first.
        Primitive[] all = {
            box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 2, 1, 1), wall(1), box(0, 0, 0, 1, 1, 1), sphere(9, 9, 9, 1)
        };
        RandomPrimitives random = new RandomPrimitives(5);
        Closest closest = search();
        for (int round = 0; round < 200; round++) {
            int[] order = permutation(all.length, random);
            Primitive[] shuffled = new Primitive[all.length];
            for (int i = 0; i < order.length; i++) {
                shuffled[i] = all[order[i]];
            }
            Bvh bvh = Bvh.build(shuffled);
            Ray inside = Ray.of(new Vec3(0.5, 0.5, 0.5), new Vec3(1, 0.1, 0.2));
            int left = order[bvh.closest(inside, closest)];
            assertTrue(left == 0 || left == 3, "what is left comes before what is entered, not " + left);
            assertEquals(0.5, closest.t());
            loop(shuffled, inside, Double.MAX_VALUE, closest);
            assertEquals(left, order[closest.id()], "the loop and the tree agree");
        }
    }

    @Test
    void theLowerIdWinsATieOfEqualSides() {
        Closest closest = search();
        Ray ray = Ray.of(new Vec3(-5, 0.5, 0.5), Vec3.X);
        Primitive a = box(0, 0, 0, 1, 1, 1);
        Primitive b = box(0, 0, 0, 1, 1, 1);
        closest.reset(Double.MAX_VALUE);
        closest.offer(ray, b, 7);
        closest.offer(ray, a, 3);
        assertEquals(3, closest.id());
        closest.offer(ray, b, 7);
        assertEquals(3, closest.id());
    }

    private static int[] permutation(int n, RandomPrimitives random) {
        int[] order = new int[n];
        for (int i = 0; i < n; i++) {
            int j = random.index(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    private static Primitive sphere(double x, double y, double z, double r) {
        return Primitives.place(Sphere.of(ExactPoint.of(x, y, z), r), SceneFrame.WORLD);
    }

    private static Primitive box(double x0, double y0, double z0, double x1, double y1, double z1) {
        return Primitives.place(new Box(ExactPoint.of(x0, y0, z0), ExactPoint.of(x1, y1, z1)), SceneFrame.WORLD);
    }

    /** The unit square at x, seen from -x. */
    private static Primitive wall(double x) {
        return Primitives.place(
                new Rectangle(
                        ExactPoint.of(x, 0, 1), ExactPoint.of(x, 1, 1), ExactPoint.of(x, 1, 0), ExactPoint.of(x, 0, 0)),
                SceneFrame.WORLD);
    }
}
