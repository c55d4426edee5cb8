package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Points that shine into some directions: closed forms, and the same picture by every method. */
class DirectedLightsTest {
    private static final double REFLECTANCE = 0.6;

    private static final Map<String, Scene> SCENES = DirectedLights.scenes();
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(12, 3);

    record Case(BuiltInMethod method, String name) {}

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withThreads(1).withAntialias(antialias);
    }

    static List<Case> lights() {
        List<Case> cases = new ArrayList<>();
        for (String name : DirectedLights.down().keySet()) {
            for (BuiltInMethod method : DirectedLights.METHODS) {
                cases.add(new Case(method, name));
            }
        }
        return cases;
    }

    /**
     * In a matte ball indirect light is the same everywhere, whatever the light is that the wall has straight: E = ρ Φ / ((1 − ρ) A). So the
     * picture of a place that the light does not reach measures its power.
     */
    @ParameterizedTest
    @MethodSource("lights")
    void theIntegratingSphereMeasuresItsPower(Case c) {
        Light light = DirectedLights.down().get(c.name);
        Scene scene = Scene.builder()
                .size(8, 8)
                .shading(shading(0))
                .camera(new Camera.Perspective(at(0.1, 0.2, 0.1), at(0.2, 2, 0.3), Vec3.Z, 30))
                .object(ball(0, 0, 0, 1), matte(REFLECTANCE, REFLECTANCE / 2, 0))
                .light(light)
                .build();
        double[] expected = new double[3];
        double[] power = DirectedLights.POWER;
        for (int band = 0; band < 2; band++) {
            double rho = band == 0 ? REFLECTANCE : REFLECTANCE / 2;
            expected[band] = rho / Math.PI * rho * power[band] / ((1 - rho) * 4 * Math.PI);
        }
        new ClosedForms.Known(c.toString(), scene, expected).assertShown(settings(scene, c.method, 4));
    }

    /** A floor at the distance h below, under an angle α from the axis: E = I(α) cos³ α / h². */
    @ParameterizedTest
    @MethodSource("methods")
    void theFloorUnderASpotHasTheIrradianceOfThePoint(BuiltInMethod method) {
        double height = 2.5;
        double place = 1.5;
        double cos = height / Math.hypot(height, place);
        double inner = Math.cos(Math.toRadians(20));
        double outer = Math.cos(Math.toRadians(50));
        double t = (cos - outer) / (inner - outer);
        double intensity = 3 * t * t * (3 - 2 * t);
        double radiance = REFLECTANCE / Math.PI * intensity * cos * cos * cos / (height * height);
        Scene scene = Scene.builder()
                .size(4, 4)
                .shading(shading(0))
                .camera(new Camera.Perspective(at(place, 1, 0), at(place, 0, 0), Vec3.Z, 0.01))
                .object(
                        TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9),
                        matte(REFLECTANCE, REFLECTANCE, REFLECTANCE))
                .light(new Light.Spot(
                        at(0, height, 0),
                        new Vec3(0, -5, 0),
                        50,
                        20,
                        Rgb.WHITE,
                        Emission.intensity(new Rgb(3, 1.5, 0))))
                .build();
        // The picture is 1.7e-4 wide.
        new ClosedForms.Known("", scene, radiance, radiance / 2, 0).assertShown(settings(scene, method, 2));
    }

    static List<BuiltInMethod> methods() {
        return List.of(BuiltInMethod.RAYTRACE, BuiltInMethod.CLUSTER, BuiltInMethod.BIDIRECTIONAL);
    }

    static List<Case> partners() {
        List<Case> cases = new ArrayList<>();
        for (String name : SCENES.keySet()) {
            for (BuiltInMethod method : DirectedLights.METHODS) {
                // Light paths do not find what mirrors and glass show.
                boolean isFound = method != BuiltInMethod.LIGHT || !name.contains("mirror");
                if (method != BuiltInMethod.RAYTRACE && isFound) {
                    cases.add(new Case(method, name));
                }
            }
        }
        return cases;
    }

    @ParameterizedTest
    @MethodSource("partners")
    void allMethodsMakeThePictureOfSinglePaths(Case c) {
        Scene scene = SCENES.get(c.name);
        List<Image> traced = REFERENCES.of(c.name, scene);
        List<Image> others = Rendered.seeds(scene, settings(scene, c.method, 3), 1, 12);
        Rendered.assertPartsAgree(traced, others, 12 * partners().size());
    }
}
