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
 * A method that follows paths from both ends makes the picture that naive paths from the eye make, and that is known: the same tests as
 * {@link NaivePartnerTest}.
 */
abstract class BothWaysPartner {
    private static final Map<String, Scene> SCENES = PartnerScenes.of(BuiltInMethod.BIDIRECTIONAL);

    private final BuiltInMethod method;
    private final int least;

    /**
     * @param least the least number whose square is enough samples per pixel for the method
     */
    BothWaysPartner(BuiltInMethod method, int least) {
        this.method = method;
        this.least = least;
    }

    static Stream<String> scenes() {
        // Only the naive tracer finds what a pane reflects of a point light onto what is seen through the pane.
        return SCENES.keySet().stream().filter(name -> !name.equals("point light behind a pane"));
    }

    private RenderSettings settings(Scene scene, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
    }

    private void compare(String name, int antialias, int seeds, int pathsOfQuarter) {
        Scene scene = SCENES.get(name);
        NaivePartnerTest.compare(scene, settings(scene, antialias), new NaiveTracer(scene), seeds, pathsOfQuarter);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "at most 2",
                "background and lights",
                "ball of wax",
                "checkered metal, mirror and glass",
                "coated",
                "coated, mirror and glass",
                "checkered glass and clear coat",
                "checkered roughness",
                "principled",
                "fog with a mirror and glass",
                "glowing disk and triangle",
                "glowing mirror and metal",
                "glowing tubes",
                "half of glass",
                "half of glass, half of metal or of lacquer",
                "half of rough glass, half of plastic",
                "lights of all kinds",
                "many lights of all kinds",
                "metals",
                "meshes whose normals are bent",
                "milk in glass",
                "nested glass",
                "pane",
                "rough glass",
                "smooth meshes of matte, mirror and glass",
                "smooth meshes of metal and coats",
                "rough matte",
                "under water by a panel",
                "window",
                "within a light"
            })
    void bothMakeTheSamePicture(String name) {
        compare(name, least, 8, 3_000);
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

    /** Not those whose paths have hundreds of vertices: they take 20 s each. */
    static Stream<ClosedForms.Known> someKnown() {
        return known().filter(known -> !known.name().endsWith("0.99"));
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
