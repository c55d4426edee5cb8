package enlightenment.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.primitive.FlatForm;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class DeviceSceneTest {
    private static CompiledScene compiled(String name) throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    @ParameterizedTest
    @CsvSource({
        "torus, an object of the kind torus",
        "fog, a medium that scatters light",
        "lanterns, surroundings that are not the same everywhere",
        "knot, surfaces with holes",
        "minerals, a fluorescent material",
        "panorama, a panorama",
        "caustics, 'glass that does not turn rays, such as panes'",
        "prism, glass that disperses light",
        "furnace, rough glass",
        "matter, 'a light that is no point, ball or rectangle'",
    })
    void whatNoDeviceCanDoIsNamed(String name, String reason) throws IOException {
        assertEquals(Optional.of(reason), DeviceScene.refusal(compiled(name)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice", "cornell-box", "chess"})
    void whatDevicesCanDoIsTaken(String name) throws IOException {
        assertEquals(Optional.empty(), DeviceScene.refusal(compiled(name)));
    }

    /** The kernel looks for them there. */
    @Test
    void wholeNumbersStandWhereTheirPlacesSay() throws IOException {
        CompiledScene scene = compiled("fire-and-ice");
        Scene described = SceneReader.read(Path.of("scenes", "fire-and-ice.json"));
        DeviceScene flat = DeviceScene.of(scene, RenderSettings.of(described));
        assertEquals(scene.classic.ambient(), flat.doubles()[DeviceScene.Number.AMBIENT.place()]);
        assertEquals(scene.classic.shadow(), flat.doubles()[DeviceScene.Number.SHADOW.place()]);
        double[] camera = scene.camera.linearForm();
        for (int k = 0; k < camera.length; k++) {
            assertEquals(camera[k], flat.doubles()[DeviceScene.Number.CAMERA.place() + k]);
        }
        assertEquals(scene.lights.length, flat.ints()[DeviceScene.Int.LIGHT_COUNT.ordinal()]);
        int record = flat.ints()[DeviceScene.Int.PRIMITIVES.ordinal()];
        FlatForm first = scene.primitives[0].flatForm();
        assertEquals(first.kind().ordinal(), flat.ints()[record]);
        for (int k = 0; k < first.numbers().length; k++) {
            assertEquals(first.numbers()[k], flat.doubles()[flat.ints()[record + 1] + k]);
        }
    }

    @ParameterizedTest
    @EnumSource(DeviceScene.Program.class)
    void noNameOfAProgramStandsForTwoNumbers(DeviceScene.Program program) {
        Set<String> names = new HashSet<>();
        Matcher defined = Pattern.compile("(?m)^#define (\\w+)").matcher(KernelSource.text(program));
        while (defined.find()) {
            assertTrue(names.add(defined.group(1)), defined.group(1));
        }
    }

    @Test
    void theProgramKnowsEveryPlaceByItsName() {
        String text = KernelSource.text(DeviceScene.Program.CLASSIC) + KernelSource.text(DeviceScene.Program.PHYSICAL);
        for (DeviceScene.Int slot : DeviceScene.Int.values()) {
            assertTrue(text.contains("#define " + slot.name() + " " + slot.ordinal() + "\n"));
            // What belongs to the second hierarchy stands behind what belongs to the first.
            String name = slot.name().replace("SINGLE_", "");
            assertTrue(text.split("\\b" + name + "\\b").length > 2, slot + " is used");
        }
        for (FlatForm.Kind kind : FlatForm.Kind.values()) {
            assertTrue(text.split("\\b" + kind.name() + "\\b").length > 2, kind + " is used");
        }
    }
}
