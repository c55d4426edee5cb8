import enlightenment.emitter.AreaLight;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.LightSampler;
import enlightenment.emitter.ParallelogramLight;
import enlightenment.emitter.SampledLight;
import enlightenment.emitter.SphereLight;
import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The relative variance that the choice of a light adds where all lights are in full view:
 *
 * <pre>
 * java -cp target/enlightenment.jar src/bench/scripts/LightChoiceVariance.java
 * </pre>
 *
 * With cᵢ what light i contributes and pᵢ its probability, Σ cᵢ²/pᵢ/(Σ cᵢ)² − 1: medians over random receivers among random lights in a
 * cube.
 */
public final class LightChoiceVariance {
    private static final int SETS = 10;
    private static final int RECEIVERS = 1000;

    private final SplittableRandom random = new SplittableRandom(1);
    private final SampledLight choice = new SampledLight();
    private final LightSample sample = new LightSample();

    private LightChoiceVariance() {}

    public static void main(String[] arguments) {
        System.out.println("| lights | spheres | rectangles | both |\n|---|---|---|---|");
        for (int count : new int[] {2, 4, 8, 16, 17, 50, 300}) {
            StringBuilder line = new StringBuilder("| " + count + " |");
            for (int kind = 0; kind < 3; kind++) {
                line.append(String.format(" %.3g |", new LightChoiceVariance().median(count, kind)));
            }
            System.out.println(line);
        }
    }

    private double median(int count, int kind) {
        List<Double> all = new ArrayList<>();
        for (int set = 0; set < SETS; set++) {
            AreaLight[] lights = new AreaLight[count];
            double[] strengths = new double[count];
            LightSampler.Builder builder = new LightSampler.Builder();
            for (int i = 0; i < count; i++) {
                lights[i] = kind == 0 || kind == 2 && i % 2 == 0 ? ball() : rectangle();
                strengths[i] = 0.1 + 2 * random.nextDouble();
                builder.add(lights[i], strengths[i]);
            }
            LightSampler picker = builder.build();
            for (int k = 0; k < RECEIVERS; k++) {
                double variance = variance(picker, lights, strengths, place(), direction());
                if (variance == variance) {
                    all.add(variance);
                }
            }
        }
        double[] sorted = all.stream().mapToDouble(v -> v).sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /** Not a number where there is no light. */
    private double variance(LightSampler picker, AreaLight[] lights, double[] strengths, Vec3 p, Vec3 n) {
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < lights.length; i++) {
            lights[i].aim(sample, p.x(), p.y(), p.z());
            double c = strengths[i] * lights[i].irradiance(sample, n.x(), n.y(), n.z());
            if (c > 0) {
                double probability = picker.probability(i, p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), choice);
                sum += c;
                squares += c * c / probability;
            }
        }
        return squares / (sum * sum) - 1;
    }

    private AreaLight ball() {
        return new SphereLight(place(), 0.01 + random.nextDouble());
    }

    private AreaLight rectangle() {
        Vec3 p = direction();
        Vec3 q = p.cross(direction()).normalized();
        return new ParallelogramLight(
                place(), p.times(0.1 + random.nextDouble()), q.times(0.1 + random.nextDouble()), false);
    }

    private Vec3 place() {
        return new Vec3(10 * signed(), 10 * signed(), 10 * signed());
    }

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private Vec3 direction() {
        while (true) {
            Vec3 v = new Vec3(signed(), signed(), signed());
            double square = v.dot(v);
            if (square > 1e-3 && square <= 1) {
                return v.normalized();
            }
        }
    }
}
