package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which light: probabilities that add up, are the inverse of the choice, and forget no light that contributes. */
class LightSamplerTest {
    private final SplittableRandom random = new SplittableRandom(3);
    private final SampledLight choice = new SampledLight();

    private double signed() {
        return 2 * random.nextDouble() - 1;
    }

    private Vec3 direction() {
        Vec3 v = new Vec3(signed(), signed(), signed());
        return v.lengthSquared() > 1e-3 ? v.normalized() : direction();
    }

    private AreaLight light(int kind) {
        Vec3 at = new Vec3(10 * signed(), 10 * signed(), 10 * signed());
        Vec3 p = direction().times(0.1 + random.nextDouble());
        Vec3 q = direction();
        return switch (kind % 6) {
            case 0 -> new SphereLight(at, 0.01 + random.nextDouble());
            case 1 -> new ParallelogramLight(at, p, q, kind % 4 == 1);
            case 2 -> new TriangleLight(at, at.plus(p), at.plus(q), kind % 4 == 0);
            case 3 -> new DiskLight(at, q, 0.5, kind % 4 == 3);
            case 4 -> new LateralLight(at, p, 0.3, 0.6 * random.nextDouble(), kind % 4 == 0);
            default -> new TorusLight(at, q, 1, 0.3);
        };
    }

    private List<AreaLight> lights(int count) {
        List<AreaLight> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            all.add(light(k));
        }
        return all;
    }

    private static LightSampler picker(List<AreaLight> lights, Vec3 point) {
        LightSampler.Builder b = new LightSampler.Builder();
        for (int k = 0; k < lights.size(); k++) {
            b.add(lights.get(k), 0.1 + k % 7);
        }
        return (point == null ? b : b.addPoint(point, 2)).build();
    }

    private double probability(LightSampler picker, int light, Vec3 p, Vec3 n) {
        return picker.probability(light, p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), choice);
    }

    private void choose(LightSampler picker, Vec3 p, Vec3 n, double number) {
        picker.choose(p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), number, choice);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 15, 17, 200})
    void probabilitiesAddUpToOneUnlessNoLightIsSeen(int count) {
        LightSampler picker = picker(lights(count), new Vec3(1, 2, 3));
        for (int k = 0; k < 300; k++) {
            Vec3 p = new Vec3(12 * signed(), 12 * signed(), 12 * signed());
            Vec3 n = k % 5 == 0 ? Vec3.ZERO : direction();
            double sum = 0;
            for (int i = 0; i < picker.count(); i++) {
                sum += probability(picker, i, p, n);
            }
            double shares = 0;
            int numbers = 512;
            for (int i = 0; i < numbers; i++) {
                double number = (i + 0.5) / numbers;
                choose(picker, p, n, number);
                assertTrue(choice.rest >= 0 && choice.rest < 1);
                if (choice.light >= 0) {
                    shares += 1.0 / numbers;
                    double expected = choice.probability;
                    assertEquals(expected, probability(picker, choice.light, p, n), 1e-13 * expected);
                }
            }
            assertTrue(sum <= 1 + 1e-12);
            assertEquals(sum, shares, count < 17 ? 1e-12 : 0.05);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {12, 60})
    void everyLightIsChosenAsOftenAsItsProbabilitySays(int count) {
        LightSampler picker = picker(lights(count), new Vec3(1, 2, 3));
        for (int k = 0; k < 20; k++) {
            Vec3 p = new Vec3(12 * signed(), 12 * signed(), 12 * signed());
            Vec3 n = k % 5 == 0 ? Vec3.ZERO : direction();
            int numbers = 1 << 14;
            double[] shares = new double[picker.count()];
            for (int i = 0; i < numbers; i++) {
                choose(picker, p, n, (i + 0.5) / numbers);
                if (choice.light >= 0) {
                    shares[choice.light] += 1.0 / numbers;
                }
            }
            for (int i = 0; i < shares.length; i++) {
                // Evenly spaced numbers: a light's interval holds its share of them, up to one at each end.
                assertEquals(probability(picker, i, p, n), shares[i], 2.0 / numbers);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {6, 12, 80})
    void aLightThatContributesCanBeChosen(int count) {
        List<AreaLight> lights = lights(count);
        LightSampler picker = picker(lights, null);
        LightSample s = new LightSample();
        int contributing = 0;
        for (int k = 0; k < 400; k++) {
            Vec3 p = new Vec3(12 * signed(), 12 * signed(), 12 * signed());
            Vec3 n = k % 5 == 0 ? Vec3.ZERO : direction();
            for (int i = 0; i < count; i++) {
                AreaLight light = lights.get(i);
                light.aim(s, p.x(), p.y(), p.z());
                boolean contributes = false;
                for (int j = 0; j < 8; j++) {
                    light.sample(s, random.nextDouble(), random.nextDouble());
                    double cosine = n.maxAbs() == 0 ? 1 : n.x() * s.dx + n.y() * s.dy + n.z() * s.dz;
                    contributes |= s.pdf > 0 && cosine > 0;
                }
                if (contributes) {
                    contributing++;
                    assertTrue(probability(picker, i, p, n) > 0, light + " contributes to " + p + " " + n);
                }
            }
        }
        assertTrue(contributing > 100);
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 90})
    void theOrderOfLightsDoesNotMatter(int count) {
        List<AreaLight> lights = lights(count);
        List<Integer> order = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            order.add(k);
        }
        Collections.shuffle(order, new Random(4));
        LightSampler.Builder a = new LightSampler.Builder();
        LightSampler.Builder b = new LightSampler.Builder();
        for (int k = 0; k < count; k++) {
            a.add(lights.get(k), 1 + k % 3);
            b.add(lights.get(order.get(k)), 1 + order.get(k) % 3);
        }
        LightSampler first = a.build();
        LightSampler second = b.build();
        for (int k = 0; k < 1000; k++) {
            Vec3 p = new Vec3(12 * signed(), 12 * signed(), 12 * signed());
            Vec3 n = direction();
            double number = random.nextDouble();
            choose(first, p, n, number);
            int chosen = choice.light;
            double probability = choice.probability;
            double rest = choice.rest;
            choose(second, p, n, number);
            assertEquals(chosen, choice.light < 0 ? -1 : order.get(choice.light));
            assertEquals(probability, choice.probability);
            assertEquals(rest, choice.rest);
        }
    }

    @Test
    void aSceneWithoutLightsChoosesNone() {
        LightSampler none = new LightSampler.Builder().build();
        choose(none, Vec3.ZERO, Vec3.Y, 0.5);
        assertEquals(-1, choice.light);
        assertEquals(0.5, choice.rest);
    }

    @Test
    void twoBallsAboveTheHorizonAreChosenByTheirIrradiance() {
        SphereLight near = new SphereLight(new Vec3(0, 3, 0), 1);
        SphereLight cut = new SphereLight(new Vec3(4, 0.2, 0), 0.5);
        LightSampler picker =
                new LightSampler.Builder().add(near, 2).add(cut, 5).build();
        LightSample s = new LightSample();
        near.aim(s, 0, 0, 0);
        double a = 2 * near.irradiance(s, 0, 1, 0);
        cut.aim(s, 0, 0, 0);
        double b = 5 * cut.irradiance(s, 0, 1, 0);
        assertEquals(a / (a + b), probability(picker, 0, Vec3.ZERO, Vec3.Y), 1e-15);
        assertEquals(b / (a + b), probability(picker, 1, Vec3.ZERO, Vec3.Y), 1e-15);
    }
}
