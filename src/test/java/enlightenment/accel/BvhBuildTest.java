package enlightenment.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What building and searching cost. Limits are wide, so that a loaded machine passes; the figures are printed. */
class BvhBuildTest {
    private static final long SECOND = 1_000_000_000L;
    private static final long MEBIBYTE = 1 << 20;

    private final ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void aHundredThousandSpheresAreBuiltInASecondOfWork() {
        build(100_000, 4 * SECOND);
    }

    @Test
    @Tag("full")
    void aMillionSpheresAreBuiltInSecondsAndHalfAGibibyte() {
        build(1_000_000, 12 * SECOND);
    }

    private void build(int n, long limit) {
        RandomPrimitives random = new RandomPrimitives(1);
        Primitive[] all = random.spheres(n);
        long bytes = thread.getCurrentThreadAllocatedBytes();
        long start = thread.getCurrentThreadCpuTime();
        Bvh bvh = Bvh.build(all);
        long time = thread.getCurrentThreadCpuTime() - start;
        long used = thread.getCurrentThreadAllocatedBytes() - bytes;
        int hits = 0;
        Closest closest = new Closest(new int[n], new long[1]);
        start = thread.getCurrentThreadCpuTime();
        int rays = 200_000;
        for (int i = 0; i < rays; i++) {
            hits += bvh.closest(random.ray(1), closest) >= 0 ? 1 : 0;
        }
        long search = thread.getCurrentThreadCpuTime() - start;
        System.out.printf(
                "%d spheres: %d nodes, %.2f s, %d MiB; %.2f million rays/s, %d %% hit%n",
                n, bvh.nodeCount(), time / 1e9, used / MEBIBYTE, rays * 1e3 / search, 100L * hits / rays);
        assertTrue(time < limit, "CPU time " + time);
        // Everything ever allocated, garbage included: about 6 doubles per box, twice, and the growing node arrays.
        assertTrue(used < 800L * n + MEBIBYTE, used + " bytes");
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
