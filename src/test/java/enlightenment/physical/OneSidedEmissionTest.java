package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.image.Image;
import enlightenment.material.Material;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Surfaces that glow to their front alone: darkness behind them, closed forms before them, the same picture by every method. */
class OneSidedEmissionTest {
    private static final double REFLECTANCE = 0.6;
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(12, 4);

    private static final Material.EmissionPattern FRONT =
            Material.EmissionPattern.EVEN.withSide(Material.EmissionPattern.Side.FRONT);

    private static final Material.EmissionPattern BACK =
            Material.EmissionPattern.EVEN.withSide(Material.EmissionPattern.Side.BACK);

    private static Material.Matte lamp(double color, Rgb radiance, Material.EmissionPattern pattern) {
        return matte(color, color, color).withRadiance(radiance).withPattern(pattern);
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withThreads(1).withAntialias(antialias);
    }

    /** The floor around the origin, lit by lamps above it. */
    private static Scene floor(List<Shape> lamps, Material material) {
        Scene.Builder scene = Scene.builder()
                .size(4, 4)
                .shading(shading(0))
                .camera(new Camera.Perspective(at(0, 0.25, 0), at(0, 0, 0), Vec3.Z, 0.01))
                .object(
                        TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9),
                        matte(REFLECTANCE, REFLECTANCE, REFLECTANCE));
        lamps.forEach(shape -> scene.object(shape, material));
        return scene.build();
    }

    /** Triangles whose normals point down, unless they are turned. */
    private static Mesh quad(boolean isTurned, Transform transform) {
        MeshBuilder mesh = new MeshBuilder();
        mesh.vertex(-1, 0.5, -1);
        mesh.vertex(1, 0.5, -1);
        mesh.vertex(1, 0.5, 1);
        mesh.vertex(-1, 0.5, 1);
        mesh.triangle(0, isTurned ? 2 : 1, isTurned ? 1 : 2);
        mesh.triangle(0, isTurned ? 3 : 2, isTurned ? 2 : 3);
        return Mesh.of(mesh.build(), transform);
    }

    /**
     * Lamps half a unit above the floor. Which way they face is computed by the rules of the scene format.
     *
     * @param isUp whether their fronts look away from the floor
     * @param factor the view factor from the middle of the floor to them
     */
    private record Lamps(String name, boolean isUp, List<Shape> shapes, double factor) {
        @Override
        public String toString() {
            return name + (isUp ? " up" : " down");
        }
    }

    /** The view factor from a point to a square of side 2 that is half a unit above it: four times that of a quarter. */
    private static double square() {
        double a = 1 / 0.5;
        double root = Math.sqrt(1 + a * a);
        return 4 * a / root * Math.atan(a / root) / Math.PI;
    }

    private static Stream<Lamps> lamps() {
        Transform mirror = Transform.of(new Transform.Scale(new Vec3(-1, 1, 1)));
        List<Lamps> all = new ArrayList<>();
        for (boolean isUp : new boolean[] {false, true}) {
            double z = isUp ? 1 : -1;
            // (upper left − lower left) × (lower right − lower left) = (2, 0, 0) × (0, 0, −2z) = (0, 4z, 0)
            Shape rectangle = TestScenes.rectangle(-1, 0.5, z, 1, 0.5, z, 1, 0.5, -z, -1, 0.5, -z);
            // (b − a) × (c − a) = (2, 0, 0) × (2, 0, −2z), and (2, 0, −2z) × (0, 0, −2z)
            Shape one = new Triangle(at(-1, 0.5, z), at(1, 0.5, z), at(1, 0.5, -z));
            Shape two = new Triangle(at(-1, 0.5, z), at(1, 0.5, -z), at(-1, 0.5, -z));
            all.add(new Lamps("rectangle", isUp, List.of(rectangle), square()));
            all.add(new Lamps("triangles", isUp, List.of(one, two), square()));
            all.add(new Lamps("mesh", isUp, List.of(quad(isUp, Transform.IDENTITY)), square()));
            all.add(new Lamps("mirrored mesh", isUp, List.of(quad(!isUp, mirror)), square()));
            Disk disk = new Disk(at(0, 0.5, 0), new Vec3(0, isUp ? 1 : -1, 0), 0.75);
            all.add(new Lamps("disk", isUp, List.of(disk), 0.75 * 0.75 / (0.75 * 0.75 + 0.25)));
        }
        return all.stream();
    }

    private static Stream<Arguments> lampsAndMethods() {
        return lamps().flatMap(l -> Stream.of(BuiltInMethod.values()).map(m -> Arguments.of(l, m)));
    }

    @ParameterizedTest
    @MethodSource("lampsAndMethods")
    void behindIsNoLightAtAllAndBeforeThatOfBothSides(Lamps lamps, BuiltInMethod method) {
        compare(lamps, method, FRONT, lamps.isUp());
    }

    @ParameterizedTest
    @MethodSource("lampsAndMethods")
    void backsShineWhereFrontsDoNot(Lamps lamps, BuiltInMethod method) {
        compare(lamps, method, BACK, !lamps.isUp());
    }

    private static void compare(Lamps lamps, BuiltInMethod method, Material.EmissionPattern pattern, boolean isDark) {
        Rgb radiance = new Rgb(2, 1, 0.5);
        Scene scene = floor(lamps.shapes(), lamp(0, radiance, pattern));
        if (isDark) {
            assertBlack(Renderer.render(scene, settings(scene, method, 4)));
        } else if (method != BuiltInMethod.LIGHT && method != BuiltInMethod.METROPOLIS) {
            // Of light paths few hit what the eye sees of this floor.
            double e = REFLECTANCE * lamps.factor();
            new ClosedForms.Known(lamps.name(), scene, 2 * e, e, e / 2).assertShown(settings(scene, method, 8));
        }
    }

    private static void assertBlack(Image picture) {
        assertArrayEquals(new float[3 * picture.width() * picture.height()], picture.toArray());
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void anOpenTubeShinesOutwardsAlone(BuiltInMethod method) {
        List<Shape> tube = List.of(new Cylinder(at(0, 0, 0), at(0, 1, 0), 0.75, false));
        Scene dark = floor(tube, lamp(0, Rgb.WHITE, FRONT));
        assertBlack(Renderer.render(dark, settings(dark, method, 4)));
        Scene lit = floor(tube, lamp(0, Rgb.WHITE, Material.EmissionPattern.EVEN));
        assertTrue(Rendered.mean(lit, settings(lit, BuiltInMethod.RAYTRACE, 4)) > 0.1);
    }

    /** Closed shapes around the origin, with room for a camera there. */
    private static Stream<Shape> hollows() {
        MeshBuilder pyramid = new MeshBuilder();
        pyramid.vertex(-2, -1, -2);
        pyramid.vertex(2, -1, -2);
        pyramid.vertex(0, -1, 3);
        pyramid.vertex(0, 3, 0);
        pyramid.triangle(0, 1, 2);
        pyramid.triangle(0, 3, 1);
        pyramid.triangle(1, 3, 2);
        pyramid.triangle(2, 3, 0);
        return Stream.of(
                ball(0.1, 0.2, -0.1, 1),
                new Box(at(-1, -0.5, -0.7), at(1.2, 0.8, 1.5)),
                new Cube(at(0.1, 0, 0), 2, new Vec3(20, 30, 40)),
                new Cylinder(at(0, -1, 0), at(0.2, 1, 0), 0.9, true),
                new Cone(at(0, -0.5, 0), at(0, 2, 0), 1.5, 0.2, true),
                new Torus(at(-1, 0, 0), Vec3.Y, 1, 0.5),
                Mesh.of(pyramid.build()));
    }

    private static Stream<Arguments> hollowsAndMethods() {
        return hollows().flatMap(h -> Stream.of(BuiltInMethod.values()).map(m -> Arguments.of(h, m)));
    }

    private static Scene view(Shape hollow, Vec3 eye, Material material) {
        return Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(at(eye), at(0.1, 0.2, 1), Vec3.Y, 40))
                .shading(shading(0))
                .object(hollow, material)
                .build();
    }

    /** Walls that glow inwards and reflect: Le + ρ Le + ρ² Le + …, and nothing outside. */
    @ParameterizedTest
    @MethodSource("hollowsAndMethods")
    void aHollowThatGlowsInwardsIsAFurnaceAndDarkFromOutside(Shape hollow, BuiltInMethod method) {
        Material wall = lamp(0.5, new Rgb(1, 0.5, 0.25), BACK);
        Scene inside = view(hollow, new Vec3(0.1, 0.05, -0.1), wall);
        new ClosedForms.Known("hollow", inside, 2, 1, 0.5).assertShown(settings(inside, method, 4));
        Scene outside = view(hollow, new Vec3(0.1, 0.3, -6), wall);
        for (float v : Renderer.render(outside, settings(outside, method, 4)).toArray()) {
            // Points on the two sides of a face see each other at cosines of rounding.
            assertEquals(0, v, 1e-20f);
        }
    }

    /** A ball that reflects a part of what comes from everywhere. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void whatStandsInAHollowIsLitFromEverywhere(BuiltInMethod method) {
        for (Shape hollow : List.of(ball(0, 0, 0, 3), new Box(at(-2, -2, -2), at(2, 2, 2)))) {
            Scene scene = Scene.builder()
                    .size(8, 8)
                    .camera(new Camera.Perspective(at(0, 0, -1.5), at(0, 0, 0), Vec3.Y, 20))
                    .shading(shading(0))
                    .object(hollow, lamp(0, new Rgb(1, 0.5, 0.25), BACK))
                    .object(ball(0, 0, 0, 0.5), matte(REFLECTANCE, REFLECTANCE, REFLECTANCE))
                    .build();
            new ClosedForms.Known("ball", scene, REFLECTANCE, REFLECTANCE / 2, REFLECTANCE / 4)
                    .assertShown(settings(scene, method, 8));
        }
    }

    @Test
    void theFrontOfSolidsIsTheirOutside() {
        Scene both = balls(Material.EmissionPattern.EVEN);
        Scene front = balls(FRONT);
        RenderSettings settings = settings(both, BuiltInMethod.RAYTRACE, 4);
        assertEquals(Rendered.mean(both, settings), Rendered.mean(front, settings));
        assertTrue(Rendered.mean(front, settings) > 0.01);
    }

    private static Scene balls(Material.EmissionPattern pattern) {
        return PhysicalScenes.room()
                .object(ball(0.3, 0.5, 0.1, 0.25), lamp(0.4, Rgb.WHITE, pattern))
                .object(PartnerScenes.BLOCK, lamp(0.4, Rgb.WHITE, pattern))
                .build();
    }

    @Test
    void oneSideBelongsToWhatGlows() {
        String message = assertThrows(
                        InvalidValueException.class, () -> matte(0.5, 0.5, 0.5).withPattern(FRONT))
                .getMessage();
        assertTrue(message.contains("radianceSide"), message);
    }

    /** Strips that together are a curved sheet of 40 triangles, which glows towards the viewer and up. */
    private static Mesh sheet() {
        MeshBuilder mesh = new MeshBuilder();
        int strips = 20;
        for (int k = 0; k <= strips; k++) {
            double angle = 0.5 * Math.PI * k / strips;
            mesh.vertex(-0.9, 1 - 0.6 * Math.cos(angle), 0.2 + 0.6 * Math.sin(angle));
            mesh.vertex(-0.2, 1 - 0.6 * Math.cos(angle), 0.2 + 0.6 * Math.sin(angle));
        }
        for (int k = 0; k < strips; k++) {
            mesh.triangle(2 * k, 2 * k + 2, 2 * k + 1);
            mesh.triangle(2 * k + 1, 2 * k + 2, 2 * k + 3);
        }
        return Mesh.of(mesh.build());
    }

    /** Lamps with one side, as many as make a tree of lights, with or without a mirror that throws caustics. */
    private static Scene room(boolean hasMirror, Material.EmissionPattern pattern) {
        // A tube that glows inwards shines out of its upper end.
        Scene.Builder room = PhysicalScenes.room()
                .object(sheet(), lamp(0.5, new Rgb(1, 2, 3), pattern))
                // Lit from behind by what the wall reflects.
                .object(
                        TestScenes.rectangle(0.1, 1.2, 0.8, 0.1, 1.8, 0.8, 0.9, 1.8, 0.6, 0.9, 1.2, 0.6),
                        lamp(0.5, new Rgb(4, 3, 2), pattern))
                .object(new Disk(at(-0.5, 1.7, -0.2), new Vec3(0.3, 1, 0.1), 0.3), lamp(0.5, new Rgb(5, 2, 5), pattern))
                .object(new Cylinder(at(0.5, 0, -0.5), at(0.5, 0.3, -0.5), 0.2, false), lamp(0.3, Rgb.WHITE, pattern));
        if (hasMirror) {
            room.object(ball(0.3, 0.6, 0.2, 0.3), Material.Mirror.of(PhysicalScenes.linear(0.9, 0.9, 0.9)));
        }
        return room.build();
    }

    private static Stream<Arguments> sidesAndMethods() {
        return Stream.of(FRONT, BACK).flatMap(p -> Stream.of(BuiltInMethod.values())
                .filter(m -> m != BuiltInMethod.RAYTRACE)
                .map(m -> Arguments.of(p, m)));
    }

    @ParameterizedTest
    @MethodSource("sidesAndMethods")
    void allMethodsMakeThePictureOfSinglePaths(Material.EmissionPattern pattern, BuiltInMethod method) {
        // Light paths do not find what mirrors show.
        Scene scene = room(method != BuiltInMethod.LIGHT, pattern);
        List<Image> traced =
                REFERENCES.of(pattern.side() + " " + scene.objects().size(), scene);
        List<Image> others = Rendered.seeds(scene, settings(scene, method, 4), 1, 12);
        Rendered.assertPartsAgree(traced, others, 48);
    }

    @Test
    void singlePathsMakeThePictureOfPathsThatAimAtNoLight() {
        NaivePartnerTest.compare(room(true, FRONT), 2, 8, 3_000);
        NaivePartnerTest.compare(room(true, BACK), 2, 8, 3_000);
    }
}
