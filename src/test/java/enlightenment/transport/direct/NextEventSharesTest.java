package enlightenment.transport.direct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.IncidentLight;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A direction that next-event estimation samples, and a path that goes the same way and hits the light there: both know the same density, so
 * that their weights add up to 1 whatever the density of the BSDF is.
 */
class NextEventSharesTest {
    private static final String GLOWS =
            ", \"material\": { \"type\": \"matte\", \"color\": \"#000000\", \"radiance\": [3, 2, 1] } }";

    /** A floor below, seen by one ray, and around it a light that has nothing in common with it but that its form differs. */
    private static CompiledScene scene(String shape) {
        String text =
                """
                { "image": { "width": 8, "height": 8 }, "shading": { "model": "physical" },
                  "camera": { "type": "orthographic", "eye": [0, 1, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "height": 0.001 },
                  "lights": [
                    { "type": "sphere", "center": [-3, 2, 0.4], "radius": 0.2, "color": "#ffffff", "radiance": [9, 9, 9] } ],
                  "objects": [ { "type": "rectangle", "corners": [[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]],
                    "material": { "type": "glossy", "color": "#ffffff", "roughness": 0.5 } },
                    { "type": SHAPE"""
                        .replace("SHAPE", shape + GLOWS + " ] }");
        Scene scene = SceneReader.readString(text, Path.of(""), "");
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"sphere\", \"center\": [2, 2, 1], \"radius\": 0.7",
                "\"sphere\", \"center\": [0, -3, 0], \"radius\": 8",
                "\"rectangle\", \"corners\": [[1, 0.5, 1], [1, 2, 1], [2, 2, -1], [2, 0.5, -1]]",
                "\"triangle\", \"vertices\": [[1, 0.5, 1], [1, 2, 1], [2, 2, -1]]",
                "\"disk\", \"center\": [2, 2, 1], \"normal\": [-1, -1, 0.2], \"radius\": 0.7",
                "\"cylinder\", \"base\": [2, 1, 1], \"top\": [2, 2, 2], \"radius\": 0.4",
                "\"cone\", \"base\": [2, 1, 1], \"apex\": [2, 2, 2], \"radius\": 0.4",
                "\"torus\", \"center\": [2, 2, 1], \"axis\": [0, 1, 0.3], \"majorRadius\": 0.7, \"minorRadius\": 0.2",
                "\"box\", \"min\": [1, 1, 1], \"max\": [2, 3, 2]"
            })
    void theWeightsOfBothWaysAddUpToOne(String shape) {
        CompiledScene scene = scene(shape);
        RayCounters counters = new RayCounters(scene.kindNames.size());
        PathFollower path = new PathFollower(scene, counters, 9);
        NextEventEstimation direct = new NextEventEstimation(scene, counters, path);
        SobolSampler sampler = new SobolSampler();
        IncidentLight sampled = new IncidentLight();
        PathState state = new PathState();
        Ray ray = new Ray();
        path.tracer.beginTile(0, 0, 1, 1);
        int found = 0;
        for (int k = 0; k < 256; k++) {
            sampler.pixel(7, 0, 0);
            sampler.sample(k);
            scene.camera.ray(0.5, 0.5, ray);
            path.begin(ray);
            assertEquals(PathFollower.Event.SURFACE, path.next(ray));
            direct.sample(sampler, 0, sampled);
            if (!(sampled.density > 0)) {
                continue;
            }
            Scattering s = path.arrive(ray, new double[] {1, 1, 1});
            s.ix = sampled.dx;
            s.iy = sampled.dy;
            s.iz = sampled.dz;
            s.pdf = 0.3 * sampled.density;
            path.leave(ray, s);
            state.begin();
            state.extend(PathEvent.WIDE, s, false);
            double ofSample = PowerHeuristic.weight(s.pdf, sampled.density);
            assertTrue(path.continues());
            assertEquals(PathFollower.Event.SURFACE, path.next(ray));
            int light = path.at.light;
            assertTrue(light >= 0);
            double ofHit = direct.weightOfHit(state, ray, light);
            assertEquals(1, ofSample + ofHit, 1e-6, () -> shape + " by " + sampled.density);
            found++;
        }
        assertTrue(found > 30, found + " samples");
    }
}
