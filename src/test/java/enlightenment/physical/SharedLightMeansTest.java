package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.material.Glossy;
import enlightenment.material.Principled;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures with and without shared light vertices have the same means: Welch's test of each band's mean over the picture, at 1 % for all
 * comparisons together by Šidák's formula. Means are known to one or two thousandths, so that light which two strategies count twice is
 * found: much sooner than by {@link BidirectionalClusterPartnerTest}, whose partner is naive.
 */
class SharedLightMeansTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.of(BuiltInMethod.BIDIRECTIONAL_CLUSTER);

    private static final int SAMPLES = 32;

    static Stream<String> scenes() {
        return SCENES.keySet().stream();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "walls of plastic and metal",
                "rough glass",
                "hardly rough glass",
                "half of rough glass, half of plastic",
                "coated, mirror and glass",
                "checkered metal, mirror and glass",
                "smooth meshes of metal and coats",
                "lights of all kinds",
                "window"
            })
    void bothHaveTheSameMeans(String name) {
        compare(name, 12);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("scenes")
    void bothHaveTheSameMeansOverManyPictures(String name) {
        compare(name, 48);
    }

    /** Light of a sky and its sun, which only paths from the eye find, beside that of a lamp. */
    @Test
    void roughWallsUnderASkyHaveTheSameMeans() {
        Shading.Background sky = Shading.Background.Sky.of(30, 150);
        Scene scene = PhysicalScenes.room(
                        Principled.of(PhysicalScenes.linear(0.7, 0.8, 0.6), 0.4, 0),
                        Glossy.of(PhysicalScenes.linear(0.9, 0.6, 0.3), 0.8),
                        Principled.of(PhysicalScenes.linear(0.2, 0.9, 0.6), 0.5, 0.5))
                .shading(new Shading.Physical(OptionalInt.empty(), sky, Optional.empty()))
                .light(PhysicalScenes.panel(-0.2, 0.4, 0.6, 0.3, new Rgb(5, 4, 2), false))
                .name("rough walls under a sky")
                .build();
        compare(scene, 16);
    }

    private static void compare(String name, int pictures) {
        compare(SCENES.get(name), pictures);
    }

    private static void compare(Scene scene, int pictures) {
        List<Image> shared = render(scene, BuiltInMethod.BIDIRECTIONAL_CLUSTER, pictures);
        List<Image> unshared = render(scene, BuiltInMethod.CLUSTER, pictures);
        double level = Welch.sidak(0.01, 3 * SCENES.size());
        for (int band = 0; band < 3; band++) {
            Welch test = Welch.of(means(shared, band), means(unshared, band));
            assertTrue(
                    test.probability() >= level,
                    scene.name() + ", band " + band + ": " + test.deviations() + " standard errors of "
                            + test.standardError());
        }
    }

    private static List<Image> render(Scene scene, BuiltInMethod method, int pictures) {
        RenderSettings settings =
                RenderSettings.of(scene).withMethod(method).withBudget(RenderSettings.Budget.NONE.withSamples(SAMPLES));
        return Rendered.seeds(scene, settings, 0, pictures);
    }

    /** The mean of each picture. */
    private static double[] means(List<Image> pictures, int band) {
        Image one = pictures.get(0);
        return Rendered.means(pictures, 0, 0, one.width(), one.height(), band);
    }
}
