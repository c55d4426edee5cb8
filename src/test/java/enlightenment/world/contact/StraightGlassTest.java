package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whether shadow rays may come to glass that does not turn them: only then are they followed through it. */
class StraightGlassTest {
    private static final String SCENE =
            """
            { "image": { "width": 1, "height": 1 },
              "camera": { "type": "perspective", "eye": [0.3, 0, -9], "lookAt": [0, 0, 0], "fieldOfView": 60 },
              "shading": { "model": "physical" },
              "lights": [{ "type": "point", "position": [0, 9, 0], "color": "#ffffff", "intensity": 1 }],
              "objects": [
                { FIRST, "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5, "priority": 0 } },
                { SECOND, "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": INDEX, "priority": PRIORITY } }] }
            """;

    private static final String BALL = "'type': 'sphere', 'center': [0, 0, 0], 'radius': 1";
    private static final String BOX = "'type': 'box', 'min': [-1, -1, -1], 'max': [1, 1, 1]";
    private static final String CAN =
            "'type': 'cylinder', 'base': [0.5, -1, 0.5], 'top': [-0.5, 1, 0.7], 'radius': 0.5";
    private static final String RING =
            "'type': 'torus', 'center': [0, 0, 0], 'axis': [0, 1, 0], 'majorRadius': 1, 'minorRadius': 0.4";

    private static boolean interfaceExists(String first, String second, double index, int priority) {
        String text = SCENE.replace("FIRST", first.replace('\'', '"'))
                .replace("SECOND", second.replace('\'', '"'))
                .replace("INDEX", Double.toString(index))
                .replace("PRIORITY", Integer.toString(priority));
        Scene scene = SceneReader.readString(text, Path.of(""), "");
        return SceneCompiler.compile(scene, RenderSettings.of(scene)).physical.hasStraightGlass;
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '~',
            delimiter = ';',
            value = {
                // Apart.
                BOX + "; 'type': 'sphere', 'center': [3, 0, 0], 'radius': 1; 1.3; 1; false",
                BOX + "; 'type': 'sphere', 'center': [3, 0, 0], 'radius': 1; 1.5; 1; true",
                BOX + "; 'type': 'sphere', 'center': [3, 0, 0], 'radius': 1; 1; 1; true",
                // Overlapping, and in contact.
                BOX + "; 'type': 'sphere', 'center': [1, 0, 0], 'radius': 1; 1.3; 1; true",
                BOX + "; 'type': 'box', 'min': [1, -1, -1], 'max': [2, 1, 1]; 1.3; 1; true",
                BOX + "; 'type': 'box', 'min': [1.01, -1, -1], 'max': [2, 1, 1]; 1.3; 1; false",
                // Within, filled by the inner one or by the outer one.
                BOX + "; 'type': 'sphere', 'center': [0, 0, 0], 'radius': 0.9; 1.3; 1; false",
                BOX + "; 'type': 'sphere', 'center': [0, 0, 0], 'radius': 0.9; 1.3; 0; false",
                BOX + "; 'type': 'sphere', 'center': [0, 0, 0], 'radius': 0.9; 1.3; -1; true",
                BOX + "; 'type': 'sphere', 'center': [0, 0, 0], 'radius': 1; 1.3; 1; true",
                BALL + "; 'type': 'sphere', 'center': [0, 0, 0.01], 'radius': 0.98; 1.3; 1; false",
                BALL + "; 'type': 'sphere', 'center': [0, 0, 0.01], 'radius': 0.99; 1.3; 1; true",
                CAN
                        + "; 'type': 'cylinder', 'base': [0.48, -0.92, 0.504], 'top': [-0.48, 0.92, 0.696], 'radius': 0.47; 1.3; 1; false",
                CAN
                        + "; 'type': 'cylinder', 'base': [0.5, -1, 0.5], 'top': [-0.48, 0.92, 0.696], 'radius': 0.47; 1.3; 1; true",
                RING + "; 'type': 'sphere', 'center': [1, 0, 0], 'radius': 0.1; 1.3; 1; true",
            })
    void onlyPanesEqualIndicesAndSolidsThatMeetAsk(
            String first, String second, double index, int priority, boolean expected) {
        assertEquals(expected, interfaceExists(first, second, index, priority));
    }
}
