package enlightenment.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Every kind of accelerator against a loop over all primitives. */
class AcceleratorTest {
    private static final int N = 240;

    private final BvhQuery query = new BvhQuery(new int[N], new long[1]);
    private final Closest loop = new Closest(new int[N], new long[1]);
    private final Closest found = new Closest(new int[N], new long[1]);

    private void compare(Primitive[] all, RaySearch search, Accelerator accelerator, Ray ray) {
        loop.reset(Double.MAX_VALUE);
        for (int i = 0; i < all.length; i++) {
            loop.offer(ray, all[i], i);
        }
        found.reset(Double.MAX_VALUE);
        search.search(ray, found);
        assertEquals(loop.id(), found.id());
        assertEquals(Double.doubleToLongBits(loop.t()), Double.doubleToLongBits(found.t()));
        boolean met = loop.id() >= 0;
        assertEquals(met, accelerator.occluded(ray, met ? loop.t() : Double.MAX_VALUE, query));
        assertFalse(met && accelerator.occluded(ray, Math.nextDown(loop.t()), query));
    }

    @Test
    void aListFindsWhatTheLoopFinds() {
        RandomPrimitives random = new RandomPrimitives(4);
        Primitive[] all = random.ofAllKinds(20);
        PrimitiveList list = PrimitiveList.of(all, new int[all.length]);
        for (int i = 0; i < 2_000; i++) {
            compare(all, list, list, random.ray(60));
        }
    }

