package enlightenment.transport.ray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Cancellation ends a path early, however long it is and however many light points it takes. */
class CancelledPathTest {
    private static final String SCENE =
            """
            {
              "image": { "width": 4, "height": 4 },
              "camera": { "type": "perspective", "eye": [0.1, 0.2, 0], "lookAt": [1, 0, 0], "up": [0, 1, 0],
                          "fieldOfView": 40 },
              "shading": { "maxBounces": 1000000 },
              "materials": { "wall": { "type": "WALL", "color": "#ffffff" } },
              "lights": [ { "type": "sphere", "center": [0, 5, 0], "radius": 3.9, "color": "#ffffff" },
                          { "type": "rectangle", "color": "#ffffff",
                            "corners": [[-0.5, 0.8, -0.1], [-0.5, 0.8, 0.1], [-0.3, 0.8, 0.1], [-0.3, 0.8, -0.1]] } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "wall" } ]
            }
            """;

    private final Ray ray = new Ray();
    private final SobolSampler address = new SobolSampler();
    private final double[] color = new double[3];
    private CompiledScene compiled;
    private RayCounters counters;

    private ClassicShader shader(String wall, int lightPoints) {
        // A light within a ball of mirror would end most paths.
        String text = wall.equals("mirror") ? SCENE.replace(" 0.8,", " 8,") : SCENE;
        Scene scene = SceneReader.readString(text.replace("WALL", wall), Path.of("."), "");
        compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        counters = new RayCounters(compiled.kindNames.size());
        ClassicShader shader = new ClassicShader(compiled, lightPoints, counters);
        shader.beginTile(0, 0, 1, 1);
        return shader;
    }

    private void shade(ClassicShader shader, int sample) {
        address.pixel(1, 2, 2);
        address.sample(sample);
        compiled.camera.ray(0.4, 0.6, ray);
        shader.shade(ray, address, color);
    }

    @Test
    void aMillionBouncesAreNotFollowedToTheEnd() {
        ClassicShader shader = shader("mirror", 1);
        shader.stopWhen(() -> true);
        assertThrows(CancellationException.class, () -> shade(shader, 0));
        assertTrue(counters.mirrorRays <= Poll.INTERVAL, counters.mirrorRays + " bounces");
        // Later, in the same number of steps.
        AtomicInteger polled = new AtomicInteger();
        shader.stopWhen(() -> polled.incrementAndGet() >= 5);
        long before = counters.mirrorRays;
        assertThrows(CancellationException.class, () -> shade(shader, 0));
        assertTrue(counters.mirrorRays - before <= 5 * Poll.INTERVAL, counters.mirrorRays + " bounces");
        assertEquals(5, polled.get());
    }

    @Test
    void aMillionLightPointsAreNotAllSampled() {
        ClassicShader shader = shader("matte", 1_000_000);
        shader.stopWhen(() -> true);
        assertThrows(CancellationException.class, () -> shade(shader, 0));
        assertTrue(counters.shadowRays <= Poll.INTERVAL, counters.shadowRays + " rays");
    }

    @Test
    void shortPathsShareOnePollingInterval() {
        ClassicShader shader = shader("matte", 1);
        shader.stopWhen(() -> true);
        int shaded = 0;
        try {
            while (shaded <= Poll.INTERVAL) {
                shade(shader, shaded);
                shaded++;
            }
        } catch (CancellationException e) {
            assertTrue(shaded < Poll.INTERVAL, shaded + " paths");
            return;
        }
        throw new AssertionError("the condition was never polled");
    }

    @Test
    void pollingChangesNoColour() {
        ClassicShader plain = shader("matte", 5_000);
        shade(plain, 3);
        double[] expected = color.clone();
        ClassicShader polling = shader("matte", 5_000);
        AtomicInteger polled = new AtomicInteger();
        polling.stopWhen(() -> polled.incrementAndGet() < 0);
        shade(polling, 3);
        assertArrayEquals(expected, color);
        assertTrue(polled.get() > 0);
    }
}
