package enlightenment.bench;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Fresnel;
import enlightenment.bsdf.GlossyReflection;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.RoughDielectric;
import enlightenment.bsdf.RoughDiffuse;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.SmoothDielectric;
import enlightenment.color.Rgb;
import java.util.SplittableRandom;
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

/** What a scattered direction costs, for each kind of surface: sampled, or chosen by a light sample. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class BsdfBenchmark {
    private static final int COUNT = 4096;

    @Param({"lambert", "eon", "schlick", "compensated", "metal", "glass", "frosted"})
    public String kind;

    private final double[] numbers = new double[5 * COUNT];
    private final Scattering s = new Scattering();
    private Bsdf bsdf;

    @Setup
    public void setUp() {
        Fresnel gold = Fresnel.conductor(new Rgb(0.14, 0.37, 1.44), new Rgb(3.98, 2.38, 1.6));
        bsdf = switch (kind) {
            case "lambert" -> Lambert.INSTANCE;
            case "eon" -> new RoughDiffuse(0.5);
            case "schlick" -> new GlossyReflection(0.1, Fresnel.SCHLICK, false);
            case "compensated" -> new GlossyReflection(0.1, Fresnel.SCHLICK, true);
            case "metal" -> new GlossyReflection(0.1, gold, true);
            case "glass" -> SmoothDielectric.INSTANCE;
            case "frosted" -> new RoughDielectric(0.1, true);
            default -> throw new IllegalArgumentException(kind);
        };
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = random.nextDouble();
        }
        s.nx = 0.48;
        s.ny = -0.6;
        s.nz = 0.64;
        s.red = 0.8;
        s.green = 0.6;
        s.blue = 0.4;
        s.eta = 1 / 1.5;
        s.radiance = true;
    }

    /** Sets o, on the normal's side. */
    private void look(int k) {
        double x = 2 * numbers[k + 3] - 1;
        double y = 2 * numbers[k + 4] - 1;
        double scale = 1 / Math.sqrt(1 + x * x + y * y);
        s.ox = (s.nx + 0.8 * x * s.ny) * scale;
        s.oy = (s.ny - 0.8 * x * s.nx) * scale;
        s.oz = (s.nz + 0.6 * y) * scale;
        double length = 1 / Math.sqrt(s.ox * s.ox + s.oy * s.oy + s.oz * s.oz);
        s.ox *= length;
        s.oy *= length;
        s.oz *= length;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double sample() {
        double sum = 0;
        for (int k = 0; k < numbers.length; k += 5) {
            look(k);
            if (bsdf.sample(s, numbers[k], numbers[k + 1], numbers[k + 2])) {
                sum += s.valueG + s.pdf;
            }
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(COUNT)
    public double evaluate() {
        double sum = 0;
        s.ix = 0.6;
        s.iy = 0;
        s.iz = 0.8;
        for (int k = 0; k < numbers.length; k += 5) {
            look(k);
            bsdf.evaluate(s);
            sum += s.valueG + s.pdf;
        }
        return sum;
    }
}
