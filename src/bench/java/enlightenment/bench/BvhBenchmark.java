package enlightenment.bench;

import enlightenment.accel.Bvh;
import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The hierarchy of boxes: building it over spheres that fill a cube by a hundredth, and searching it with 1,024 rays. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class BvhBenchmark {
    private static final int RAYS = 1024;

    @Param({"100", "10000", "1000000"})
    public int spheres;

    private Primitive[] primitives;
    private Bvh bvh;
    private Closest closest;
    private BvhQuery query;
    private final Ray[] rays = new Ray[RAYS];

    @Setup
    public void setUp() {
        Random r = new Random(1);
        double radius = Math.cbrt(0.01 * 3 / (4 * Math.PI * spheres));
        primitives = new Primitive[spheres];
        for (int i = 0; i < spheres; i++) {
            primitives[i] = Primitives.place(
                    Sphere.of(ExactPoint.of(r.nextDouble(), r.nextDouble(), r.nextDouble()), radius), SceneFrame.WORLD);
        }
        bvh = Bvh.build(primitives);
        closest = new Closest(new int[spheres], new long[1]);
        query = new BvhQuery(new int[spheres], new long[1]);
        for (int i = 0; i < RAYS; i++) {
            Vec3 from = new Vec3(r.nextDouble(), r.nextDouble(), -2);
            Vec3 to = new Vec3(r.nextDouble(), r.nextDouble(), 1);
            rays[i] = Ray.of(from, to.minus(from).normalized());
        }
    }

    /** Microseconds for one hierarchy. */
    @Benchmark
    public Bvh build() {
        return Bvh.build(primitives);
    }

    /** Microseconds for 1,024 searches for the closest sphere. */
    @Benchmark
    public double closest() {
        double sum = 0;
        for (Ray ray : rays) {
            bvh.closest(ray, closest);
            sum += closest.id();
        }
        return sum;
    }

    /** Microseconds for 1,024 questions whether anything is in the way. */
    @Benchmark
    public int occluded() {
        int blocked = 0;
        for (Ray ray : rays) {
            query.clear();
            blocked += bvh.occluded(ray, Double.MAX_VALUE, query) ? 1 : 0;
        }
        return blocked;
    }
}
