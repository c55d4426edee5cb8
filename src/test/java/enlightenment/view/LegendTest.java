package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** What false colours stand for. */
class LegendTest {
    private static final String SCENE =
            """
            {
              "image": { "width": 1, "height": 1 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "materials": { "white": { "type": "matte", "color": "#ffffff" } },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 1 } ],
              "objects": [
                { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white" },
                { "type": "sphere", "center": [3, 0, 0], "radius": 1, "material": { "type": "matte", "color": "#ff0000" } },
                { "type": "sphere", "center": [6, 0, 0], "radius": 1, "material": { "type": "matte", "color": "#ffffff" } }
              ]
            }
            """;

    private static Image grey(int width, float... values) {
        float[] rgb = new float[3 * values.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = values[i / 3];
        }
        return new Image(width, values.length / width, rgb);
    }

    @Test
    void whatCoversMostComesFirst() {
        Image numbers = grey(4, 7, 2, 2, -1, 2, 7, -1, 5);
        Image colors = grey(4, 1, 0, 0, 0.5f, 0, 1, 0.5f, 0.2f);
        Legend legend = Legend.of(numbers, colors, n -> "thing " + n);
        assertEquals(
                List.of(
                        new Legend.Entry("thing 2", "#000000", 3 / 8.0),
                        new Legend.Entry("thing 7", "#ffffff", 2 / 8.0),
                        new Legend.Entry("thing 5", "#333333", 1 / 8.0)),
                legend.entries());
        assertEquals(0, legend.more());
    }

    @Test
    void ofVeryManyThingsOnlySomeAreNamed() {
        float[] all = new float[Legend.MOST + 3];
        for (int i = 0; i < all.length; i++) {
            all[i] = i;
        }
        Legend legend = Legend.of(grey(1, all), grey(1, all), String::valueOf);
        assertEquals(Legend.MOST, legend.entries().size());
        assertEquals("0", legend.entries().get(0).name());
        assertEquals(3, legend.more());
    }

    @Test
    void materialsOfOneValueAreOne() {
        byte[] bytes = SCENE.getBytes(StandardCharsets.UTF_8);
        Scene scene = SceneReader.readBytes(bytes, Path.of("."), "scene", OptionalInt.empty());
        MaterialIndex index = new MaterialIndex(scene);
        assertEquals(index.of(0), index.of(2));
        assertEquals("white (matte)", index.name(index.of(2)));
        assertEquals("matte", index.name(index.of(1)));
        assertEquals("light 0 (sphere)", index.name(index.of(3)));
        assertEquals(-1, index.of(-1));
    }
}
