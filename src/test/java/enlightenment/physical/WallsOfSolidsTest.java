package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The walls of opaque solids that solids of glass or fog touch: nothing comes through them, from inside or outside. */
class WallsOfSolidsTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;

    private static Material fog(double scattering) {
        return Material.Scattering.of(Medium.Coefficients.of(Rgb.gray(scattering), Rgb.gray(scattering / 4)));
    }

    private static Material glass() {
        return new Glass(linear(1, 1, 1), 1.3, 1, 0, true);
    }

    /** A room that is the inside of a box, with a pool on its floor that reaches to the walls or nearly so. */
    private static Scene pool(Material filling, double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1.2, -0.9), at(0, 0.6, 0.5), Vec3.Y, 60))
                .object(new Box(at(-1, 0, -1), at(1, 2, 1)), matte(0.6, 0.6, 0.6))
                .object(new Box(at(-1 + gap, gap, -1 + gap), at(1 - gap, 0.8, 1 - gap)), filling)
                .light(PhysicalScenes.sphereLight(0.2, 1.6, 0.2, 0.15, 8))
                .build();
    }

    /** A white box that glows, in a box of almost nothing that stands on the same plane. */
    private static Scene lantern(double gap) {
        Material.Matte white = matte(0.9, 0.9, 0.9);
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1, -3), at(0, 0.4, 0), Vec3.Y, 40))
                .object(new Box(at(-2, 0, -2), at(2, 0.1, 2)), matte(0.7, 0.7, 0.7))
                .object(new Box(at(-0.3, 0.3, -0.3), at(0.3, 0.9, 0.3)), white.withRadiance(Rgb.gray(1)))
                .object(new Box(at(-0.5, 0.3 - gap, -0.5), at(0.5, 1.5, 0.5)), fog(1e-9))
                .build();
    }

    private static double mean(BuiltInMethod method, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(8);
        return Rendered.mean(scene, settings);
    }

    private static void assertSame(double gap, double contact) {
        Rendered.assertContactIsLimit(gap, contact, 0.03);
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT", "CLUSTER"})
    void fogThatReachesTheWallsOfARoomStaysInIt(BuiltInMethod method) {
        assertSame(mean(method, pool(fog(0.4), 1e-5)), mean(method, pool(fog(0.4), 0)));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "CLUSTER"})
    void lightInAPoolStaysInTheRoom(BuiltInMethod method) {
        assertSame(mean(method, pool(glass(), 1e-5)), mean(method, pool(glass(), 0)));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT"})
    void lightInsideOfAGlowingSolidStaysThere(BuiltInMethod method) {
        double outside = mean(method, lantern(1e-5));
        assertSame(outside, mean(method, lantern(0)));
        assertSame(mean(BuiltInMethod.RAYTRACE, lantern(0)), outside);
    }

    /** A cube of dark glass of which the left or the right face is opaque, turned so that it is the same cube. */
    private static Scene painted(boolean isLeft) {
        Material dark = Glass.of(linear(1, 1, 1), 1.5).withAbsorption(Rgb.gray(2));
        Material[] faces = {dark, dark, dark, dark, dark, dark};
        faces[isLeft ? 0 : 1] = matte(0.5, 0.5, 0.5);
        Cube cube = new Cube(at(0, 1, 0), 0.5, new Vec3(0, isLeft ? 20 : 200, 0));
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .shading(PhysicalScenes.shading(1))
                .object(new SceneObject("", cube, faces[2], List.of(faces)))
                .build();
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "CLUSTER"})
    void aCubeIsOfGlassWhicheverOfItsFacesIsNot(BuiltInMethod method) {
        assertSame(mean(method, painted(false)), mean(method, painted(true)));
    }

    /** In a white furnace a poster on the outside of a block of glass, and a box sunk into it, show nothing. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "CLUSTER", "METROPOLIS"})
    void whatIsFlushWithGlassReflectsLightAwayFromIt(BuiltInMethod method) {
        Material white = matte(1, 1, 1);
        Scene scene = PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(1.5, 2, -2.5), at(0, 0.9, 0), Vec3.Y, 25))
                .shading(PhysicalScenes.atMost(100, 1))
                .object(new Box(at(-1, 0, -1), at(1, 1, 1)), glass())
                .object(new Box(at(-0.5, 0.5, -0.5), at(0, 1, 0.5)), white)
                .object(TestScenes.rectangle(0.2, 1, -0.5, 0.2, 1, 0.5, 0.9, 1, 0.5, 0.9, 1, -0.5), white)
                .build();
        assertEquals(1, mean(method, scene), 0.01);
    }

    /** A sheet between two blocks of glass, which touch it or nearly so, seen through the upper one. */
    private static Scene sandwich(double lower, double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 6, -0.5), at(0, 0, 0), Vec3.Z, 8))
                .shading(PhysicalScenes.atMost(100, 1))
                .object(new Box(at(-1, gap, -1), at(1, 1, 1)), glass())
                .object(new Box(at(-1, -1, -1), at(1, -gap, 1)), new Glass(linear(1, 1, 1), lower, 1, 0, true))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), matte(0.6, 0.6, 0.6))
                .build();
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE, 1.3", "RAYTRACE, 2", "BIDIRECTIONAL, 2", "CLUSTER, 2"})
    void aSheetBetweenTwoBlocksOfGlassIsSeenFromThatBeforeIt(BuiltInMethod method, double lower) {
        assertSame(mean(method, sandwich(lower, 1e-5)), mean(method, sandwich(lower, 0)));
    }

    /** A lamp that shines both ways and lies on a box that is smaller. */
    private static Scene shade(double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .object(TestScenes.rectangle(-6, 0, -6, -6, 0, 6, 6, 0, 6, 6, 0, -6), matte(0.7, 0.7, 0.7))
                .object(new Box(at(0, 0, 0), at(0.5, 1, 0.5)), matte(0.8, 0.8, 0.8))
                .light(PhysicalScenes.panel(0, 1 + gap, 0, 0.5, Rgb.gray(4), true))
                .build();
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "BIDIRECTIONAL", "LIGHT"})
    void aLampShinesBesideTheBoxThatItLiesOn(BuiltInMethod method) {
        assertSame(mean(method, shade(1e-5)), mean(method, shade(0)));
    }
}
