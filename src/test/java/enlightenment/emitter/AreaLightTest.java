package enlightenment.emitter;

import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import enlightenment.primitive.MeshPrimitive;
import enlightenment.primitive.Primitive;
import enlightenment.sampling.ChiSquare;
import enlightenment.sampling.RunningStatistics;
import enlightenment.world.Descriptions;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Samples, densities and closed forms of lights against each other, and against what rays find of the placed surfaces. */
class AreaLightTest {
    private static final int SAMPLES = 10_000;
    private static final int RINGS = 4;
    private static final int SECTORS = 8;

    private final SplittableRandom random = new SplittableRandom(11);

    static Stream<SeenLight> lights() {
        return SeenLights.all().stream();
    }

    @Test
    void everyKindOfPrimitiveAndOfLightIsTried() {
        // A mesh that glows becomes triangles before it becomes lights.
        assertEquals(
                Descriptions.kinds(Primitive.class)
                        .filter(kind -> kind != MeshPrimitive.class)
                        .collect(toSet()),
                lights().map(SeenLight::primitiveKind).collect(toSet()));
        assertEquals(
                Descriptions.kinds(AreaLight.class).collect(toSet()),
                lights().map(seen -> seen.light.getClass()).collect(toSet()));
    }

    private void sample(SeenLight seen) {
        seen.light.sample(seen.sample, random.nextDouble(), random.nextDouble());
    }

    @ParameterizedTest
    @MethodSource("lights")
    void theDensityOfASampleIsThatOfWhereItMeetsTheLight(SeenLight seen) {
        LightSample s = seen.sample;
        int lost = 0;
        for (int k = 0; k < 2_000; k++) {
            sample(seen);
            if (s.pdf == 0) {
                continue;
            }
            assertEquals(1, s.dx * s.dx + s.dy * s.dy + s.dz * s.dz, 1e-14);
            double same = seen.light.pdf(s, s.dx, s.dy, s.dz, s.length, s.cosine);
            assertEquals(s.pdf, same, 1e-12 * s.pdf);
            seen.trace(s.dx, s.dy, s.dz);
            if (seen.crossings == 0) {
                lost++;
            } else if (seen.crossings == 1) {
                assertEquals(s.pdf, seen.density, 1e-6 * s.pdf, seen.name);
            } else {
                assertTrue(seen.density > s.pdf * (1 - 1e-6));
            }
        }
        assertTrue(lost <= 4, lost + " directions miss what they were sampled on by rounding");
    }

    @ParameterizedTest
    @MethodSource("lights")
    void samplesAreDistributedAsTheirDensitySaysAndItIsOneInAll(SeenLight seen) {
        int directions = 10 * SAMPLES;
        double[] expected = new double[RINGS * SECTORS];
        RunningStatistics all = new RunningStatistics();
        for (int k = 0; k < directions; k++) {
            seen.choose(random);
            seen.trace(seen.x, seen.y, seen.z);
            double p = seen.density * seen.coneAngle();
            expected[seen.cell(seen.x, seen.y, seen.z, RINGS, SECTORS)] += p * SAMPLES / directions;
            all.add(p);
        }
        int[] counts = new int[RINGS * SECTORS];
        int absent = 0;
        for (int k = 0; k < SAMPLES; k++) {
            sample(seen);
            if (seen.sample.pdf == 0) {
                absent++;
            } else {
                counts[seen.cell(seen.sample.dx, seen.sample.dy, seen.sample.dz, RINGS, SECTORS)]++;
            }
        }
        double share = (double) absent / SAMPLES;
        double error = Math.sqrt(share * (1 - share) / SAMPLES);
        assertEquals(1 - share, all.mean(), 4 * (all.standardError() + error) + 1e-12, seen.name);
        pool(expected, counts);
        ChiSquare.check(expected, counts, seen.name);
    }

    /** Cells that expect too few are counted with the fullest one. */
    static void pool(double[] expected, int[] counts) {
        int fullest = 0;
        for (int k = 1; k < expected.length; k++) {
            fullest = expected[k] > expected[fullest] ? k : fullest;
        }
        for (int k = 0; k < expected.length; k++) {
            if (expected[k] < 50 && k != fullest) {
                expected[fullest] += expected[k];
                counts[fullest] += counts[k];
                expected[k] = 5;
                counts[k] = 5;
            }
        }
    }

    @ParameterizedTest
    @MethodSource("lights")
    void theIrradianceOfSamplesIsThatOfDirectionsAndOfTheClosedForm(SeenLight seen) {
        LightSample s = seen.sample;
        Vec3 axis = new Vec3(s.cone.wx, s.cone.wy, s.cone.wz);
        Vec3 across = axis.cross(new Vec3(0.3, 0.5, -0.8)).normalized();
        // All of it above the horizon, and some.
        for (Vec3 n : new Vec3[] {
            axis,
            axis.times(s.cone.sine * 0.3).plus(across).normalized(),
            axis.times(0.6).plus(across.times(-0.8))
        }) {
            RunningStatistics sampled = new RunningStatistics();
            RunningStatistics directed = new RunningStatistics();
            for (int k = 0; k < SAMPLES; k++) {
                sample(seen);
                double cosine = Math.max(n.x() * s.dx + n.y() * s.dy + n.z() * s.dz, 0);
                sampled.add(s.pdf > 0 ? cosine / s.pdf : 0);
            }
            double closed = seen.light.irradiance(s, n.x(), n.y(), n.z());
            if (!Double.isNaN(closed)) {
                assertEquals(closed, sampled.mean(), 4 * sampled.standardError() + 1e-12 * closed, seen.name);
            }
            for (int k = 0; k < SAMPLES; k++) {
                seen.choose(random);
                seen.trace(seen.x, seen.y, seen.z);
                double cosine = Math.max(n.x() * seen.x + n.y() * seen.y + n.z() * seen.z, 0);
                directed.add(seen.crossings * cosine * seen.coneAngle());
            }
            double error = 4.5 * Math.hypot(sampled.standardError(), directed.standardError());
            assertEquals(directed.mean(), sampled.mean(), error + 1e-12 * sampled.mean(), seen.name);
        }
    }
}
