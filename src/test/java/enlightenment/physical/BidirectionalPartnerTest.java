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

/** Paths from both ends make the picture that naive paths from the eye make, and that is known: the same tests as {@link NaivePartnerTest}. */
class BidirectionalPartnerTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.all();

    static Stream<String> scenes() {
        // The naive tracer never finds light that a pane reflects from a point.
        return SCENES.keySet().stream().filter(name -> !name.equals("point light behind a pane"));
    }

    private static RenderSettings settings(Scene scene, int antialias) {
        return RenderSettings.of(scene).withMethod(BuiltInMethod.BIDIRECTIONAL).withAntialias(antialias);
    }

    private static void compare(String name, int antialias, int seeds, int pathsOfQuarter) {
        Scene scene = SCENES.get(name);
        NaivePartnerTest.compare(scene, settings(scene, antialias), new NaiveTracer(scene), seeds, pathsOfQuarter);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "at most 2",
                "background and lights",
                "checkered metal, mirror and glass",
                "glowing disk and triangle",
                "glowing mirror and metal",
                "glowing tubes",
                "half of glass",
                "lights of all kinds",
                "many lights of all kinds",
                "metals",
                "nested glass",
                "pane",
                "rough glass",
                "rough matte",
                "under water by a panel",
                "window",
                "within a light"
            })
    void bothMakeTheSamePicture(String name) {
        compare(name, 2, 8, 3_000);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("scenes")
    void bothMakeTheSamePictureWithManyPaths(String name) {
        compare(name, 12, 32, 1_000_000);
    }

    static Stream<ClosedForms.Known> known() {
        return Stream.concat(ClosedForms.all().stream(), ClosedForms.hard().stream());
    }

    /** As of paths from the eye: six standard errors of twelve means. */
    @ParameterizedTest
    @MethodSource("known")
    void thePictureShowsTheRadianceThatIsKnown(ClosedForms.Known known) {
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
