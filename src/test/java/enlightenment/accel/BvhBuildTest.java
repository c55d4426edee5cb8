package enlightenment.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What building and searching cost, in nodes, tests and bytes. */
class BvhBuildTest {
    private static final long MEBIBYTE = 1 << 20;

    private final ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void fiftyTimesTheSpheresTakeFewTimesTheTests() {
        double few = build(1_000);
        double many = build(50_000);
        assertTrue(few > 0);
        // Without a hierarchy it would be fifty times; the depth of the tree grows by log 50 000 / log 1 000 = 1.6.
        assertTrue(many < 5 * few, few + " and " + many + " tests per ray");
    }

    @Test
    @Tag("full")
    void aMillionSpheresTakeNoMoreBytesEach() {
        build(1_000_000);
    }

    /** Tests of spheres per ray. */
    private double build(int n) {
        RandomPrimitives random = new RandomPrimitives(1);
        Primitive[] all = random.spheres(n);
        long bytes = thread.getCurrentThreadAllocatedBytes();
        Bvh bvh = Bvh.build(all);
        long used = thread.getCurrentThreadAllocatedBytes() - bytes;
        int hits = 0;
        long[] tests = new long[1];
        Closest closest = new Closest(new int[n], tests);
        int rays = 50_000;
        for (int i = 0; i < rays; i++) {
            hits += bvh.closest(random.ray(1), closest) >= 0 ? 1 : 0;
        }
        assertTrue(hits > rays / 20 && hits < rays, hits + " hits");
        assertTrue(bvh.nodeCount() < 2 * n, bvh.nodeCount() + " nodes");
        // Everything ever allocated, garbage included: about 6 doubles per box, twice, and the growing node arrays.
        assertTrue(used < 800L * n + MEBIBYTE, used + " bytes");
        return (double) tests[0] / rays;
    }

    @Test
    void searchesDoNotAllocate() {
        RandomPrimitives random = new RandomPrimitives(2);
        Bvh bvh = Bvh.build(random.spheres(1000));
        Ray[] rays = new Ray[1000];
        for (int i = 0; i < rays.length; i++) {
            rays[i] = random.ray(1);
        }
        Closest closest = new Closest(new int[1000], new long[1]);
        BvhQuery query = new BvhQuery(new int[1000], new long[1]);
        int hits = 0;
        long before = 0;
        int rounds = 400;
        for (int round = 0; round < rounds; round++) {
            if (round == rounds - 20) {
                before = thread.getCurrentThreadAllocatedBytes();
            }
            for (Ray ray : rays) {
                hits += bvh.closest(ray, closest) >= 0 ? 1 : 0;
                hits += bvh.occluded(ray, 0.5, query) ? 1 : 0;
            }
        }
        long perRay = (thread.getCurrentThreadAllocatedBytes() - before) / (20L * 2 * rays.length);
        assertTrue(hits > 0);
        assertEquals(0, perRay, "bytes per search once the compiler has warmed up");
    }
}
