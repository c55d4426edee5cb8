package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Sphere;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Things that glow or absorb, and faces of other things in the same place: what lies on what changes no distance, and hides nothing. */
class TouchingShapesTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;
    private static final double GAP = 1e-6;

    private static final Material GLOWING = matte(0, 0, 0).withRadiance(Rgb.WHITE);

    private static Material absorbing(double absorption) {
        return new Glass(linear(1, 1, 1), 1, 1, 0, true).withAbsorption(Rgb.gray(absorption));
    }

    private static double mean(Scene scene, BuiltInMethod method, int antialias) {
        return Rendered.mean(scene, RenderSettings.of(scene).withMethod(method).withAntialias(antialias));
    }

    private static void assertSame(BuiltInMethod method, Scene gap, Scene contact) {
        assertSame(method, gap, contact, 12, 0.03);
    }

    private static void assertSame(BuiltInMethod method, Scene gap, Scene contact, int antialias, double relative) {
        Rendered.assertContactIsLimit(mean(gap, method, antialias), mean(contact, method, antialias), relative);
    }

    private static Scene.Builder small(Vec3 eye) {
        return PhysicalScenes.view(2, 2).camera(new Camera.Orthographic(at(eye), at(eye.plus(Vec3.Z)), Vec3.Y, 0.1));
    }

    /** Beer's law holds up to what is flush on a block of glass: 2.5 units of water at 0.3. */
    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "LIGHT", "METROPOLIS"})
    void waterAbsorbsOnTheWholeWayToALabelOnGlass(BuiltInMethod method) {
        Scene scene = small(new Vec3(0, 0, -3))
                .object(new Sphere(at(0, 0, 0), 6, 0), absorbing(0.3))
                .object(new Box(at(-0.5, -0.5, -0.5), at(0.5, 0.5, 0.5)), new Glass(linear(1, 1, 1), 1.5, 1, 0, true))
                .object(
                        TestScenes.rectangle(-0.4, -0.4, -0.5, -0.4, 0.4, -0.5, 0.4, 0.4, -0.5, 0.4, -0.4, -0.5),
                        GLOWING)
                .build();
        assertEquals(Math.exp(-0.3 * 2.5), mean(scene, method, 32), method == BuiltInMethod.LIGHT ? 0.05 : 1e-6);
    }

    /** The same up to a label around the glass. */
    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL"})
    void glassAbsorbsOnTheWholeWayToALabelAroundIt(BuiltInMethod method) {
        Scene scene = small(Vec3.ZERO)
                .object(new Cylinder(at(0, -0.5, 0), at(0, 0.5, 0), 0.5, true), absorbing(1))
                .object(new Cylinder(at(0, -0.5, 0), at(0, 0.5, 0), 0.5, false), GLOWING)
                .build();
        // Rays that are off the axis meet it up to 0.05²/2 earlier.
        assertEquals(Math.exp(-0.5), mean(scene, method, 8), 1e-3);
    }

    /** A glowing shade around a glass that does nothing lights the floor under it as without the glass. */
    private static Scene shade(boolean isFull) {
        Scene.Builder b = PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, -0.2, -3), at(0, -0.6, 0), Vec3.Y, 30))
                .object(new Disk(at(0, -0.6, 0), Vec3.Y, 3), matte(1, 1, 1))
                .object(new Cylinder(at(0, -0.5, 0), at(0, 0.5, 0), 0.7, false), GLOWING);
        return (isFull ? b.object(new Cylinder(at(0, -0.5, 0), at(0, 0.5, 0), 0.7, true), absorbing(0)) : b).build();
    }

    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "LIGHT"})
    void clearGlassInAGlowingTubeChangesNothing(BuiltInMethod method) {
        assertSame(method, shade(false), shade(true));
    }

    /** A cube of fog of which one face glows, and a box of fog with a glowing label: the same. */
    private static Scene fog(boolean isCube, Vec3 eye, Vec3 lookAt, Vec3 rotation) {
        Material fog = Material.Scattering.of(Medium.Coefficients.of(Rgb.WHITE, Rgb.BLACK));
        Scene.Builder b =
                PhysicalScenes.view(WIDTH, HEIGHT).camera(new Camera.Perspective(at(eye), at(lookAt), Vec3.Y, 35));
        double radius = Math.sqrt(0.75);
        if (!isCube) {
            Cube shape = new Cube(at(0, 0, 0), radius, Vec3.ZERO);
            double h = 0.5;
            return b.object(shape, fog)
                    .object(TestScenes.rectangle(-h, -h, h, -h, h, h, -h, h, -h, -h, -h, -h), GLOWING)
                    .build();
        }
        List<Material> faces = Stream.concat(Stream.of(GLOWING), Collections.nCopies(5, fog).stream())
                .toList();
        return b.object(new SceneObject("", new Cube(at(0, 0, 0), radius, rotation), fog, faces))
                .build();
    }

    @ParameterizedTest
    @EnumSource(names = {"LIGHT", "BIDIRECTIONAL"})
    void lightThatLeavesACubeOfFogIsNotInTheFog(BuiltInMethod method) {
        Scene beside = fog(true, new Vec3(5, 5, -5), new Vec3(3, 4, 0), Vec3.ZERO);
        assertEquals(0, mean(beside, method, 16));
    }

    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "LIGHT", "BIDIRECTIONAL", "CLUSTER"})
    void aGlowingFaceOfACubeOfFogIsALabelOnIt(BuiltInMethod method) {
        Vec3 eye = new Vec3(1.3, 1.5, -4);
        double label = mean(fog(false, eye, Vec3.ZERO, Vec3.ZERO), BuiltInMethod.RAYTRACE, 48);
        double face = mean(fog(true, eye, Vec3.ZERO, Vec3.ZERO), method, 48);
        assertEquals(label, face, 0.04 * label);
    }

    @ParameterizedTest
    @EnumSource(names = {"LIGHT", "BIDIRECTIONAL"})
    void lightOfATurnedCubeOfFogIsScatteredInIt(BuiltInMethod method) {
        Scene scene = fog(true, new Vec3(1.3, 1.5, -4), Vec3.ZERO, new Vec3(10, 20, 30));
        double expected = mean(scene, BuiltInMethod.RAYTRACE, 48);
        assertEquals(expected, mean(scene, method, 48), 0.04 * expected);
    }

    /** A disk that glows on the rim of a tube without ends, which is narrower. */
    private static Scene lampshade(double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0.2, -1.5, 0), at(-0.3, 0, 0), Vec3.X, 30))
                .shading(PhysicalScenes.atMost(1, 0))
                .object(new Disk(at(0, 0.5, 0), Vec3.Y.negated(), 0.7), GLOWING)
                .object(new Cylinder(at(0, -0.5, 0), at(0, 0.5 - gap, 0), 0.5, false), matte(0.7, 0.7, 0.7))
                .build();
    }

    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "LIGHT"})
    void aLampOnTheRimOfATubeShinesThroughNoWall(BuiltInMethod method) {
        assertSame(method, lampshade(GAP), lampshade(0), 32, 0.005);
    }

    /** A glowing sleeve that reaches beyond the post that it is on. */
    private static Scene sleeve(double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 2.5, -0.6), at(0, 0.3, 0), Vec3.Y, 20))
                .shading(PhysicalScenes.atMost(1, 0))
                .object(new Cylinder(at(0, -0.5, 0), at(0, 0.8, 0), 0.5 + gap, false), GLOWING)
                .object(new Cylinder(at(0, -0.6, 0), at(0, 0.3, 0), 0.5, true), matte(0.7, 0.7, 0.7))
                .build();
    }

    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "LIGHT"})
    void aSleeveThatIsLongerThanItsPostLightsItsEnd(BuiltInMethod method) {
        assertSame(method, sleeve(GAP), sleeve(0), 32, 0.005);
    }

    /** A glass of six faces, of which the far one is painted and glows, and in its corner another glass that may reach to that. */
    private static Scene painted(double gap) {
        Material glass = absorbing(0);
        Material paint = matte(0.3, 0.3, 0.3).withRadiance(Rgb.WHITE);
        List<Material> faces = Stream.concat(Collections.nCopies(5, glass).stream(), Stream.of(paint))
                .toList();
        Cube cube = new Cube(at(0, 0, 0), Math.sqrt(0.75), Vec3.ZERO);
        return small(new Vec3(0.25, 0.25, -3))
                .object(new SceneObject("", cube, glass, faces))
                .object(new Box(at(0, 0, 0), at(0.5, 0.5, 0.5 - gap)), new Glass(linear(1, 1, 1), 1, 1, 1, true))
                .build();
    }

    @ParameterizedTest
    @EnumSource(names = {"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS"})
    void aPaintedFaceIsNoInterfaceOfTheGlassThatEndsOnIt(BuiltInMethod method) {
        assertEquals(1, mean(painted(GAP), method, 8), 1e-6);
        assertEquals(1, mean(painted(0), method, 8), 1e-6);
    }

    /** A lamp on the floor of a box room, under a cylinder of fog: three things in one plane. */
    private static Scene lampUnderFog(double gap) {
        return PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0.2, 1.3, -2.8), at(0, 0.8, 0), Vec3.Y, 60))
                .object(new Box(at(-3, 0, -3), at(3, 3, 3)), matte(0.6, 0.6, 0.6))
                .object(
                        new Cylinder(at(0, 2 * gap, 0), at(0, 0.5, 0), 1, true),
                        Material.Scattering.of(Medium.Coefficients.of(Rgb.WHITE, Rgb.BLACK)))
                .light(PhysicalScenes.panel(0, gap, -0.3, 0.5, Rgb.gray(2), true))
                .build();
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "LIGHT"})
    void aLampOnTheFloorUnderFogShinesIntoIt(BuiltInMethod method) {
        assertSame(method, lampUnderFog(GAP), lampUnderFog(0));
    }
}
