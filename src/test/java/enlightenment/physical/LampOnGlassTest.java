package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A lamp that lies on a face of a solid of glass or fog is outside of that, as if a hair of air were between: by every method. */
class LampOnGlassTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;
    private static final double GAP = 1e-6;

    private static Material glass(double roughness) {
        return new Glass(linear(1, 1, 1), 1.5, 1, 0, true).withRoughness(roughness);
    }

    /** A floor and a ceiling, seen from the side. */
    private static Scene.Builder room() {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1.3, -5), at(0, 0.9, 0), Vec3.Y, 40))
                .object(TestScenes.rectangle(-3, 0, -3, -3, 0, 3, 3, 0, 3, 3, 0, -3), matte(0.7, 0.7, 0.7))
                .object(TestScenes.rectangle(-3, 2.5, -3, -3, 2.5, 3, 3, 2.5, 3, 3, 2.5, -3), matte(0.7, 0.7, 0.7));
    }

    /** A slab of glass above a two-sided lamp. */
    private static Scene slab(double gap, double roughness) {
        return room().object(new Box(at(-1, 0.5, -1), at(1, 1, 1)), glass(roughness))
                .light(PhysicalScenes.panel(0, 0.5 - gap, 0, 0.8, Rgb.gray(4), true))
                .build();
    }

    /** A box of fog, which turns no light, below a two-sided lamp. */
    private static Scene fog(double gap) {
        return room().object(
                        new Box(at(-1, 0.3, -1), at(1, 1.5, 1)),
                        Material.Scattering.of(Medium.Coefficients.of(Rgb.gray(0.4), Rgb.gray(0.2))))
                .light(PhysicalScenes.panel(0, 1.5 + gap, 0, 0.5, Rgb.gray(4), true))
                .build();
    }

    /** A cylinder of glass, aligned with no axis, on a point light. */
    private static Scene cylinder(double gap) {
        Vec3 up = new Vec3(0.3, 1, 0.2).normalized();
        Vec3 foot = new Vec3(0.1, 0.6, 0.3);
        return room().object(new Cylinder(at(foot), at(foot.plus(up.times(0.5))), 0.9, true), glass(0))
                .light(new Light.Point(at(foot.minus(up.times(gap))), Rgb.WHITE, Emission.intensity(Rgb.gray(4))))
                .build();
    }

    private static double mean(BuiltInMethod method, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(8);
        return Rendered.mean(scene, settings);
    }

    private static void assertSame(double gap, double contact) {
        Rendered.assertContactIsLimit(gap, contact, 0.04);
    }

    @ParameterizedTest
    @CsvSource({
        "RAYTRACE, 0",
        "RAYTRACE, 0.6",
        "BIDIRECTIONAL, 0",
        "BIDIRECTIONAL, 0.6",
        "LIGHT, 0",
        "LIGHT, 0.6",
        "CLUSTER, 0"
    })
    void aLampOnASlabOfGlassShinesAsThroughAThinGap(BuiltInMethod method, double roughness) {
        assertSame(mean(method, slab(GAP, roughness)), mean(method, slab(0, roughness)));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void aLampOnABoxOfFogShinesAsThroughAThinGap(BuiltInMethod method) {
        assertSame(mean(method, fog(GAP)), mean(method, fog(0)));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT"})
    void aPointLightOnAFaceOfGlassIsOutsideOfIt(BuiltInMethod method) {
        assertSame(mean(method, cylinder(GAP)), mean(method, cylinder(0)));
    }
}
