package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Sphere;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** Russian roulette ends paths by what surfaces take of them, not by the glass that they have passed. */
class RouletteTest {
    private static final int SAMPLES = 4096;

    /**
     * A dark ball in white surroundings, behind two cubes of glass. It is convex, and glass takes nothing: each path ends in the surroundings,
     * but for the hundredth that roulette ends at each interface from the fifth event on.
     */
    private static Scene darkBallBehindGlass() {
        Scene.Builder scene = Scene.builder()
                .size(1, 1)
                .shading(new Shading.Physical(OptionalInt.empty(), new Rgb(1, 1, 1)))
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, 9), ExactPoint.of(0, 0, 0), Vec3.Y, 4))
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), Material.Matte.of(PathIntegratorTest.grey(0.1)));
        for (int z : new int[] {4, 6}) {
            scene.object(
                    new Cube(ExactPoint.of(0, 0, z), 0.75 * Math.sqrt(3), Vec3.ZERO),
                    Glass.of(PathIntegratorTest.grey(1), 1.5));
        }
        return scene.build();
    }

    @Test
    void aDarkSurfaceIsSeenThroughGlassWithoutPathsThatEndThere() {
        Scene scene = darkBallBehindGlass();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        PathIntegrator tracer = new PathIntegrator(compiled, new RayCounters(compiled.kindNames.size()));
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        sampler.pixel(5, 0, 0);
        Ray ray = new Ray();
        double[] out = new double[3];
        int black = 0;
        for (int s = 0; s < SAMPLES; s++) {
            sampler.sample(s);
            compiled.camera.ray(sampler.filmX(), sampler.filmY(), ray);
            tracer.shade(ray, sampler, out);
            black += out[0] == 0 ? 1 : 0;
        }
        assertTrue(black < 0.1 * SAMPLES, black + " of " + SAMPLES + " paths bring no light");
    }
}
