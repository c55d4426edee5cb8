package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
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
    private static final Map<String, Scene> SCENES = PartnerScenes.all();

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
                "lights of all kinds",
                "pane",
                "rough glass",
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
        assertShown(known);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("known")
    void everyPictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
        assertShown(known);
    }

    /** As of paths from the eye: six standard errors of twelve means. */
    private static void assertShown(ClosedForms.Known known) {
        List<Image> pictures = Rendered.seeds(known.scene(), settings(known.scene(), 8), 1, 12);
        int side = known.scene().width();
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, side, side, band));
            double expected = known.radiance()[band];
            double tolerance = 6 * s.error() + 1e-6 * expected + (known.name().contains("metal") ? 2e-3 : 0);
            assertTrue(Math.abs(s.mean() - expected) <= tolerance, () -> s + " instead of " + expected);
        }
    }
}
