package enlightenment.shading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.compiled.CompiledLight;
import enlightenment.compiled.Descriptions;
import enlightenment.compiled.SceneCompiler;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sobol;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The sampler knows every kind of light. */
class LightSamplerTest {
    private static final int COUNT = 256;

    static Stream<Light> lights() {
        return Descriptions.LIGHTS.stream();
    }

    /** The light as it is seen from the eye, which is the origin of the frame. */
    private static CompiledLight compile(Light light) {
        Scene scene = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 1), Vec3.Y, 40))
                .light(light)
                .build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene)).lights[0];
    }

    @ParameterizedTest
    @MethodSource("lights")
    void everyLightPointLiesOnTheLight(Light light) {
        CompiledLight compiled = compile(light);
        LightSampler sampler = new LightSampler();
        sampler.aim(compiled, 0, 0, 0);
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = 0;
        for (int i = 0; i < COUNT; i++) {
            sampler.sample(Sobol.x(i, 3), Sobol.y(i, 3));
            Vec3 d = new Vec3(sampler.dx, sampler.dy, sampler.dz);
            Vec3 p = d.times(sampler.length);
            assertEquals(1, d.length(), 4 * Math.ulp(1.0), light.type());
            if (compiled.surface == null) {
                assertEquals(
                        0, p.minus(new Vec3(compiled.x, compiled.y, compiled.z)).length(), 1e-15, light.type());
            } else {
                assertTrue(compiled.surface.support(0).passes(p, 1e-14), light.type());
                double t = compiled.surface.nearest(Ray.of(Vec3.ZERO, d), Double.MAX_VALUE);
                // A ray to the very rim may miss the light by rounding.
                assertTrue(t == Primitive.MISS || Math.abs(t - sampler.length) <= 1e-7 * t, light.type());
            }
            Vec3 center = new Vec3(compiled.ballX, compiled.ballY, compiled.ballZ);
            double off = p.minus(center).length();
            assertTrue(off <= compiled.ballRadius + 1e-14, light.type());
            nearest = Math.min(nearest, sampler.length);
            farthest = Math.max(farthest, sampler.length);
        }
        // The samples cover the light: those of one with an extent do not all coincide.
        assertEquals(sampler.isPoint(), farthest - nearest <= 1e-15, light.type());
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aLightIsBelowTheHorizonOfTheNormalThatPointsAwayFromIt(Light light) {
        LightSampler sampler = new LightSampler();
        sampler.aim(compile(light), 0, 0, 0);
        assertTrue(sampler.isBelow(0, 0, -1), light.type());
        assertTrue(!sampler.isBelow(0, 0, 1), light.type());
        // A closed form of the mean cosine is that of the samples.
        double mean = sampler.meanCosine(0, 0, 1);
        double sum = 0;
        for (int i = 0; i < COUNT; i++) {
            sampler.sample(Sobol.x(i, 5), Sobol.y(i, 5));
            assertTrue(sampler.dz > 0, light.type());
            sum += sampler.dz;
        }
        boolean closed = !(light instanceof Light.Rectangle);
        assertEquals(closed, mean == mean, light.type());
        assertEquals(closed ? mean : sum / COUNT, sum / COUNT, 1e-3, light.type());
    }
}
