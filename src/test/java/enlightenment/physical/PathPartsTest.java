package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.state.PathPart;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Direct and indirect light are two parts of one path, with the same numbers. */
class PathPartsTest {
    private static final Map<String, Scene> SCENES = scenesAndOneInBlackLight();

    private static Map<String, Scene> scenesAndOneInBlackLight() {
        Map<String, Scene> all = new TreeMap<>(PartnerScenes.all());
        all.put("black light", InvarianceScenes.inBlackLight());
        return all;
    }

    private static final int SIDE = 16;

    static Stream<String> scenes() {
        return SCENES.keySet().stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void directAndIndirectLightOfAPathAreAllOfIt(String name) {
        CompiledScene scene = SceneCompiler.compile(SCENES.get(name), RenderSettings.of(SCENES.get(name)));
        RayCounters unread = new RayCounters(scene.kindNames.size());
        PathIntegrator whole = new PathIntegrator(scene, unread);
        PathIntegrator direct = new PathIntegrator(scene, unread, PathPart.DIRECT);
        PathIntegrator indirect = new PathIntegrator(scene, unread, PathPart.INDIRECT);
        SobolSampler sampler = new SobolSampler();
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                sampler.pixel(7, x, y);
                for (int s = 0; s < 4; s++) {
                    sampler.sample(s);
                    double[] all = shade(whole, scene, sampler, x, y);
                    double[] near = shade(direct, scene, sampler, x, y);
                    double[] far = shade(indirect, scene, sampler, x, y);
                    for (int c = 0; c < 3; c++) {
                        assertTrue(near[c] >= 0 && far[c] >= 0, name);
                        assertEquals(all[c], near[c] + far[c], 1e-12 * all[c], name + " at " + x + "," + y);
                    }
                }
            }
        }
    }

    private static double[] shade(PathIntegrator tracer, CompiledScene scene, SobolSampler sampler, int x, int y) {
        Ray ray = new Ray();
        double[] color = new double[3];
        tracer.beginTile(0, 0, 1, 1);
        scene.camera.ray((x + sampler.filmX()) / SIDE, (y + sampler.filmY()) / SIDE, ray);
        tracer.shade(ray, sampler, color);
        return color;
    }
}
