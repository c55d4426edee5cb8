package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.bsdf.Reradiation;
import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Mesh;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Fluorescent surfaces by every method, against closed forms and surfaces without a dye. */
class FluorescenceTest {
    private static final int BANDS = Reradiation.BANDS;
    private static final int U = Reradiation.ULTRAVIOLET;

    private static Material.Fluorescent dye(Texture color, double yield) {
        return new Material.Fluorescent(
                color, new Material.WavelengthBand(320, 450), new Material.WavelengthBand(500, 600), yield);
    }

    private static Reradiation matrix(Material.Fluorescent m) {
        return new Reradiation(
                m.absorption().low(),
                m.absorption().high(),
                m.emission().low(),
                m.emission().high(),
                m.yield());
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
    }

    private static Light lamp(double x, double y, double z, double radius, Rgb radiance, double ultraviolet) {
        return new Light.Sphere(
                at(x, y, z), radius, Rgb.WHITE, Emission.radiance(radiance).withUltraviolet(ultraviolet));
    }

    /** A room with a mirror ball, and things of other materials. */
    private static Scene furnished(Material first, Material second) {
        return PhysicalScenes.room()
                .object(ball(-0.35, 0.45, -0.1, 0.42), first)
                .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), second)
                .object(ball(0.3, 1.2, 0.2, 0.25), Material.Mirror.of(linear(0.9, 0.9, 0.9)))
                .light(lamp(0.1, 1.6, -0.4, 0.2, new Rgb(4, 5, 6), 3))
                .light(new Light.Point(
                        at(-0.6, 1.5, -0.6),
                        Rgb.WHITE,
                        Emission.intensity(Rgb.gray(1)).withUltraviolet(2)))
                .build();
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void withoutYieldItIsAMatteSurfaceInEveryByte(BuiltInMethod method) {
        Texture plain = linear(0.6, 0.5, 0.2);
        Texture checks = new Texture.Checker(List.of(new Rgb(0.1, 0.7, 0.5), new Rgb(0.8, 0.3, 0.4)), 3);
        Scene dyed = furnished(dye(plain, 0), dye(checks, 0));
        Scene matte = furnished(Material.Matte.of(plain), Material.Matte.of(checks));
        assertArrayEquals(
                Renderer.render(matte, settings(matte, method, 3)).toArray(),
                Renderer.render(dyed, settings(dyed, method, 3)).toArray());
    }

    /** Without ultraviolet light nothing of it is left to shine: the dye takes it in alone. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void whatTakesInUltravioletAloneIsMatteWhereThereIsNone(BuiltInMethod method) {
        Texture plain = linear(0.6, 0.5, 0.2);
        Material black = new Material.Fluorescent(
                plain, new Material.WavelengthBand(320, 400), new Material.WavelengthBand(500, 600), 1);
        Scene dyed = withoutUltraviolet(black);
        Scene matte = withoutUltraviolet(Material.Matte.of(plain));
        assertArrayEquals(
                Renderer.render(matte, settings(matte, method, 3)).toArray(),
                Renderer.render(dyed, settings(dyed, method, 3)).toArray());
    }

    private static Scene withoutUltraviolet(Material material) {
        return PhysicalScenes.room()
                .object(ball(-0.35, 0.45, -0.1, 0.42), material)
                .light(lamp(0.1, 1.6, -0.4, 0.2, new Rgb(4, 5, 6), 0))
                .build();
    }

    /** And ultraviolet light where nothing shows it: the same as none. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void ultravioletLightThatNothingShowsChangesNoByte(BuiltInMethod method) {
        Material matte = matte(0.6, 0.5, 0.2);
        Scene.Builder room = PhysicalScenes.room().object(ball(-0.35, 0.45, -0.1, 0.42), matte);
        Scene without =
                room.light(lamp(0.1, 1.6, -0.4, 0.2, new Rgb(4, 5, 6), 0)).build();
        Scene with = PhysicalScenes.room()
                .object(ball(-0.35, 0.45, -0.1, 0.42), matte)
                .light(lamp(0.1, 1.6, -0.4, 0.2, new Rgb(4, 5, 6), 7))
                .build();
        assertArrayEquals(
                Renderer.render(without, settings(without, method, 3)).toArray(),
                Renderer.render(with, settings(with, method, 3)).toArray());
    }

    /** A lamp of radius r straight above: E = π L r²/d². */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aPlaneUnderABlackLightHasItsColumnOfTheMatrix(BuiltInMethod method) {
        Material.Fluorescent dye = dye(linear(0.3, 0.4, 0.1), 0.9);
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0.4, 0.5, -0.3), at(0, 0, 0), Vec3.Y, 0.02))
                .shading(shading(0))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), dye)
                .light(lamp(0, 1.5, 0, 0.3, Rgb.BLACK, 40))
                .build();
        double irradiance = Math.PI * 40 * 0.3 * 0.3 / (1.5 * 1.5);
        if (method == BuiltInMethod.LIGHT) {
            return; // No path from the light comes into so narrow a view: the room below has the same light.
        }
        Image picture = Renderer.render(scene, settings(scene, method, 8));
        double[] color = {0.3, 0.4, 0.1};
        for (int band = 0; band < 3; band++) {
            double expected = matrix(dye).element(band, U, color) * irradiance / Math.PI;
            // Of paths from both ends some sample the lamp.
            double tolerance = method == BuiltInMethod.BIDIRECTIONAL ? 0.05 : 1e-4;
            double sum = 0;
            for (int k = 0; k < 16; k++) {
                sum += picture.component(k % 4, k / 4, band) / 16;
            }
            assertEquals(expected, sum, tolerance * expected, "band " + band);
        }
    }

    /** The light of a closed room whose walls emit: L = Le + M L, by bands. */
    private static double[] closed(Reradiation dye, double[] color, double[] emitted) {
        double[] sum = emitted.clone();
        double[] bounced = emitted.clone();
        for (int k = 0; k < 2000; k++) {
            dye.scatter(color, bounced);
            for (int band = 0; band < BANDS; band++) {
                sum[band] += bounced[band];
            }
        }
        return sum;
    }

    private static Scene.Builder glowing(Material wall) {
        return Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(at(0.3, 0.2, -0.1), at(0.1, 0.2, 1), Vec3.Y, 30))
                .shading(shading(0))
                .object(ball(0, 0, 0, 1), wall);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aClosedRoomHasTheSumOfAllBounces(BuiltInMethod method) {
        double[] color = {0.6, 0.5, 0.3};
        Material.Fluorescent dye = dye(linear(0.6, 0.5, 0.3), 0.9);
        Material wall = new Material.Fluorescent(
                dye.color(), dye.absorption(), dye.emission(), dye.yield(), new Rgb(0.1, 0.2, 0.3), 2);
        double[] expected = closed(matrix(dye), color, new double[] {0.1, 0.2, 0.3, 2});
        assertShown(glowing(wall).build(), method, expected);
    }

    /** A cloud that loses no light changes nothing in light that is the same from everywhere. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aCloudInAClosedRoomCannotBeSeen(BuiltInMethod method) {
        Material.Fluorescent dye = dye(linear(0.6, 0.5, 0.3), 0.9);
        Material wall = new Material.Fluorescent(
                dye.color(), dye.absorption(), dye.emission(), dye.yield(), new Rgb(0.1, 0.2, 0.3), 2);
        Medium cloud = new Medium.Coefficients(new Rgb(1, 2, 3), Rgb.BLACK, 0.3);
        Scene scene = glowing(wall)
                .object(ball(0.05, 0.15, 0.5, 0.35), Material.Scattering.of(cloud))
                .build();
        assumeTrue(Method.supports(method, scene));
        double[] color = {0.6, 0.5, 0.3};
        assertShown(scene, method, closed(matrix(dye), color, new double[] {0.1, 0.2, 0.3, 2}));
    }

    /** White but for ultraviolet, which all becomes green: what is missing is what Stokes' law takes. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void whiteWallsLoseNoEnergyButByLongerWaves(BuiltInMethod method) {
        Material.Fluorescent black = new Material.Fluorescent(
                linear(0.5, 0.5, 0),
                new Material.WavelengthBand(300, 400),
                new Material.WavelengthBand(490, 580),
                1,
                Rgb.BLACK,
                3);
        double left = 350 * Math.log(580.0 / 490) / 90;
        // Half of the green light is left at each bounce after the first.
        assertShown(glowing(black).build(), method, new double[] {0, 3 * left * 2, 0});
    }

    private static void assertShown(Scene scene, BuiltInMethod method, double[] expected) {
        List<Image> pictures = Rendered.seeds(scene, settings(scene, method, 8), 1, 12);
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, 8, 8, band));
            double tolerance = 6 * s.error() + 1e-6 * expected[band];
            double known = expected[band];
            assertTrue(Math.abs(s.mean() - known) <= tolerance, () -> s + " instead of " + known);
            assertTrue(s.error() <= 0.1 * known, () -> s + " is noisy");
        }
    }

    /** A square that faces the light from everywhere, whose vertices have the normals that it has anyway. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void meshesWithNormalsShineAsMeshesWithout(BuiltInMethod method) {
        Material.Fluorescent dye = new Material.Fluorescent(
                linear(0.9, 0.9, 0.1), new Material.WavelengthBand(400, 490), new Material.WavelengthBand(490, 580), 1);
        double green = matrix(dye).element(1, 1, new double[] {0.9, 0.9, 0.1})
                + matrix(dye).element(1, 2, new double[] {0.9, 0.9, 0.1});
        for (TriangleMesh square :
                List.of(TestMeshes.grid(1), TestMeshes.grid(1).smooth())) {
            Scene scene = Scene.builder()
                    .size(4, 4)
                    .camera(new Camera.Perspective(at(0, 0, 3), at(0, 0, 0), Vec3.Y, 10))
                    .shading(shading(1))
                    .object(Mesh.of(square), dye)
                    .build();
            Image picture = Renderer.render(scene, settings(scene, method, 16));
            double sum = 0;
            for (int k = 0; k < 16; k++) {
                sum += picture.component(k % 4, k / 4, 1);
            }
            assertEquals(green, sum / 16, 0.02, square.hasNormals() ? "with normals" : "without");
        }
    }

    /** More green light leaves than comes: nothing is clipped, neither in the picture nor in the auxiliary one. */
    @Test
    void aGreenThatIsBrighterThanWhiteIsShownAsItIs() {
        double[] color = {0.9, 0.9, 0.1};
        Material.Fluorescent dye = new Material.Fluorescent(
                linear(0.9, 0.9, 0.1), new Material.WavelengthBand(400, 490), new Material.WavelengthBand(490, 580), 1);
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, -3), at(0, 0, 0), Vec3.Y, 10))
                .shading(shading(1))
                .object(ball(0, 0, 0, 1), dye)
                .build();
        double green = matrix(dye).element(1, 1, color) + matrix(dye).element(1, 2, color);
        assertTrue(green > 1.5);
        Image picture = Renderer.render(scene, settings(scene, BuiltInMethod.RAYTRACE, 4));
        assertEquals(green, picture.component(2, 2, 1), 1e-6);
        assertEquals(0.9, picture.component(2, 2, 0), 1e-6);
        assertEquals(0.1, picture.component(2, 2, 2), 1e-6);
    }
}
