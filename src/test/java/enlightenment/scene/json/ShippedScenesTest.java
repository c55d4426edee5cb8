package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The scenes that the program comes with; the expected numbers are those of the original's {@code World.java}. */
class ShippedScenesTest {
    private static final Camera WINDOW = window(0.5);

    @TempDir
    static Path folder;

    private static Path scenes;

    private static Camera window(double pupilRadius) {
        return new Camera.Window(p(0, 1, -3), p(-3, 0, 0), p(-3, 3, 0), p(3, 3, 0), p(3, 0, 0), pupilRadius);
    }

    private static ExactPoint p(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    private static Material matte(int r, int g, int b) {
        return Material.Matte.of(Texture.of(DisplayRgb.ofBytes(r, g, b)));
    }

    private static Texture image(String name) {
        return new Texture.File(
                folder.resolve("textures").resolve(name), Texture.Filter.BILINEAR, Texture.Encoding.SRGB);
    }

    @BeforeAll
    static void copyScenes() {
        scenes = Documents.shippedScenes(folder);
    }

    private static Scene read(String name) {
        return SceneReader.read(scenes.resolve(name));
    }

    @Test
    void fireAndIceHasTheOriginalsNumbers() {
        Scene s = read("fire-and-ice.json");
        assertEquals(800, s.width());
        assertEquals(400, s.height());
        assertEquals(WINDOW, s.camera());
        assertEquals(new Shading.Classic(0.5, 0.5, DisplayRgb.BLACK, 100), s.shading());
        assertEquals(new RenderSettings.Defaults(Method.RAYTRACE, 4, ChosenSettings.NONE), s.render());
        assertEquals(List.of(new Light.Sphere(p(0, 1, 1), 0.15, DisplayRgb.WHITE)), s.lights());
        List<Shape> shapes = s.objects().stream().map(o -> o.shape()).toList();
        assertEquals(
                List.of(
                        new Sphere(p(-2, 1, 4), 1.5, 200),
                        new Sphere(p(2, 1, 4), 1.5, 90),
                        new Sphere(p(0, 3, 4), 0.75, 0),
                        new Rectangle(p(-6, -6, 8), p(-6, 6, 8), p(6, 6, 8), p(6, -6, 8)),
                        new Rectangle(p(6, -6, -2), p(6, 6, -2), p(6, 6, 8), p(6, -6, 8)),
                        new Rectangle(p(-6, -6, -2), p(-6, -6, 8), p(6, -6, 8), p(6, -6, -2)),
                        new Rectangle(p(-6, -6, -2), p(-6, 6, -2), p(-6, 6, 8), p(-6, -6, 8)),
                        new Rectangle(p(-6, 6, -2), p(-6, 6, 8), p(6, 6, 8), p(6, 6, -2))),
                shapes);
        List<Material> materials = s.objects().stream().map(o -> o.material()).toList();
        assertEquals(
                List.of(
                        Material.Matte.of(image("ice.png")),
                        Material.Matte.of(image("fire.png")),
                        Material.Mirror.of(Texture.of(DisplayRgb.WHITE)),
                        Material.Matte.of(image("wall-back.png")),
                        Material.Matte.of(image("wall-right.png")),
                        Material.Matte.of(image("floor.png")),
                        Material.Matte.of(image("wall-left.png")),
                        new Material.Matte(image("sky.png"), false)),
                materials);
    }

    @Test
    void theFilmMovesTheMirrorAndTurnsBothBalls() {
        Path file = scenes.resolve("fire-and-ice-tween.json");
        Scene still = SceneReader.read(file);
        assertEquals(401, still.animation().orElseThrow().frames());
        assertEquals(25, still.animation().orElseThrow().framesPerSecond());
        assertEquals(still.objects(), SceneReader.read(file, 0).objects());
        for (int frame : new int[] {0, 1, 37, 200, 400}) {
            Scene s = SceneReader.read(file, frame);
            assertEquals(
                    new Sphere(ExactPoint.of("" + BigDecimal.valueOf(frame - 200, 2), "3.5", "4"), 0.75, 0),
                    s.objects().get(2).shape());
            double rotation = 0.9 * frame;
            assertEquals(rotation, ((Sphere) s.objects().get(0).shape()).rotation(), Math.ulp(rotation));
            assertEquals(rotation, ((Sphere) s.objects().get(1).shape()).rotation(), Math.ulp(rotation));
        }
    }

    @Test
    void theFilmIsOtherwiseFireAndIce() {
        Scene picture = read("fire-and-ice.json");
        Scene film = read("fire-and-ice-tween.json");
        assertEquals(picture.camera(), film.camera());
        assertEquals(picture.lights(), film.lights());
        assertEquals(picture.materials(), film.materials());
        assertEquals(picture.objects().subList(3, 8), film.objects().subList(3, 8));
    }

    @Test
    void cylindersHasTheOriginalsNumbers() {
        Scene s = read("cylinders.json");
        assertEquals(window(2), s.camera());
        assertEquals(List.of(new Light.Sphere(p(1, 2, 1), 0.25, DisplayRgb.WHITE)), s.lights());
        assertEquals(
                new Cylinder(p(-1, 2, 3), p(-4, 2, 6), 1, true),
                s.objects().get(0).shape());
        assertEquals(new Sphere(p(2, 0, 2), 1, 0), s.objects().get(1).shape());
        s.objects().forEach(o -> assertEquals(matte(199, 21, 133), o.material()));
    }

    @Test
    void coneHasTheOriginalsNumbers() {
        Scene s = read("cone.json");
        assertEquals(window(2), s.camera());
        assertEquals(0.5, ((Shading.Classic) s.shading()).ambient());
        assertEquals(List.of(new Light.Sphere(p(1, 2, 0), 0.25, DisplayRgb.WHITE)), s.lights());
        assertEquals(
                new Cone(p(-1, 2, 4), p(-4, 2, 4.5), 1, 0, true),
                s.objects().get(0).shape());
        assertEquals(matte(199, 21, 133), s.objects().get(0).material());
    }

    @Test
    void cubeHasTheOriginalsNumbersAndColours() {
        Scene s = read("cube.json");
        assertEquals(new Cube(p(2.5, 4, 2.5), 3, Vec3.ZERO), s.objects().get(1).shape());
        // The original's order: top, bottom, back (+z), front, left (-x), right.
        List<Material> original = List.of(
                matte(0, 0, 0),
                matte(0, 0, 255),
                matte(0, 255, 255),
                matte(64, 64, 64),
                matte(0, 255, 0),
                matte(255, 175, 175));
        int[] ours = {4, 5, 1, 0, 3, 2};
        for (int face = 0; face < 6; face++) {
            assertEquals(original.get(ours[face]), s.objects().get(1).materialOf(face));
        }
        assertEquals(List.of(new Light.Sphere(p(5, 6, 5), 0.25, DisplayRgb.WHITE)), s.lights());
    }

    @Test
    void theCubesCameraLooksAtTheCubeThroughItsWindow() {
        Camera.Window w = (Camera.Window) read("cube.json").camera();
        Vec3 eye = w.eye().toVec3();
        Vec3 up = w.upperLeft().minus(w.lowerLeft());
        Vec3 right = w.lowerRight().minus(w.lowerLeft());
        Vec3 normal = up.cross(right);
        Vec3 center = new Vec3(2.5, 4, 2.5);
        double toWindow = w.lowerLeft().minus(w.eye()).dot(normal);
        double toCube = center.minus(eye).dot(normal);
        assertTrue(toCube / toWindow > 1, "the window stands between eye and cube");
        Vec3 seenAt = eye.plus(center.minus(eye).times(toWindow / toCube))
                .minus(w.lowerLeft().toVec3());
        double x = seenAt.dot(right) / right.dot(right);
        double y = seenAt.dot(up) / up.dot(up);
        assertTrue(x > 0 && x < 1 && y > 0 && y < 1, "the line of sight passes through the window");
    }

    @Test
    void fireAndIceIsTheSameRoomInBothShadings() {
        Scene classic = read("fire-and-ice.json");
        Scene physical = read("fire-and-ice-physical.json");
        assertEquals(WINDOW, classic.camera());
        assertEquals(window(0), physical.camera());
        assertEquals(classic.textures(), physical.textures());
        for (int i = 0; i < classic.objects().size(); i++) {
            assertEquals(
                    classic.objects().get(i).shape(), physical.objects().get(i).shape());
            Material of = classic.objects().get(i).material();
            assertEquals(of.color(), physical.objects().get(i).material().color());
            assertEquals(of.type(), physical.objects().get(i).material().type());
        }
        Light.Sphere lamp = (Light.Sphere) physical.lights().get(0);
        assertEquals(classic.lights(), List.of(new Light.Sphere(lamp.center(), lamp.radius(), lamp.color())));
    }

    @Test
    void scenesOfPhysicalLightShowWhatTheirNamesSay() {
        for (String name : List.of(
                "cornell-box",
                "caustics",
                "metals",
                "glass-physical",
                "furnace",
                "lamp-room",
                "door-ajar",
                "fluorescent-poster",
                "sky",
                "prism",
                "wax",
                "milk-and-glass",
                "fog",
                "fire-and-ice-physical")) {
            assertEquals(Shading.Model.PHYSICAL, read(name + ".json").shading().model(), name);
        }
        assertEquals(
                Set.of(0.1, 0.3, 0.5, 0.8),
                read("metals.json").materials().values().stream()
                        .filter(m -> m instanceof Glossy)
                        .map(m -> ((Texture.Amount.Constant) ((Glossy) m).roughness()).value())
                        .collect(Collectors.toSet()));
        List<Glass> glass = read("glass-physical.json").materials().values().stream()
                .filter(m -> m instanceof Glass)
                .map(m -> (Glass) m)
                .toList();
        assertTrue(glass.stream().anyMatch(g -> !g.roughness().isZero()));
        assertTrue(glass.stream().anyMatch(g -> g.absorption().max() > 0));
        assertTrue(glass.stream().anyMatch(g -> g.priority() > 0));
        Scene room = read("lamp-room.json");
        assertEquals(
                Set.copyOf(Lights.FAMILY.types()),
                Stream.of(room, read("stage.json"))
                        .flatMap(scene -> scene.lights().stream())
                        .map(Light::type)
                        .collect(Collectors.toSet()));
        assertEquals(
                Set.of("sphere", "disk", "rectangle", "triangle"),
                room.objects().stream()
                        .filter(o -> o.material().radiance().max() > 0)
                        .map(o -> o.shape().type())
                        .collect(Collectors.toSet()));
    }

    @Test
    void pixelsOfTheWindowsAreSquareToHalfAPercent() {
        for (String name : Documents.shippedNames()) {
            Scene s = read(name);
            if (s.camera() instanceof Camera.Window w) {
                double width = w.lowerRight().minus(w.lowerLeft()).length() / s.width();
                double height = w.upperLeft().minus(w.lowerLeft()).length() / s.height();
                assertEquals(1, width / height, 0.005, name);
            }
        }
    }

    @Test
    void primitivesShowsEveryShape() {
        Set<String> types = read("primitives.json").objects().stream()
                .map(o -> o.shape().type())
                .collect(Collectors.toSet());
        assertEquals(Set.copyOf(Shapes.FAMILY.types()), types);
    }

    @Test
    void glassAndTorusShowWhatTheirNamesSay() {
        Set<String> glass = read("glass.json").objects().stream()
                .filter(o -> o.material().type().equals("glass"))
                .map(o -> o.shape().type())
                .collect(Collectors.toSet());
        assertEquals(Set.of("sphere", "cube", "cylinder"), glass);
        long tori = read("torus.json").objects().stream()
                .filter(o -> o.shape().type().equals("torus"))
                .count();
        assertEquals(5, tori);
        assertFalse(read("torus.json").lights().isEmpty());
    }
}
