package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.material.Glossy;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** By Schlick's approximation a glossy surface whose colour is black reflects at grazing angles: black is no special case. */
class BlackGlossTest {
    private static final int SIDE = 12;

    private static Image image(BuiltInMethod method, double color, double roughness) {
        Scene scene = PhysicalScenes.view(SIDE, SIDE)
                .camera(new Camera.Perspective(at(0, 0.4, -4), at(0, 0.2, 0), Vec3.Y, 30))
                .shading(PhysicalScenes.shading(0.5))
                .object(
                        TestScenes.rectangle(-3, 0, -3, -3, 0, 3, 3, 0, 3, 3, 0, -3),
                        new Glossy(linear(color, color, color), roughness, Optional.empty(), true, Rgb.BLACK))
                .object(ball(0.5, 0.5, 1, 0.5), PhysicalScenes.RED)
                .light(PhysicalScenes.sphereLight(0, 1, 2, 0.3, 10))
                .build();
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(4);
        return Renderer.render(scene, settings);
    }

    @ParameterizedTest
    @CsvSource({
        "RAYTRACE, 0",
        "RAYTRACE, 0.3",
        "CLUSTER, 0",
        "CLUSTER, 0.3",
        "BIDIRECTIONAL, 0",
        "BIDIRECTIONAL, 0.3",
        "LIGHT, 0.3"
    })
    void blackIsTheLimitOfDark(BuiltInMethod method, double roughness) {
        Image black = image(method, 0, roughness);
        Image dark = image(method, 1e-14, roughness);
        double sum = 0;
        for (int k = 0; k < SIDE * SIDE; k++) {
            double there = dark.component(k % SIDE, k / SIDE, 0);
            // The colour decides by roulette in a few of the last bits.
            assertEquals(there, black.component(k % SIDE, k / SIDE, 0), 1e-9 * (1 + there));
            sum += k / SIDE > 2 * SIDE / 3 ? there : 0;
        }
        assertTrue(sum > 0);
    }
}
