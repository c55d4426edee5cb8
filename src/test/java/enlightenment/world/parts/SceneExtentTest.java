package enlightenment.world.parts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is too far away for physical light is told at its own place. */
class SceneExtentTest {
    private static final String LAMP =
            "{ 'type': 'rectangle', 'corners': [[-1, 3, -1], [-1, 3, 1], [1, 3, 1], [1, 3, -1]], 'color': '#fff', 'power': 10 }";

    private static final String BALL =
            "{ 'type': 'sphere', 'center': [0, %s, 0], 'radius': 1, 'material': { 'type': 'matte', 'color': '#888' } }";

    private static void compile(String lights, String objects) {
        String json =
                ("{ 'image': { 'width': 8, 'height': 8 }, 'shading': { 'model': 'physical' }, 'camera': { 'type': 'perspective',"
                                + " 'eye': [0, 0, -5], 'lookAt': [0, 0, 0], 'fieldOfView': 40 }, 'lights': [" + lights
                                + "], 'objects': [" + objects + "] }")
                        .replace('\'', '"');
        Scene scene = SceneReader.readString(json, Path.of(""), "");
        SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    @ParameterizedTest
    @CsvSource({"1e140, 140", "1e170, 170", "1e200, 200", "1e308, 308"})
    void notAtALampThatIsNear(String far, int exponent) {
        SceneException e = assertThrows(
                SceneException.class, () -> compile(LAMP, BALL.formatted("0") + "," + BALL.formatted(far)));
        Problem p = e.problems().get(0);
        assertEquals("/objects/1", p.pointer(), p.message());
        Matcher told = Pattern.compile("is about 1e(\\d+) times as far .*").matcher(p.message());
        assertTrue(told.matches(), p.message());
        // The ball's diameter is 2, and the scene's extent is told as a power of two.
        assertEquals(exponent, Integer.parseInt(told.group(1)), 1);
    }

    @Test
    void ofALampWhoseCornersAreOnePointThePower() {
        String x = "1" + "0".repeat(200);
        String y = "1" + "0".repeat(199) + "1";
        String far =
                "{ 'type': 'rectangle', 'corners': [[%1$s, 3, %1$s], [%1$s, 3, %2$s], [%2$s, 3, %2$s], [%2$s, 3, %1$s]],"
                                .formatted(x, y)
                        + " 'color': '#fff', 'power': 10 }";
        SceneException e = assertThrows(SceneException.class, () -> compile(far, BALL.formatted("0")));
        assertEquals("/lights/0/power", e.problems().get(0).pointer(), e.getMessage());
    }
}
