package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.color.Rgb;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Many points at once are the same points. */
class ScatteringBatchTest {
    private static final int SIZE = 41;

    static Stream<Bsdf> surfaces() {
        Fresnel gold = Fresnel.conductor(new Rgb(0.143, 0.375, 1.442), new Rgb(3.983, 2.386, 1.603));
        Fresnel noMetal = Fresnel.conductor(new Rgb(1.5, 2.4, 0.8), new Rgb(0.2, 0, 0.1));
        return Stream.of(
                new GlossyReflection(0.05, gold, false),
                new GlossyReflection(0.3, gold, true),
                new GlossyReflection(1, noMetal, false),
                new GlossyReflection(0.5, Fresnel.SCHLICK, true),
                new RoughDiffuse(0.7),
                new SmoothCoating(1.5, true),
                new RoughCoating(0.3, 1.5, true),
                Lambert.INSTANCE);
    }

    private static void direct(SplittableRandom random, double[] x, double[] y, double[] z, int n, double turned) {
        double height = turned * random.nextDouble() - (turned - 1);
        double radius = StrictMath.sqrt(1 - height * height);
        double phi = 2 * Math.PI * random.nextDouble();
        x[n] = radius * StrictMath.cos(phi);
        y[n] = radius * StrictMath.sin(phi);
        z[n] = height;
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void eachIsWhatItIsAlone(Bsdf bsdf) {
        ScatteringBatch batch = new ScatteringBatch(SIZE);
        SplittableRandom random = new SplittableRandom(7);
        Scattering[] alone = new Scattering[SIZE];
        for (int n = 0; n < SIZE; n++) {
            // Normals are upwards; o is above, i a fifth of the time below.
            batch.nz[n] = 1;
            direct(random, batch.ox, batch.oy, batch.oz, n, 1);
            direct(random, batch.ix, batch.iy, batch.iz, n, 1.25);
            batch.red[n] = random.nextDouble();
            batch.green[n] = 1;
            batch.blue[n] = 0;
            alone[n] = new Scattering();
            batch.get(n, alone[n]);
            bsdf.evaluate(alone[n]);
            batch.pdf[n] = -1;
        }
        bsdf.evaluate(batch, 3, SIZE - 2);
        for (int n = 0; n < SIZE; n++) {
            boolean isAsked = n >= 3 && n < SIZE - 2;
            String what = "point " + n;
            assertEquals(isAsked ? alone[n].pdf : -1, batch.pdf[n], 1e-12 * alone[n].pdf, what);
            if (isAsked) {
                assertEquals(alone[n].valueR, batch.valueR[n], 1e-12 * alone[n].valueR, what);
                assertEquals(alone[n].valueG, batch.valueG[n], 1e-12 * alone[n].valueG, what);
                assertEquals(alone[n].valueB, batch.valueB[n], 1e-12 * alone[n].valueB, what);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void wherePointsCoincideNothingIsReflected(Bsdf bsdf) {
        ScatteringBatch batch = new ScatteringBatch(1);
        batch.oz[0] = 1;
        batch.nz[0] = 1;
        bsdf.evaluate(batch, 0, 1);
        assertEquals(0, batch.pdf[0]);
        assertEquals(0, batch.valueR[0]);
        assertEquals(0, batch.valueG[0]);
    }
}
