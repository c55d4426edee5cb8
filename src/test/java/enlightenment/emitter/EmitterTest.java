package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sobol;
import enlightenment.world.Descriptions;
import enlightenment.world.light.ClassicLight;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every kind of light is sampled. */
class EmitterTest {
    private static final int COUNT = 256;

    static Stream<Light> lights() {
        return Descriptions.LIGHTS.stream().filter(Light::isForClassicShading);
    }

    @ParameterizedTest
    @MethodSource("lights")
    void everyLightPointLiesOnTheLight(Light light) {
        ClassicLight compiled = Views.compile(light);
        Emitter emitter = compiled.emitter;
        EmitterView view = Views.fromOrigin(emitter);
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = 0;
        for (int i = 0; i < COUNT; i++) {
            emitter.sample(view, Sobol.x(i, 3), Sobol.y(i, 3));
            Vec3 d = new Vec3(view.dx, view.dy, view.dz);
            Vec3 p = d.times(view.length);
            assertEquals(1, d.length(), 4 * Math.ulp(1.0), light.type());
            if (compiled.surface == null) {
                assertEquals(
                        0, p.minus(new Vec3(compiled.x, compiled.y, compiled.z)).length(), 1e-15, light.type());
            } else {
                assertTrue(compiled.surface.support(0).passes(p, 1e-14), light.type());
                double t = compiled.surface.nearest(Ray.of(Vec3.ZERO, d), Double.MAX_VALUE);
                // A ray to the very rim may miss the light by rounding.
                assertTrue(t == Primitive.MISS || Math.abs(t - view.length) <= 1e-7 * t, light.type());
            }
            Vec3 center = new Vec3(compiled.ballX, compiled.ballY, compiled.ballZ);
            double off = p.minus(center).length();
            assertTrue(off <= compiled.ballRadius + 1e-14, light.type());
            nearest = Math.min(nearest, view.length);
            farthest = Math.max(farthest, view.length);
        }
        // The samples cover the light: those of one with an extent do not all coincide.
        assertEquals(emitter.isDelta(), farthest - nearest <= 1e-15, light.type());
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aLightIsBelowTheHorizonOfTheNormalThatPointsAwayFromIt(Light light) {
        Emitter emitter = Views.compile(light).emitter;
        EmitterView view = Views.fromOrigin(emitter);
        assertEquals(0, emitter.meanCosine(view, 0, 0, -1), light.type());
        assertTrue(emitter.meanCosine(view, 0, 0, 1) != 0, light.type());
        // A closed form of the mean cosine is that of the samples.
        double mean = emitter.meanCosine(view, 0, 0, 1);
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            emitter.sample(view, Sobol.x(i, 5), Sobol.y(i, 5));
            assertTrue(view.dz > 0, light.type());
            sum += view.dz;
        }
        boolean closed = !(light instanceof Light.Rectangle);
        assertEquals(closed, mean == mean, light.type());
        assertEquals(closed ? mean : sum / COUNT, sum / COUNT, 1e-3, light.type());
    }
}
