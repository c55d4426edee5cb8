package enlightenment.bench;

import enlightenment.emitter.AreaLight;
import enlightenment.emitter.DiskLight;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.LightSampler;
import enlightenment.emitter.ParallelogramLight;
import enlightenment.emitter.SampledLight;
import enlightenment.emitter.SphereLight;
import enlightenment.emitter.TriangleLight;
import enlightenment.math.Vec3;
import enlightenment.sampling.Hash;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** What direct light of a light costs at a receiver, and the choice among several. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class LightBenchmark {
    private static final int COUNT = 1024;

    private final double[] receivers = new double[3 * COUNT];
    private final LightSample sample = new LightSample();
    private final SampledLight choice = new SampledLight();

    @Setup
    public void setUp() {
        for (int i = 0; i < receivers.length; i++) {
            receivers[i] = Hash.unit(Hash.of(5, i));
        }
    }

    /** A light of each kind above the receivers, which lie in the unit cube. */
    @State(Scope.Thread)
    public static class Kind {
        @Param({"sphere", "cutSphere", "rectangle", "farRectangle", "cutRectangle", "triangle", "disk"})
        public String kind;

        AreaLight light;

        @Setup
        public void setUp() {
            Vec3 p = new Vec3(0.2, 2, 0.2);
            Vec3 q = new Vec3(0.9, 2, 0.2);
            Vec3 r = new Vec3(0.2, 2, 0.8);
            light = switch (kind) {
                case "sphere" -> new SphereLight(new Vec3(0.5, 2, 0.5), 0.3);
                case "cutSphere" -> new SphereLight(new Vec3(4, 0.5, 0.5), 0.8);
                case "rectangle" -> new ParallelogramLight(p, new Vec3(0.5, 0, 0), new Vec3(0, 0, 0.5), true);
                case "farRectangle" -> new ParallelogramLight(p, new Vec3(1e-3, 0, 0), new Vec3(0, 0, 1e-3), true);
                case "cutRectangle" ->
                    new ParallelogramLight(new Vec3(3, -1, 0), new Vec3(0, 3, 0), new Vec3(0, 0, 1), true);
                case "triangle" -> new TriangleLight(p, q, r, true);
                default -> new DiskLight(p, Vec3.Y, 0.4, true);
            };
        }
    }

    /** Many lights around the receivers. */
    @State(Scope.Thread)
    public static class Many {
        @Param({"4", "16", "100", "10000"})
        public int lights;

        LightSampler picker;

        @Setup
        public void setUp() {
            LightSampler.Builder builder = new LightSampler.Builder();
            for (int i = 0; i < lights; i++) {
                Vec3 at = new Vec3(unit(i, 1), unit(i, 2), unit(i, 3));
                builder.add(
                        i % 2 == 0
                                ? new SphereLight(at, 0.01)
                                : new ParallelogramLight(at, new Vec3(0.1, 0, 0), new Vec3(0, 0, 0.1), false),
                        1);
            }
            picker = builder.build();
        }

        private static double unit(int i, int k) {
            return 4 * Hash.unit(Hash.of(k, i)) - 2;
        }
    }

    private void aim(AreaLight light, int i) {
        light.aim(sample, receivers[3 * i], receivers[3 * i + 1], receivers[3 * i + 2]);
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double irradiance(Kind kind) {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            aim(kind.light, i);
            sum += kind.light.irradiance(sample, 0, 1, 0);
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double sample(Kind kind) {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            aim(kind.light, i);
            kind.light.sample(sample, receivers[3 * i], receivers[3 * i + 1]);
            sum += sample.pdf + sample.dx;
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double choose(Many many) {
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            many.picker.choose(
                    receivers[3 * i], receivers[3 * i + 1], receivers[3 * i + 2], 0, 1, 0, receivers[i], choice);
            sum += choice.probability;
        }
        return sum;
    }
}
