package enlightenment.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.parts.Polls;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Large scenes need not be prepared to the end if nobody wants them any more. */
class CompileCancelledTest {
    /** Triangles that glow, so that there are as many lights, and spheres. */
    private static Scene scene(int triangles, int spheres) {
        StringBuilder objects = new StringBuilder();
        for (int i = 0; i < triangles; i++) {
            double x = i % 64 + 0.125;
            double y = i / 64;
            objects.append(objects.isEmpty() ? "" : ",\n")
                    .append("{ \"type\": \"triangle\", \"vertices\": [[" + x + ", " + y + ", 9], [" + (x + 0.5) + ", "
                            + y + ", 9], [" + x + ", " + (y + 0.5) + ", 9]], \"material\": \"glow\" }");
        }
        for (int i = 0; i < spheres; i++) {
            objects.append(objects.isEmpty() ? "" : ",\n")
                    .append("{ \"type\": \"sphere\", \"center\": [" + i % 64 + ", " + i / 64
                            + ", 20], \"radius\": 0.25, \"material\": \"white\" }");
        }
        return SceneReader.readString(
                """
                { "image": { "width": 4, "height": 4 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "materials": { "white": { "type": "matte", "color": "#808080" },
                                 "glow": { "type": "matte", "color": "#808080", "radiance": 1 } },
                  "objects": [OBJECTS] }
                """
                        .replace("OBJECTS", objects),
                Path.of(""),
                "");
    }

    /** Placing n objects, comparing them, looking where n lights lie, and the n / 1024 and more largest ranges of two trees. */
    @Test
    void itEndsWhereverItIsAsked() {
        int n = 4 * 1024;
        Scene lights = scene(n, 0);
        int all = Polls.ofCompiling(Polls.NEVER, lights);
        assertTrue(all >= 5 * 4, all + " times");
        for (int patience = 1; patience <= all; patience++) {
            assertEquals(patience, Polls.ofCompiling(patience, lights));
        }
        int ofSpheres = Polls.ofCompiling(Polls.NEVER, scene(0, n));
        assertTrue(ofSpheres >= 3 * 4 && ofSpheres < all, ofSpheres + " times");
    }

    @Test
    void smallScenesAreMadeWithoutAsking() {
        assertEquals(0, Polls.ofCompiling(Polls.NEVER, scene(100, 900)));
    }
}
