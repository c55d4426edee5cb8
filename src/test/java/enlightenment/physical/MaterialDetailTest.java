package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Transform;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Mixes, masks, normal maps and bumps against closed forms, and methods against each other. */
class MaterialDetailTest {
    private static final int SEEDS = 12;
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(SEEDS, 7);
    private static final double INTENSITY = 90;

    @TempDir
    private static Path folder;

    /** The mean of a picture's red by seed. */
    private static double[] means(Scene scene, BuiltInMethod method, int antialias) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        return Rendered.means(Rendered.seeds(scene, settings, 1, SEEDS), 0, 0, scene.width(), scene.height(), 0);
    }

    private static void assertMean(double expected, double[] found) {
        Statistics s = Statistics.of(found);
        assertEquals(expected, s.mean(), 4.5 * s.error() + 1e-5 * expected, s.toString());
        assertTrue(s.error() < 0.04 * expected, () -> "nothing is known: " + s);
    }

    private static void assertAlike(double[] expected, double[] found) {
        assertTrue(
                Welch.of(expected, found).probability() >= Welch.sidak(0.01, 40),
                () -> Statistics.of(found) + " instead of " + Statistics.of(expected));
    }

    private static Texture share(double value) {
        return Texture.of(Rgb.gray(value));
    }

    private static Shape level(double y, double half) {
        return TestScenes.rectangle(-half, y, -half, -half, y, half, half, y, half, half, y, -half);
    }

    /** A view straight down at the origin from a height, with +z upwards. */
    private static Scene.Builder down(double from, double height) {
        return Scene.builder()
                .size(4, 4)
                .camera(new Camera.Orthographic(at(0, from, 0), at(0, 0, 0), Vec3.Z, height))
                .shading(PhysicalScenes.shading(0));
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void aMixReflectsTheMeanOfBothWeightedByProbability(BuiltInMethod method) {
        Material mix = new Composite.Mix(matte(0.2, 0.2, 0.2), matte(0.8, 0.8, 0.8), share(0.25));
        Scene scene = down(1, 1)
                .shading(PhysicalScenes.shading(1))
                .object(level(0, 9), mix)
                .build();
        assertMean(0.75 * 0.2 + 0.25 * 0.8, means(scene, method, 6));
    }

    @Test
    void detailsInsideOfEachOtherAreIndependent() {
        Material black = matte(0, 0, 0);
        Material inner = new Composite.Mix(black, matte(0.8, 0.8, 0.8), share(0.5));
        Scene mixes = down(1, 1)
                .shading(PhysicalScenes.shading(1))
                .object(level(0, 9), new Composite.Mix(inner, black, share(0.5)))
                .build();
        assertMean(0.5 * 0.5 * 0.8, means(mixes, BuiltInMethod.RAYTRACE, 8));
        Scene masks = down(1, 1)
                .shading(PhysicalScenes.shading(1))
                .object(level(0, 9), new Composite.Mask(new Composite.Mask(black, share(0.5)), share(0.5)))
                .build();
        assertMean(0.75, means(masks, BuiltInMethod.RAYTRACE, 8));
    }

    /** A lamp of radiance 50 and radius 0.2, 3 above a floor of reflectance 0.5; a black sheet at 1.5, if not null. */
    private static Scene.Builder lamp(double eye, Material sheet) {
        Scene.Builder scene = down(eye, 0.5)
                .object(level(0, 2), matte(0.5, 0.5, 0.5))
                .light(PhysicalScenes.sphereLight(0, 3, 0, 0.2, 50));
        return sheet == null ? scene : scene.object(level(1.5, 5), sheet);
    }

    private static Material sheet(double alpha) {
        return new Composite.Mask(matte(0, 0, 0), share(alpha));
    }

    /** The eye is below the sheet, or above, where it sees the floor through it as well. */
    @ParameterizedTest
    @CsvSource({
        "RAYTRACE, 1",
        "RAYTRACE, 2.5",
        "CLUSTER, 1",
        "CLUSTER, 2.5",
        "LIGHT, 1",
        "LIGHT, 2.5",
        "BIDIRECTIONAL, 1",
        "BIDIRECTIONAL, 2.5",
        "METROPOLIS, 1",
        "METROPOLIS, 2.5"
    })
    void aMaskThatIsThereHalfOfTheTimeTakesHalfOfTheLight(BuiltInMethod method, double eye) {
        int passes = eye > 1.5 ? 2 : 1;
        int antialias = method == BuiltInMethod.LIGHT ? 48 : 8;
        double[] free = means(lamp(eye, null).build(), method, antialias);
        Statistics whole = Statistics.of(free);
        // Over the square that is seen, the light falls off a little from its middle.
        assertEquals(0.5 * 50 * Math.pow(0.2 / 3, 2), whole.mean(), 0.03 * whole.mean() + 4.5 * whole.error());
        double[] half = means(lamp(eye, sheet(0.5)).build(), method, antialias);
        double share = Math.pow(0.5, passes);
        for (int i = 0; i < free.length; i++) {
            free[i] *= share;
        }
        assertAlike(free, half);
        assertTrue(Statistics.of(half).error() < 0.1 * whole.mean() * share, () -> "" + Statistics.of(half));
        assertEquals(
                0, Statistics.of(means(lamp(eye, sheet(1)).build(), method, 2)).mean());
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void aHoleIsNothing(BuiltInMethod method) {
        assertAlike(
                means(lamp(2.5, null).build(), method, 4),
                means(lamp(2.5, sheet(0)).build(), method, 4));
    }

    @Test
    void aMaskWithoutHolesIsWhatItIsOf() {
        Material whole = new Composite.Mask(PhysicalScenes.RED, share(1));
        assertAlike(
                means(lamp(2.5, PhysicalScenes.RED).build(), BuiltInMethod.RAYTRACE, 4),
                means(lamp(2.5, whole).build(), BuiltInMethod.RAYTRACE, 4));
    }

    /** The eye of a window sees through it from z = 0 on: its rays do not start at their origins. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void holesDoNotChangeHowFarLightGoesInFog(BuiltInMethod method) {
        assertAlike(means(foggy(null).build(), method, 5), means(foggy(sheet(0)).build(), method, 5));
    }

    private static Scene.Builder foggy(Material sheet) {
        Medium fog = new Medium.Coefficients(Rgb.gray(0.25), Rgb.gray(0.125), 0);
        Scene.Builder scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Window(at(0, 0, -1), at(-1, -1, 0), at(-1, 1, 0), at(1, 1, 0), at(1, -1, 0), 0))
                .shading(new Shading.Physical(
                        OptionalInt.empty(), new Shading.Background.Constant(Rgb.BLACK), Optional.of(fog)))
                .object(TestScenes.rectangle(-9, -9, 3, -9, 9, 3, 9, 9, 3, 9, -9, 3), PhysicalScenes.WHITE)
                .light(PhysicalScenes.sphereLight(1.5, 1.5, 1, 0.3, 50));
        for (int k = 1; sheet != null && k < 6; k++) {
            double z = 0.5 * k;
            scene.object(TestScenes.rectangle(-9, -9, z, -9, 9, z, 9, 9, z, 9, -9, z), sheet);
        }
        return scene;
    }

    /** A lamp smaller than a pixel, whose image is sampled apart where nothing is in front of it: behind a mask, paths meet it. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.5, 0.5"})
    void aSmallLampIsSeenThroughAMask(double alpha, double share) {
        double whole =
                Statistics.of(means(behind(null), BuiltInMethod.RAYTRACE, 2)).mean();
        Statistics found = Statistics.of(means(behind(sheet(alpha)), BuiltInMethod.RAYTRACE, 32));
        assertEquals(whole * share, found.mean(), 4.5 * found.error(), found.toString());
        assertTrue(found.error() < 0.1 * whole, found.toString());
    }

    private static Scene behind(Material sheet) {
        Scene.Builder scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 4))
                .shading(PhysicalScenes.shading(0))
                .light(PhysicalScenes.sphereLight(0.4, 0.4, 5, 0.1, 50));
        if (sheet != null) {
            scene.object(TestScenes.rectangle(-9, -9, 2, -9, 9, 2, 9, 9, 2, 9, -9, 2), sheet);
        }
        return scene.build();
    }

    private static final ExactPoint LAMP = at(2, 5, 1);

    /** What a matte of reflectance 0.5 at the origin, with its own normal and one for shading, shows of a point light. */
    private static double lit(Vec3 own, Vec3 shading, Vec3 lamp) {
        Vec3 to = lamp.normalized();
        Vec3 n = shading.normalized();
        double g = Math.min(1, own.dot(to) / (n.dot(to) * own.dot(n)));
        return 0.5 / Math.PI * INTENSITY / lamp.dot(lamp) * n.dot(to) * (-g * g * g + g * g + g);
    }

    private static Scene lit(Shape shape, Material material) {
        return down(2, 1e-6)
                .object(shape, material)
                .light(new Light.Point(LAMP, Rgb.WHITE, Emission.intensity(Rgb.gray(INTENSITY))))
                .build();
    }

    private static double seen(Shape shape, Material material) {
        return Statistics.of(means(lit(shape, material), BuiltInMethod.RAYTRACE, 1))
                .mean();
    }

    private static final Material GREY = matte(0.5, 0.5, 0.5);

    @ParameterizedTest
    @CsvSource({"0.5, 0.5, 1", "0.7, 0.5, 0.9", "0.5, 0.2, 0.9", "0.2, 0.6, 0.8", "0.7, 0.8, 0.75"})
    void aNormalMapIsShadedByItsNormalAlongUAndUpwards(double x, double y, double z) {
        Material material = new Composite.NormalMap(GREY, linear(x, y, z));
        Vec3 normal = new Vec3(2 * x - 1, 2 * z - 1, 2 * y - 1);
        double expected = lit(Vec3.Y, normal, LAMP.toVec3());
        assertEquals(expected, seen(level(0, 2), material), 1e-5 * expected);
    }

    @Test
    void aFlatNormalMapChangesNothing() {
        double expected = seen(level(0, 2), GREY);
        assertEquals(expected, seen(level(0, 2), new Composite.NormalMap(GREY, linear(0.5, 0.5, 1))), 1e-9);
        // A normal that points into the surface is none.
        assertEquals(expected, seen(level(0, 2), new Composite.NormalMap(GREY, linear(0.5, 0.5, 0.25))), 1e-9);
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void lightThatIsCarriedToTheEyeIsShadedAlike(BuiltInMethod method) {
        Material material = new Composite.NormalMap(GREY, linear(0.7, 0.4, 0.85));
        Scene.Builder scene =
                down(2, 0.5).object(level(0, 0.5), material).light(PhysicalScenes.sphereLight(2, 5, 1, 0.5, 50));
        assertAlike(means(scene.build(), BuiltInMethod.RAYTRACE, 6), means(scene.build(), method, 6));
    }

    /** Heights of 64 × 64 texels at their centres: a function of u and v. */
    private static Texture heights(String name, DoubleBinaryOperator height) throws IOException {
        int n = 64;
        float[] rgb = new float[3 * n * n];
        for (int k = 0; k < n * n; k++) {
            float h = (float) height.applyAsDouble((k % n + 0.5) / n, (k / n + 0.5) / n);
            rgb[3 * k] = h;
            rgb[3 * k + 1] = h;
            rgb[3 * k + 2] = h;
        }
        Path file = folder.resolve(name + ".png");
        ImageFiles.writePng(new Image(n, n, rgb), file, ImageFiles.PngOptions.DEFAULT.withDepth(16));
        return new Texture.File(file, Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    }

    /** The slopes of heights of 16 bits over a texel are true to 64 / 65535. */
    private static void assertSlope(double expected, double found) {
        assertEquals(expected, found, 2e-3 * expected);
    }

    @Test
    void aRampIsShadedAsThePlaneThatItIs() throws IOException {
        Vec3 lamp = LAMP.toVec3();
        Texture right = heights("right", (u, v) -> u);
        Texture up = heights("up", (u, v) -> 1 - v);
        Shape square = level(0, 2);
        assertSlope(lit(Vec3.Y, new Vec3(-2.0 / 4, 1, 0), lamp), seen(square, new Composite.Bump(GREY, right, 2)));
        assertSlope(lit(Vec3.Y, new Vec3(1.0 / 4, 1, 0), lamp), seen(square, new Composite.Bump(GREY, right, -1)));
        assertSlope(lit(Vec3.Y, new Vec3(0, 1, -2.0 / 4), lamp), seen(square, new Composite.Bump(GREY, up, 2)));
        // Where u and v are not at right angles: u = (x − z/2 + 1) / 4, but for a constant.
        Shape slanted = TestScenes.rectangle(-3, 0, -2, -1, 0, 2, 3, 0, 2, 1, 0, -2);
        assertSlope(
                lit(Vec3.Y, new Vec3(-2.0 / 4, 1, 1.0 / 4), lamp), seen(slanted, new Composite.Bump(GREY, right, 2)));
        assertSlope(lit(Vec3.Y, new Vec3(0, 1, -2.0 / 4), lamp), seen(slanted, new Composite.Bump(GREY, up, 2)));
    }

    /** At an edge there is nothing beyond to compare with: not the other end of the texture, either. */
    @Test
    void aRampHasNoStepAtTheEdgeOfARectangle() throws IOException {
        Texture right = heights("edge", (u, v) -> u);
        Shape edge = TestScenes.rectangle(-0.001, 0, -2, -0.001, 0, 2, 3.999, 0, 2, 3.999, 0, -2);
        double flat = lit(Vec3.Y, Vec3.Y, LAMP.toVec3());
        double tilted = lit(Vec3.Y, new Vec3(-2.0 / 4, 1, 0), LAMP.toVec3());
        double found = seen(edge, new Composite.Bump(GREY, right, 2));
        assertTrue(found >= Math.min(flat, tilted) - 1e-3 && found <= Math.max(flat, tilted) + 1e-3, "" + found);
    }

    @Test
    void meshesAndSpheresHaveTheSameSlopes() throws IOException {
        Texture right = heights("around", (u, v) -> u);
        TriangleMesh mesh = TriangleMesh.of(
                        new float[] {-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1}, new int[] {0, 1, 2, 0, 2, 3})
                .withUv(new float[] {0, 0, 0, 1, 1, 1, 1, 0});
        Shape square = Mesh.of(
                mesh,
                Transform.of(
                        new Transform.Scale(new Vec3(2, 1, 2)), new Transform.Translate(ExactPoint.of(0.1, 0, 0.2))));
        assertSlope(
                lit(Vec3.Y, new Vec3(-2.0 / 4, 1, 0), LAMP.toVec3()), seen(square, new Composite.Bump(GREY, right, 2)));
        // The front of a ball around (0, 0, 1), at the origin, where u grows along +x by 1 in 2π.
        Scene ball = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Orthographic(at(0, 0, -2), at(0, 0, 0), Vec3.Y, 1e-6))
                .shading(PhysicalScenes.shading(0))
                .object(new Sphere(at(0, 0, 1), 1, 90), new Composite.Bump(GREY, right, 2))
                .light(new Light.Point(at(3, 1, -4), Rgb.WHITE, Emission.intensity(Rgb.gray(INTENSITY))))
                .build();
        Vec3 own = new Vec3(0, 0, -1);
        assertSlope(
                lit(own, new Vec3(-2 / (2 * Math.PI), 0, -1), new Vec3(3, 1, -4)),
                Statistics.of(means(ball, BuiltInMethod.RAYTRACE, 1)).mean());
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "LIGHT", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfAllFour(BuiltInMethod method) throws IOException {
        Texture waves =
                heights("waves", (u, v) -> 0.5 + 0.25 * Math.sin(20 * Math.PI * u) + 0.25 * Math.sin(12 * Math.PI * v));
        Material plastic = Coated.of(linear(0.2, 0.4, 0.7), 0.6);
        Scene scene = PhysicalScenes.room()
                .object(PhysicalScenes.ball(-0.4, 0.45, 0.2, 0.4), new Composite.Bump(plastic, waves, 0.1))
                .object(
                        TestScenes.rectangle(0.2, 0.1, -0.3, 0.2, 1, -0.1, 0.9, 1, 0.2, 0.9, 0.1, 0),
                        new Composite.NormalMap(PhysicalScenes.GREEN, linear(0.7, 0.4, 0.85)))
                .object(
                        TestScenes.rectangle(-0.7, 1.4, -0.5, -0.7, 1.4, 0.5, 0.7, 1.4, 0.5, 0.7, 1.4, -0.5),
                        new Composite.Mask(
                                new Composite.Mix(PhysicalScenes.RED, PhysicalScenes.WHITE, share(0.5)),
                                new Texture.Checker(List.of(Rgb.gray(0.75), Rgb.BLACK), 4)))
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false))
                .build();
        assertOnePicture("all four", scene, method);
    }

    /** Caustics of a bumped mirror ball, of a mirror that is matte in places, and of polished metal with holes. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void allMethodsMakeOnePictureOfCaustics(BuiltInMethod method) throws IOException {
        Texture waves =
                heights("dents", (u, v) -> 0.5 + 0.25 * Math.sin(12 * Math.PI * u) + 0.25 * Math.sin(8 * Math.PI * v));
        Material mirror = Material.Mirror.of(linear(0.9, 0.8, 0.7));
        Scene scene = PhysicalScenes.room()
                .object(PhysicalScenes.ball(-0.4, 0.45, 0.2, 0.4), new Composite.Bump(mirror, waves, 0.1))
                .object(
                        TestScenes.rectangle(0.2, 0.1, -0.3, 0.2, 1, -0.1, 0.9, 1, 0.2, 0.9, 0.1, 0),
                        new Composite.Mix(mirror, PhysicalScenes.GREEN, share(0.5)))
                .object(
                        TestScenes.rectangle(-0.7, 1.3, -0.5, -0.7, 1.5, 0.5, 0.7, 1.5, 0.5, 0.7, 1.3, -0.5),
                        new Composite.Mask(Glossy.of(linear(0.9, 0.9, 0.9), 0.2), share(0.5)))
                .light(PhysicalScenes.panel(0, 1.95, 0, 0.3, Rgb.gray(20), false))
                .build();
        assertOnePicture("caustics", scene, method);
    }

    private static void assertOnePicture(String name, Scene scene, BuiltInMethod method) {
        List<Image> expected = REFERENCES.of(name, scene);
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(7);
        List<Image> found = Rendered.seeds(scene, settings, 1, SEEDS);
        for (int part = 0; part < 4; part++) {
            int x = part % 2 * 8;
            int y = part / 2 * 8;
            for (int band = 0; band < 3; band++) {
                double[] a = Rendered.means(expected, x, y, x + 8, y + 8, band);
                double[] b = Rendered.means(found, x, y, x + 8, y + 8, band);
                String told =
                        "part " + part + ", band " + band + ": " + Statistics.of(b) + " instead of " + Statistics.of(a);
                assertTrue(Welch.of(a, b).probability() >= Welch.sidak(0.01, 48), told);
                assertTrue(Statistics.of(b).error() < 0.08 * Statistics.of(b).mean(), told);
            }
        }
    }
}