    /**
     * A room of walls that share edges and planes, with some things in it.
     *
     * @param parts that each wall has: one or two
     * @param missing one in so many of them is not there
     */
    private static Primitive[] room(RandomPrimitives random, int parts, int missing) {
        List<Shape> shapes = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            for (int at = -4; at <= 4; at += 8) {
                for (int part = 0; part < parts; part++) {
                    if (random.index(missing) == 0) {
                        continue;
                    }
                    int high = 8 / parts;
                    int low = -4 + high * part;
                    double[][] c = {{-4, low}, {-4, low + high}, {4, low + high}, {4, low}};
                    ExactPoint[] p = new ExactPoint[4];
                    for (int i = 0; i < 4; i++) {
                        p[i] = k == 0
                                ? ExactPoint.of(at, c[i][0], c[i][1])
                                : k == 1 ? ExactPoint.of(c[i][0], at, c[i][1]) : ExactPoint.of(c[i][0], c[i][1], at);
                    }
                    shapes.add(new Rectangle(p[0], p[1], p[2], p[3]));
                }
            }
        }
        for (int i = 0; i < 4; i++) {
            Vec3 c = random.vector(3);
            shapes.add(Sphere.of(ExactPoint.of(c.x(), c.y(), c.z()), 0.1 + random.uniform()));
            c = random.vector(3);
            shapes.add(new Cube(ExactPoint.of(c.x(), c.y(), c.z()), 0.1 + random.uniform(), random.vector(90)));
            shapes.add(new Box(ExactPoint.of(-4, -4, i - 2), ExactPoint.of(-3 + i, -3.5 + 0.25 * i, i - 1)));
        }
        shapes.add(new Triangle(ExactPoint.of(0, 0, 0), ExactPoint.of(2, 0, 0), ExactPoint.of(0, 3, 0)));
        return shapes.stream().map(s -> Primitives.place(s, SceneFrame.WORLD)).toArray(Primitive[]::new);
    }

    /** Through whole and half numbers, where edges and corners are, and beside them by a few units in the last place. */
    private static Vec3 nearEdge(RandomPrimitives random) {
        double[] c = new double[3];
        for (int k = 0; k < 3; k++) {
            double v = 0.5 * (random.index(17) - 8);
            int ulps = random.index(5) - 2;
            c[k] = random.index(3) == 0 ? 8 * random.uniform() - 4 : v + ulps * Math.ulp(v);
        }
        return new Vec3(c[0], c[1], c[2]);
    }

    @Test
    void aListOfARoomFindsWhatTheLoopFindsAtEdgesAndFromSurfaces() {
        RandomPrimitives random = new RandomPrimitives(8);
        int starts = 0;
        for (int k = 0; k < 40; k++) {
            starts += compareInRoom(random, room(random, 1 + k % 2, k < 20 ? Integer.MAX_VALUE : 7));
        }
        assertTrue(starts > 20_000, starts + " rays from surfaces");
    }

    @Test
    void wallsThatLieOnEachOtherInOnePlaneAreToldApartAsInALoop() {
        RandomPrimitives random = new RandomPrimitives(9);
        int starts = 0;
        for (int k = 0; k < 6; k++) {
            Primitive[] all = new Primitive[6];
            // A shelf and a cloth on it have any places in the order; there is no floor.
            all[k] = rectangle(1, 0, -1, 2);
            all[(k + 1 + k % 5) % 6] = rectangle(1, 0, -4, 4);
            int wall = 0;
            for (int i = 0; i < 6; i++) {
                if (all[i] == null) {
                    all[i] = rectangle(wall < 2 ? 0 : 2, wall % 2 == 0 ? -4 : 4, -4, 4);
                    wall++;
                }
            }
            starts += compareInRoom(random, all);
        }
        assertTrue(starts > 3_000, starts + " rays from surfaces");
    }

    /** A square across an axis, between the same coordinates on both of the others. */
    private static Primitive rectangle(int axis, double at, double least, double most) {
        double[][] c = {{least, least}, {least, most}, {most, most}, {most, least}};
        ExactPoint[] p = new ExactPoint[4];
        for (int i = 0; i < 4; i++) {
            p[i] = axis == 0
                    ? ExactPoint.of(at, c[i][0], c[i][1])
                    : axis == 1 ? ExactPoint.of(c[i][0], at, c[i][1]) : ExactPoint.of(c[i][0], c[i][1], at);
        }
        return Primitives.place(new Rectangle(p[0], p[1], p[2], p[3]), SceneFrame.WORLD);
    }

    /** Compares a list with a loop, for rays in a room; returns how many started on what others had met. */
    private int compareInRoom(RandomPrimitives random, Primitive[] all) {
        Hit hit = new Hit();
        PrimitiveList list = PrimitiveList.of(all, new int[all.length]);
        Ray ray = new Ray();
        int starts = 0;
        for (int i = 0; i < 2_000; i++) {
            Vec3 o = i % 2 == 0 ? nearEdge(random) : random.vector(4);
            Vec3 d = i % 3 == 0 ? random.vector(1) : nearEdge(random).minus(o);
            if (d.maxAbs() == 0) {
                continue;
            }
            double scale = Math.scalb(1.0, random.index(60) - 30);
            double from = i % 5 == 0 ? random.uniform() / scale : i % 7 == 0 ? -random.uniform() / scale : 0;
            ray.set(o.x(), o.y(), o.z(), scale * d.x(), scale * d.y(), scale * d.z(), from);
            compare(all, list, list, ray);
            if (loop.id() >= 0 && all[loop.id()].intersect(ray, hit)) {
                starts++;
                Vec3 on = nearEdge(random).minus(hit.point());
                ray.set(hit.px, hit.py, hit.pz, on.x(), on.y(), on.z(), 0);
                double out = on.x() * hit.nx + on.y() * hit.ny + on.z() * hit.nz;
                compare(all, list, list, ray.from(all[loop.id()], out > 0 ? Ray.OUTSIDE : Ray.INSIDE));
            }
        }
        return starts;
    }

    /** The threads of a render share one list; what they keep of a search is their own. */
    @Test
    void threadsThatSearchOneListTogetherFindWhatEachFindsAlone() {
        Primitive[] all = room(new RandomPrimitives(10), 1, Integer.MAX_VALUE);
        PrimitiveList list = PrimitiveList.of(all, new int[all.length]);
        List<Long> alone = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            alone.add(sumOfSearches(list, k));
        }
        List<CompletableFuture<Long>> together = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            int seed = k;
            together.add(CompletableFuture.supplyAsync(() -> sumOfSearches(list, seed)));
        }
        assertEquals(alone, together.stream().map(CompletableFuture::join).toList());
    }

    /** A number that depends on all bits of what many rays find. */
    private static long sumOfSearches(PrimitiveList list, int seed) {
        RandomPrimitives random = new RandomPrimitives(seed);
        Closest state = new Closest(new int[N], new long[1]);
        Ray ray = new Ray();
        long sum = 0;
        for (int i = 0; i < 100_000; i++) {
            Vec3 o = random.vector(3.5);
            Vec3 d = random.vector(1);
            ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), 0);
            state.reset(Double.MAX_VALUE);
            list.search(ray, state);
            sum = 31 * sum + Double.doubleToRawLongBits(state.t()) + state.id();
        }
        return sum;
    }

    /** Spheres around (x, 0, 0) within a distance of 200 times their radius. */
    private static Primitive[] specks(RandomPrimitives random, double x, double radius) {
        Primitive[] all = new Primitive[N];
        for (int i = 0; i < N; i++) {
            Vec3 c = random.vector(200 * radius);
            all[i] = Primitives.place(
                    Sphere.of(ExactPoint.of(c.x() + x, c.y(), c.z()), 20 * radius * random.uniform()),
                    SceneFrame.WORLD);
        }
        return all;
    }

    @Test
    void boxesNearAndFarLargeAndSmallLoseNothing() {
        RandomPrimitives random = new RandomPrimitives(5);
        int hits = 0;
        int fine = 0;
        for (int k = 0; k < 60; k++) {
            double radius = Math.scalb(1.0, random.index(140) - 70);
            double x = k % 3 == 0 ? 0 : radius * Math.scalb(1.0, random.index(32));
            Primitive[] all = specks(random, x, radius);
            Bvh bvh = Bvh.build(all);
            fine += bvh instanceof DoubleBvh ? 1 : 0;
            for (int i = 0; i < 100; i++) {
                Vec3 to = random.vector(100 * radius).plus(new Vec3(x, 0, 0));
                Vec3 from =
                        i % 4 == 0 ? Vec3.ZERO : random.vector(400 * radius).plus(new Vec3(i % 4 == 1 ? x : 0, 0, 0));
                Vec3 d = to.minus(from).times(Math.scalb(1.0, random.index(90) - 45));
                // Some are parallel to an axis or a plane, or almost.
                d = i % 5 == 0 ? new Vec3(d.x(), i % 2 == 0 ? -0.0 : d.x() * 0x1p-140, 0) : d;
                if (d.maxAbs() > 0) {
                    compare(all, bvh, bvh, Ray.of(from, d));
                    hits += loop.id() >= 0 ? 1 : 0;
                }
            }
        }
        assertTrue(hits > 500 && fine > 10 && fine < 50, hits + " hits, " + fine + " with doubles");
    }

    /** By the balls of spheres. */
    private static ConeJudge judge(Primitive[] all, BallCone cone) {
        return id -> {
            SpherePrimitive s = (SpherePrimitive) all[id];
            Vec3 c = s.center();
            if (cone.misses(c.x(), c.y(), c.z(), s.radius())) {
                return ConeJudge.CLEAR;
            }
            return cone.isHiddenBy(c.x(), c.y(), c.z(), s.radius()) ? ConeJudge.BLOCKS_ALL : ConeJudge.MAY_BLOCK;
        };
    }

    @Test
    void aNarrowedQuestionHasTheAnswerOfTheLoop() {
        RandomPrimitives random = new RandomPrimitives(7);
        int[] count = new int[3];
        for (int k = 0; k < 40; k++) {
            Primitive[] all = specks(random, k % 2 == 0 ? 0 : 300, 1);
            Bvh bvh = Bvh.build(all);
            ConeSearch definite = ConeSearch.of(bvh);
            for (int i = 0; i < 50; i++) {
                Vec3 p = random.vector(250).plus(new Vec3(k % 2 == 0 ? 0 : 300, 0, 0));
                Vec3 q = i % 5 == 0 ? new Vec3(p.x(), p.y(), 300) : random.vector(400);
                double radius = i % 7 == 0 ? 0 : 30 * random.uniform();
                BallCone cone = new BallCone();
                cone.set(q.x(), q.y(), q.z(), radius, p.x(), p.y(), p.z());
                check(all, bvh, definite, cone, random, count);
            }
        }
        assertTrue(count[0] > 200 && count[1] > 100 && count[2] > 200, count[0] + " " + count[1] + " " + count[2]);
    }

    private void check(
            Primitive[] all, Bvh bvh, ConeSearch definite, BallCone cone, RandomPrimitives random, int[] count) {
        ConeJudge judge = judge(all, cone);
        boolean clear = IntStream.range(0, N).allMatch(id -> judge.judge(id) == ConeJudge.CLEAR);
        boolean hidden = IntStream.range(0, N).anyMatch(id -> judge.judge(id) == ConeJudge.BLOCKS_ALL);
        int verdict = definite.narrow(cone, judge, query);
        assertEquals(clear, verdict == 0);
        assertEquals(hidden, verdict == Accelerator.BLOCKED);
        assertEquals(hidden, bvh.blocksAll(cone, judge, query));
        count[clear ? 0 : hidden ? 1 : 2]++;
        int left = bvh.narrow(cone, judge, 2, query);
        // The front knows the shaft better than the judge does near the apex: it may be empty where the judge is in
        // doubt.
        assertTrue(left != Accelerator.BLOCKED || hidden);
        assertTrue(left != 0 || !hidden);
        if (left == Accelerator.BLOCKED) {
            return;
        }
        Vec3 apex = new Vec3(cone.x, cone.y, cone.z);
        Vec3 center = apex.plus(new Vec3(cone.wx, cone.wy, cone.wz).times(cone.distance));
        for (int j = 0; j < 6; j++) {
            Vec3 to =
                    center.plus(random.vector(1).normalized().times(cone.radius * (j % 2 == 0 ? 1 : random.uniform())));
            Ray ray = Ray.of(apex, to.minus(apex));
            boolean blocked = false;
            for (Primitive s : all) {
                blocked |= s.nearest(ray, 1) <= 1;
            }
            assertEquals(blocked, left > 0 && bvh.occludedWithin(ray, 1, query));
        }
    }

    @Test
    void raysFromASphereIntoItselfOrAwayAreBlockedInNarrowedConesAsInALoop() {
        RandomPrimitives random = new RandomPrimitives(77);
        Primitive[] spheres = new Primitive[200];
        for (int i = 0; i < spheres.length; i++) {
            Sphere s = Sphere.of(ExactPoint.of(8 * random.uniform(), 8 * random.uniform(), 8 * random.uniform()), 0.6);
            spheres[i] = Primitives.place(s, SceneFrame.WORLD);
        }
        Bvh bvh = Bvh.build(spheres);
        BvhQuery scratch = new BvhQuery(new int[spheres.length], new long[1]);
        int[] count = new int[2];
        for (int i = 0; i < 400; i++) {
            SpherePrimitive start = (SpherePrimitive) spheres[i % spheres.length];
            Vec3 from = start.center().plus(random.vector(1).normalized().times(0.6));
            Vec3 to = random.vector(12);
            int side = i % 2 == 0 ? Ray.OUTSIDE : Ray.INSIDE;
            BallCone cone = new BallCone();
            cone.set(to.x(), to.y(), to.z(), 0.5, from.x(), from.y(), from.z());
            bvh.narrow(cone, id -> ConeJudge.MAY_BLOCK, 20, scratch);
            for (int j = 0; j < 20; j++) {
                Ray ray = Ray.leaving(from, to.plus(random.vector(0.28)).minus(from), start, side);
                if (j % 3 == 0) {
                    ray.alsoFrom(spheres[j], Ray.OUTSIDE);
                }
                boolean blocked = false;
                for (Primitive p : spheres) {
                    blocked |= p.nearest(ray, 1) <= 1;
                }
                assertEquals(blocked, bvh.occludedWithin(ray, 1, scratch));
                count[blocked ? 1 : 0]++;
            }
        }
        assertTrue(count[0] > 500 && count[1] > 500, count[0] + " " + count[1]);
    }

    @Test
    void anEmptyHierarchyHasABoxAndNothingInIt() {
        Bvh bvh = Bvh.build(new Primitive[0]);
        assertEquals(Bounds.of(Vec3.ZERO), bvh.bounds());
        BallCone cone = new BallCone();
        cone.set(0, 0, 3, 1, 0, 0, 0);
        assertEquals(0, bvh.narrow(cone, id -> ConeJudge.MAY_BLOCK, 2, query));
    }
}
