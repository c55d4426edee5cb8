package enlightenment.toy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AmbientOcclusionTest {
    private static final int SIDE = 4;
    private static final int ANTIALIAS = 8;
    private static final int RAYS = 16;
    private static final double HEIGHT = 1.5;

    /**
     * A ball of radius 1, wholly above the floor, takes cosθ/d² of the hemisphere of a point at distance d from its centre, weighted by
     * the cosine (Nusselt): a fraction h/d³ where its centre is at height h.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1.1, 1.5, 2.5, 6})
    void aBallAboveAFloorHidesItsFormFactorOfTheSky(double aside) {
        double d = Math.hypot(HEIGHT, aside);
        double open = 1 - HEIGHT / (d * d * d);
        double sigma = Math.sqrt(open * (1 - open) / (SIDE * SIDE * ANTIALIAS * ANTIALIAS * RAYS));
        Scene scene = SceneReader.readString(
                """
                { "image": { "width": 4, "height": 4 },
                  "camera": { "type": "orthographic", "eye": [ASIDE, 9, 0], "lookAt": [ASIDE, 0, 0], "up": [0, 0, 1], "height": 1e-3 },
                  "objects": [
                    { "type": "sphere", "center": [0, 1.5, 0], "radius": 1, "material": { "type": "matte", "color": "#ffffff" } },
                    { "type": "rectangle", "corners": [[-99, 0, -99], [-99, 0, 99], [99, 0, 99], [99, 0, -99]],
                      "material": { "type": "matte", "color": "#ffffff" } } ] }
                """
                        .replace("ASIDE", Double.toString(aside)),
                Path.of(""),
                "");
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(Method.named(AmbientOcclusion.WORD))
                .with(new AmbientOcclusion.Settings(RAYS))
                .withAntialias(ANTIALIAS);
        assertEquals(open, mean(Renderer.render(scene, settings)), 5 * sigma);
    }

    private static double mean(Image image) {
        double sum = 0;
        for (float v : image.toArray()) {
            sum += v;
        }
        return sum / image.toArray().length;
    }
}
