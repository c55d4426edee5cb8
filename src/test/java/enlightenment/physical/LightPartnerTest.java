package enlightenment.physical;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Paths from the lights make the picture that naive paths from the eye make, if these leave out what is seen in mirrors and through glass:
 * the same test as {@link NaivePartnerTest}.
 */
class LightPartnerTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.of(BuiltInMethod.LIGHT);

    /** Not that of lobes so narrow that of a million paths a few are bright: then means say nothing of their errors. */
    static Stream<String> scenes() {
        return SCENES.keySet().stream().filter(name -> !name.equals("nearly mirrors"));
    }

    private static RenderSettings settings(Scene scene, int antialias) {
        return RenderSettings.of(scene).withMethod(BuiltInMethod.LIGHT).withAntialias(antialias);
    }

    private static void compare(String name, int antialias, int seeds, int pathsOfQuarter) {
        Scene scene = SCENES.get(name);
        NaivePartnerTest.compare(
                scene, settings(scene, antialias), new NaiveTracer(scene, true), seeds, pathsOfQuarter);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "at most 2",
                "background and lights",
                "coated, mirror and glass",
                "half of glass, half of metal or of lacquer",
                "half of rough glass, half of plastic",
                "lights of all kinds",
                "meshes whose normals are bent",
                "pane",
                "point light behind a pane",
                "rough glass",
                "smooth meshes of matte, mirror and glass",
                "smooth meshes of metal and coats",
                "under water by a panel",
                "within a light"
            })
    void bothMakeTheSamePicture(String name) {
        compare(name, 4, 8, 2_000);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("scenes")
    void bothMakeTheSamePictureWithManyPaths(String name) {
        compare(name, 24, 32, 1_000_000);
    }

    /** Not those of a view so narrow that no path comes into it, and of matte things in mirrors and glass. */
    static Stream<ClosedForms.Known> known() {
        return Stream.concat(ClosedForms.all().stream(), ClosedForms.hard().stream())
                .filter(known -> !known.name().matches(".*\\b(mirrors?|floor|point light|half)\\b.*"));
    }

    static Stream<ClosedForms.Known> someKnown() {
        return known().filter(known ->
                known.name().matches("furnace, (matte|glass|rough metal)|checkered ball|slab|eye in glass"));
    }

    @ParameterizedTest
    @MethodSource("someKnown")
    void thePictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
        known.assertShown(settings(known.scene(), 8));
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("known")
    void everyPictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
        known.assertShown(settings(known.scene(), 8));
    }
}
