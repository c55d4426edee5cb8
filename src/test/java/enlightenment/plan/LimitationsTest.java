package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where samples hardly find some light, the error that is estimated from them is not trusted, and that is said. */
class LimitationsTest {
    private static CompiledScene compiled(String name) {
        Scene scene = SceneReader.read(Path.of("scenes/" + name + ".json"));
        return SceneCompiler.compile(scene, RenderSettings.of(scene).withSize(16, 8));
    }

    private static List<String> undersampled(String name, Method method) {
        return Integrators.undersampled(method, compiled(name));
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "METROPOLIS", "BIDIRECTIONAL"})
    void causticsSeenInMirrorsAreNamed(BuiltInMethod method) {
        List<String> found = undersampled("caustics", method);
        assertEquals(1, found.size());
        assertTrue(found.get(0).startsWith("few paths find small lamps and caustics"), found.get(0));
    }

    @Test
    void scenesWithoutSmallLampsAndMirrorsHaveNone() {
        for (Method method : BuiltInMethod.ALL) {
            assertEquals(List.of(), undersampled("furnace", method), method.word());
        }
    }

    @Test
    void lightTracingSamplesCausticsAndSaysInsteadWhatItCannotSee() {
        CompiledScene scene = compiled("caustics");
        assertEquals(
                List.of("few paths find small lamps that are seen in mirrors or through glass"),
                Integrators.undersampled(BuiltInMethod.LIGHT, scene));
        assertTrue(Integrators.blindSpot(BuiltInMethod.LIGHT, scene).isPresent());
    }

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice", "glass", "cone"})
    void classicShadingHasNoLightThatIsHardToFind(String name) {
        assertEquals(List.of(), Integrators.limitations(compiled(name)));
    }
}
