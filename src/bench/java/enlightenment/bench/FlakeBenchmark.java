package enlightenment.bench;

import enlightenment.accel.Bvh;
import enlightenment.accel.BvhQuery;
import enlightenment.accel.Closest;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Searching the hierarchy of a flake of 7,381 spheres: each carries nine of a third of its radius. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FlakeBenchmark {
    private static final int SIDE = 32;
    private static final Vec3 EYE = new Vec3(2.1, 1.3, 1.7);
    private static final Vec3 LIGHT = new Vec3(4, 3, 2);

    private final List<Primitive> spheres = new ArrayList<>();
    private Bvh bvh;
    private Closest closest;
    private BvhQuery query;
    private final Ray[] coherent = new Ray[SIDE * SIDE];
    private final Ray[] incoherent = new Ray[SIDE * SIDE];
    private final Ray[] shadow = new Ray[SIDE * SIDE];

    private void grow(Vec3 center, double radius, Vec3 pole, int depth) {
        spheres.add(Primitives.place(
                Sphere.of(ExactPoint.of(center.x(), center.y(), center.z()), radius), SceneFrame.WORLD));
        Vec3 a = pole.cross(Math.abs(pole.x()) < 0.6 ? Vec3.X : Vec3.Y).normalized();
        Vec3 b = pole.cross(a);
        double latitude = Math.asin(2 / Math.sqrt(6));
        for (int k = 0; k < 9 && depth > 0; k++) {
            double up = k < 6 ? 0 : latitude;
            double turn = k < 6 ? k * Math.PI / 3 : Math.PI / 6 + (k - 6) * 2 * Math.PI / 3;
            Vec3 d = a.times(Math.cos(up) * Math.cos(turn))
                    .plus(b.times(Math.cos(up) * Math.sin(turn)))
                    .plus(pole.times(Math.sin(up)));
            grow(center.plus(d.times(radius * 4 / 3)), radius / 3, d, depth - 1);
        }
    }

    @Setup
    public void setUp() {
        grow(Vec3.ZERO, 0.5, Vec3.Z, 4);
        Primitive[] all = spheres.toArray(Primitive[]::new);
        bvh = Bvh.build(all);
        closest = new Closest(new int[all.length], new long[1]);
        query = new BvhQuery(new int[all.length], new long[1]);
        Random random = new Random(1);
        Vec3 right = new Vec3(-EYE.y(), EYE.x(), 0).normalized().times(0.6);
        Vec3 up = right.cross(EYE).normalized().times(0.6);
        Hit hit = new Hit();
        for (int i = 0; i < coherent.length; i++) {
            Vec3 at;
            do {
                // Where nothing is met, another ray is taken.
                at = right.times((i % SIDE + random.nextDouble()) / SIDE - 0.5)
                        .plus(up.times((i / SIDE + random.nextDouble()) / SIDE - 0.5));
                coherent[i] = Ray.of(EYE, at.minus(EYE).normalized());
            } while (bvh.closest(coherent[i], closest) < 0);
            all[closest.id()].complete(coherent[i], closest.t(), hit);
            Vec3 d = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
            d = d.dot(hit.normal()) < 0 ? d.times(-1) : d;
            incoherent[i] = Ray.leaving(hit.point(), d, hit.primitive, Ray.OUTSIDE);
            shadow[i] = Ray.leaving(hit.point(), LIGHT.minus(hit.point()), hit.primitive, Ray.OUTSIDE);
        }
    }

    private double search(Ray[] rays) {
        double sum = 0;
        for (Ray ray : rays) {
            sum += bvh.closest(ray, closest);
        }
        return sum;
    }

    /** Microseconds for 1,024 camera rays that meet the flake, side by side. */
    @Benchmark
    public double coherent() {
        return search(coherent);
    }

    /** Microseconds for 1,024 rays from those hits in all directions. */
    @Benchmark
    public double incoherent() {
        return search(incoherent);
    }

    /** Microseconds for 1,024 rays from those hits to a light. */
    @Benchmark
    public int shadow() {
        int blocked = 0;
        for (Ray ray : shadow) {
            blocked += bvh.occluded(ray, 1, query) ? 1 : 0;
        }
        return blocked;
    }
}
