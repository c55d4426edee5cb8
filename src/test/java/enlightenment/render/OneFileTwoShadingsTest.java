package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** What only physical shading knows of materials and lights changes nothing of a classic picture. */
class OneFileTwoShadingsTest {
    private static final String BARE =
            """
            {
              "image": { "width": 30, "height": 20 },
              "camera": { "type": "perspective", "eye": [0, 1, -6], "lookAt": [0, 1, 0], "fieldOfView": 40 },
              "materials": {
                "floor": { "type": "matte", "color": "#a0b0c0" },
                "chrome": { "type": "mirror", "color": "#e0e0e0" },
                "pane": { "type": "glass", "color": "#f0fff0", "indexOfRefraction": 1.5, "transparency": 0.75 }
              },
              "lights": [
                { "type": "sphere", "center": [-2, 4, -2], "radius": 0.5, "color": "#ffe0c0" },
                { "type": "rectangle", "corners": [[1, 4, -1], [1, 4, 1], [2, 4, 1], [2, 4, -1]], "color": "#ffffff" },
                { "type": "point", "position": [0, 3, -3], "color": "#404040" }
              ],
              "objects": [
                { "type": "rectangle", "corners": [[-5, 0, -5], [-5, 0, 5], [5, 0, 5], [5, 0, -5]], "material": "floor" },
                { "type": "sphere", "center": [-1, 1, 0], "radius": 1, "material": "chrome" },
                { "type": "sphere", "center": [1, 1, -1], "radius": 0.8, "material": "pane" }
              ],
              "render": { "antialias": 2, "shadowSamples": 4 }
            }
            """;

    private static final String FULL = BARE.replace(
                    "\"#a0b0c0\"", "\"#a0b0c0\", \"roughness\": 0.5, \"radiance\": [3, 2, 1]")
            .replace("\"#e0e0e0\"", "\"#e0e0e0\", \"radiance\": 7")
            .replace(
                    "\"indexOfRefraction\": 1.5",
                    "\"indexOfRefraction\": 1.5, \"roughness\": 0.5, \"absorption\": [1, 2, 3],"
                            + " \"multipleScattering\": false")
            .replace("\"#ffe0c0\"", "\"#ffe0c0\", \"power\": 1000")
            .replace("\"#ffffff\"", "\"#ffffff\", \"radiance\": [1, 2, 3], \"twoSided\": false")
            .replace("\"#404040\"", "\"#404040\", \"intensity\": 0.001")
            .replace("\"image\"", "\"display\": { \"exposure\": 5, \"tone\": \"filmic\" }, \"image\"");

    private static Scene read(String json) {
        return SceneReader.readString(json, Path.of(""), "");
    }

    @Test
    void aClassicPictureIsTheSameWithAndWithoutThem() {
        Scene bare = read(BARE);
        Scene full = read(FULL);
        assertNotEquals(bare, full);
        for (String method : new String[] {"raytrace", "cluster"}) {
            assertArrayEquals(png(bare, method), png(full, method), method);
        }
    }

    private static byte[] png(Scene scene, String method) {
        return RawPicture.of(
                        scene,
                        RenderSettings.of(scene)
                                .withMethod(enlightenment.scene.Method.named(method))
                                .withThreads(1))
                .png();
    }
}
