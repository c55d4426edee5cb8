package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Of lamps that overlap in one plane each side shows one, and only that one gives light there: by every method. */
class LampOnLampTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;
    private static final double GAP = 1e-6;

    /** A floor and a ceiling, seen from between them. */
    private static Scene.Builder room() {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1.3, -5), at(0, 0.9, 0), Vec3.Y, 40))
                .object(TestScenes.rectangle(-3, 0, -3, -3, 0, 3, 3, 0, 3, 3, 0, -3), matte(0.7, 0.7, 0.7))
                .object(TestScenes.rectangle(-3, 2.5, -3, -3, 2.5, 3, 3, 2.5, 3, 3, 2.5, -3), matte(0.3, 0.3, 0.3));
    }

    private static Light panel(double x, double y, double half, double radiance, boolean twoSided) {
        return PhysicalScenes.panel(x, y, 0, half, Rgb.gray(radiance), twoSided);
    }

    /** A dim lamp on a bright one, seen from both sides: as if it were on both. */
    private static Scene dimOnBright(double gap) {
        Scene.Builder b = room().light(panel(0, 1.2, 0.8, 6, true)).light(panel(0.5, 1.2 - gap, 0.5, 1, true));
        return (gap == 0 ? b : b.light(panel(0.5, 1.2 + gap, 0.5, 1, true))).build();
    }

    /** A dim lamp that shines downwards only, on a bright one that shines upwards as well. */
    private static Scene onOneSide(double gap) {
        return room().light(panel(0, 1.2, 0.8, 6, true))
                .light(panel(0.2, 1.2 - gap, 0.6, 1, false))
                .build();
    }

    /** Two lamps of one size back to back. */
    private static Scene backToBack(double gap) {
        double y = 1.2 + gap;
        Light up = new Light.Rectangle(
                at(0.6, y, 0.6),
                at(0.6, y, -0.6),
                at(-0.6, y, -0.6),
                at(-0.6, y, 0.6),
                Rgb.WHITE,
                false,
                Emission.radiance(Rgb.gray(6)));
        return room().light(panel(0, 1.2, 0.6, 1, false)).light(up).build();
    }

    /** A lamp in the top of a box that glows; of the two faces the smaller one is seen. */
    private static Scene onABox(double half, double gap) {
        return room().object(
                        new Box(at(-0.5, 0.8, -0.5), at(0.5, 1.4, 0.5)),
                        matte(0.5, 0.5, 0.5).withRadiance(Rgb.gray(half < 0.5 ? 6 : 1)))
                .light(panel(0.1, half < 0.5 ? 1.4 + gap : 1.4 - gap, half, half < 0.5 ? 1 : 6, true))
                .build();
    }

    /** A dim sleeve on a bright tube without ends: of one radius, or one outside and one inside. */
    private static Scene sleeve(double gap) {
        Material.Matte matte = matte(0.5, 0.5, 0.5);
        Scene.Builder b = room().object(tube(0.7, 0.25), matte.withRadiance(Rgb.gray(4)))
                .object(tube(0.4, 0.25 + gap), matte.withRadiance(Rgb.gray(0.5)));
        return (gap == 0 ? b : b.object(tube(0.4, 0.25 - gap), matte.withRadiance(Rgb.gray(0.5)))).build();
    }

    private static Cylinder tube(double half, double radius) {
        Vec3 axis = new Vec3(0.5, 1, 0.2).normalized();
        Vec3 middle = new Vec3(0, 1.2, 0);
        return new Cylinder(at(middle.minus(axis.times(half))), at(middle.plus(axis.times(half))), radius, false);
    }

    private static void assertSame(BuiltInMethod method, Scene gap, Scene contact) {
        Rendered.assertContactIsLimit(mean(method, gap), mean(method, contact), 0.03);
    }

    private static double mean(BuiltInMethod method, Scene scene) {
        return Rendered.mean(scene, RenderSettings.of(scene).withMethod(method).withAntialias(8));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER", "METROPOLIS"})
    void aSmallLampHidesTheLargeOneThatItLiesOnFromBothSides(BuiltInMethod method) {
        assertSame(method, dimOnBright(GAP), dimOnBright(0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void aLampThatShinesToOneSideHidesOtherLampsOnThatSideOnly(BuiltInMethod method) {
        assertSame(method, onOneSide(GAP), onOneSide(0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void lampsBackToBackShineBoth(BuiltInMethod method) {
        assertSame(method, backToBack(GAP), backToBack(0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void aSmallLampHidesTheBoxThatItLiesOn(BuiltInMethod method) {
        assertSame(method, onABox(0.3, GAP), onABox(0.3, 0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void aGlowingBoxHidesTheLargeLampInItsTop(BuiltInMethod method) {
        assertSame(method, onABox(0.9, GAP), onABox(0.9, 0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void aSleeveHidesTheTubeUnderIt(BuiltInMethod method) {
        assertSame(method, sleeve(GAP), sleeve(0));
    }
}
