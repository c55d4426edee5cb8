package enlightenment.importer.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Disk;
import enlightenment.importer.SceneImporter;
import enlightenment.importer.SceneImporter.Options.Orbit;
import enlightenment.importer.SceneImporter.Options.Up;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TestMeshes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Models without a scene, and the studio that they stand in. */
class ModelReaderTest {
    private static final String TRIANGLES =
            """
            mtllib model.mtl
            v 0 0 0
            v 1 0 0
            v 0 1 0
            usemtl clay
            f 1 2 3
            usemtl shiny
            f 1 2 3
            usemtl window
            f 1 2 3
            usemtl looking
            f 1 2 3
            usemtl veil
            f 1 2 3
            usemtl lamp
            f 1 2 3
            usemtl unknown
            f 1 2 3
            """;

    private static final String MATERIALS =
            """
            newmtl clay
            Kd 0.5 0.25 0.125
            newmtl shiny
            Kd 0.5 0.5 0.5
            Ks 0.2 0.2 0.2
            Ns 198
            illum 2
            newmtl window
            illum 4
            Ni 1.45
            newmtl looking
            Ks 0.75 0.5 0.25
            illum 3
            newmtl veil
            Kd 1 1 1
            d 0.25
            map_Kd ../outside.png
            newmtl lamp
            Ke 3 2 1
            """;

    @TempDir
    private Path folder;

    private Path ply(TriangleMesh mesh) throws IOException {
        Path file = folder.resolve("model.ply");
        try (OutputStream out = Files.newOutputStream(file)) {
            MeshFiles.writePly(mesh, out);
        }
        return file;
    }

    @Test
    void materialsOfAnObjFileBecomeOurs() throws IOException {
        Files.writeString(folder.resolve("model.mtl"), MATERIALS);
        Path file = Files.writeString(folder.resolve("model.obj"), TRIANGLES);
        SceneImporter.Result read = SceneImporter.read(file, SceneImporter.Options.DEFAULT);
        Map<String, Material> by =
                read.scene().objects().stream().collect(Collectors.toMap(SceneObject::name, SceneObject::material));
        assertEquals(Material.Matte.of(Texture.of(new Rgb(0.5, 0.25, 0.125))), by.get("clay"));
        // alpha² = 2 / (198 + 2): alpha is 0.1, the roughness its root.
        Texture.Amount.Constant rough = (Texture.Amount.Constant)
                assertInstanceOf(Coated.class, by.get("shiny")).roughness();
        assertEquals(0.1, rough.value() * rough.value(), 1e-15);
        assertEquals(1.45, assertInstanceOf(Glass.class, by.get("window")).indexOfRefraction());
        assertEquals(Material.Mirror.of(Texture.of(new Rgb(0.75, 0.5, 0.25))), by.get("looking"));
        assertEquals(
                Texture.Amount.of(Texture.of(Rgb.gray(0.25))),
                assertInstanceOf(Composite.Mask.class, by.get("veil")).map());
        assertEquals(new Rgb(3, 2, 1), by.get("lamp").radiance());
        assertTrue(read.notes().stream().anyMatch(n -> n.contains("leads out of the folder")), "" + read.notes());
        assertTrue(read.notes().stream().anyMatch(n -> n.contains("\"unknown\"")), "" + read.notes());
    }

    /** All vertices lie within the picture, at its edges at most, and the ground below them. */
    @Test
    void theStudioShowsAllOfAModelOnItsGround() throws IOException {
        List<UnaryOperator<Vec3>> forms = List.of(v -> v, v -> new Vec3(9 * v.x(), v.y(), 0.1 * v.z()));
        for (UnaryOperator<Vec3> stretch : forms) {
            TriangleMesh mesh = TestMeshes.moved(
                    TestMeshes.icosphere(2), false, v -> stretch.apply(v).plus(new Vec3(100, -7, 3)));
            Scene scene =
                    SceneImporter.read(ply(mesh), SceneImporter.Options.DEFAULT).scene();
            Camera.Perspective camera = (Camera.Perspective) scene.camera();
            assertEquals(Camera.Handedness.RIGHT, camera.handedness());
            Vec3 forward = camera.eye().directionTo(camera.lookAt()).normalized();
            Vec3 right = forward.cross(camera.up()).normalized();
            Vec3 top = right.cross(forward);
            double tangent = StrictMath.tan(StrictMath.toRadians(camera.fieldOfView() / 2));
            double aspect = (double) scene.width() / scene.height();
            double most = 0;
            for (int v = 0; v < mesh.vertices(); v++) {
                Vec3 d = mesh.position(v).minus(camera.eye().toVec3());
                double z = d.dot(forward) * tangent;
                most = Math.max(most, Math.max(Math.abs(d.dot(top)) / z, Math.abs(d.dot(right)) / (z * aspect)));
            }
            assertTrue(most < 1 && most > 0.4, "the outermost vertex is at " + most);
            Disk ground = (Disk) scene.objects().get(1).shape();
            assertEquals(mesh.min().y(), ground.center().toVec3().y());
            assertEquals(Vec3.Y, ground.normal());
        }
    }

    @Test
    void upIsWhatTheOptionsSay() throws IOException {
        SceneImporter.Options z = SceneImporter.Options.DEFAULT.withUp(SceneImporter.Options.Up.Z);
        Scene scene = SceneImporter.read(ply(TestMeshes.icosphere(1)), z).scene();
        assertEquals(Vec3.Z, ((Camera.Perspective) scene.camera()).up());
        assertEquals(Vec3.Z, ((Disk) scene.objects().get(1).shape()).normal());
    }

    /** Units do not count: pictures of a model in metres and in other powers of two of them are the same bytes. */
    @Test
    void theStudioExposesModelsOfAllSizesAlike() throws IOException {
        float[] picture = null;
        for (double factor : new double[] {1, 1024, 1.0 / 1024}) {
            TriangleMesh mesh = TestMeshes.times(TestMeshes.icosphere(1), factor);
            Scene scene =
                    SceneImporter.read(ply(mesh), SceneImporter.Options.DEFAULT).scene();
            RenderSettings small =
                    RenderSettings.of(scene).withSize(24, 18).withBudget(RenderSettings.Budget.NONE.withSamples(8));
            float[] now = Renderer.render(scene, small).toArray();
            if (picture != null) {
                assertArrayEquals(picture, now, "times " + factor);
            }
            picture = now;
        }
    }

    /**
     * The radiance of a white diffuser in the middle of the model, by the sky and a sum over the lamp: facing upwards it is a little less than 1, which
     * is shown as white.
     */
    @Test
    void theStudioShowsWhiteThatFacesUpwardsAsNearlyWhite() throws IOException {
        for (double factor : new double[] {1e-3, 1, 1e3}) {
            TriangleMesh mesh = TestMeshes.times(TestMeshes.icosphere(2), factor);
            Scene scene =
                    SceneImporter.read(ply(mesh), SceneImporter.Options.DEFAULT).scene();
            assertEquals(0, scene.display().exposure());
            Light.Rectangle lamp = (Light.Rectangle) scene.lights().get(0);
            Rgb sky = ((Shading.Background.Constant) background(scene)).radiance();
            double shown = sky.g() + lamp.emission().value().g() * irradianceOfOne(lamp) / StrictMath.PI;
            assertEquals(0.94, shown, 0.01, "times " + factor);
        }
    }

    /** The irradiance, upwards at the origin, of a rectangle of radiance 1. */
    private static double irradianceOfOne(Light.Rectangle lamp) {
        Vec3 corner = lamp.lowerLeft().toVec3();
        Vec3 a = lamp.lowerRight().toVec3().minus(corner);
        Vec3 b = lamp.upperLeft().toVec3().minus(corner);
        Vec3 area = a.cross(b);
        double sum = 0;
        int n = 64;
        for (int i = 0; i < n * n; i++) {
            Vec3 p = corner.plus(a.times((i % n + 0.5) / n)).plus(b.times((i / n + 0.5) / n));
            double square = p.lengthSquared();
            sum += p.y() * Math.abs(p.dot(area)) / (square * square) / (n * n);
        }
        return sum;
    }

    /** The eye is where spherical coordinates say, whichever axis points upwards, and right is on the right. */
    @Test
    void theEyeStandsAtItsAzimuthAndElevation() throws IOException {
        for (Up up : Up.values()) {
            SceneImporter.Options options =
                    SceneImporter.Options.DEFAULT.withUp(up).withOrbit(new Orbit(-120, 30));
            Scene scene =
                    SceneImporter.read(ply(TestMeshes.icosphere(1)), options).scene();
            Camera.Perspective camera = (Camera.Perspective) scene.camera();
            Vec3 away = camera.lookAt().directionTo(camera.eye()).normalized();
            assertEquals(0.5, away.dot(up.axis()), 1e-12);
            assertEquals(-0.75, away.dot(up.right()), 1e-12);
            assertEquals(-StrictMath.sqrt(3) / 4, away.dot(up.front()), 1e-12);
            assertEquals(0, up.front().minus(up.right().cross(up.axis())).length(), "right-handed");
            assertEquals(Camera.Handedness.RIGHT, camera.handedness());
            assertEquals(up.axis(), camera.up());
            Disk ground = (Disk) scene.objects().get(1).shape();
            assertEquals(up.axis(), ground.normal());
            assertEquals(-1, ground.center().toVec3().dot(up.axis()), 1e-12, "below the ball of radius 1");
        }
    }

    @Test
    void aViewFromAboveHasTheFrontBelowAndOneFromBelowHasNoGround() throws IOException {
        SceneImporter.Options above = SceneImporter.Options.DEFAULT.withOrbit(new Orbit(0, 90));
        Camera.Perspective camera = (Camera.Perspective)
                SceneImporter.read(ply(TestMeshes.icosphere(1)), above).scene().camera();
        Vec3 away = camera.lookAt().directionTo(camera.eye()).normalized();
        assertEquals(0, away.minus(Vec3.Y).length(), 1e-15);
        assertEquals(0, camera.up().plus(Vec3.Z).length(), 1e-15, "the front, +z, is at the lower edge");
        SceneImporter.Options below = SceneImporter.Options.DEFAULT.withOrbit(new Orbit(0, -10));
        assertEquals(
                1,
                SceneImporter.read(ply(TestMeshes.icosphere(1)), below)
                        .scene()
                        .objects()
                        .size());
    }

    @Test
    void surroundingsAreWhatTheOptionsSay() throws IOException {
        Path ball = ply(TestMeshes.icosphere(1));
        Rgb blue = new Rgb(0.1, 0.2, 0.9);
        Scene plain = SceneImporter.read(
                        ball,
                        SceneImporter.Options.DEFAULT.withBackdrop(new SceneImporter.Options.Backdrop.Constant(blue)))
                .scene();
        assertEquals(new Shading.Background.Constant(blue), background(plain));
        assertEquals(1, plain.lights().size(), "the lamp");
        assertEquals(1, plain.objects().size(), "no ground");
        Scene sky = SceneImporter.read(
                        ball, SceneImporter.Options.DEFAULT.withBackdrop(new SceneImporter.Options.Backdrop.Sky()))
                .scene();
        assertInstanceOf(Shading.Background.Sky.class, background(sky));
        assertEquals(0, sky.lights().size(), "the sun is its light");
        assertEquals(2, sky.objects().size(), "with a ground");
        assertEquals(
                SceneImporter.read(ball, SceneImporter.Options.DEFAULT),
                SceneImporter.read(
                        ball, SceneImporter.Options.DEFAULT.withBackdrop(new SceneImporter.Options.Backdrop.Studio())));
        SceneImporter.Options tilted =
                SceneImporter.Options.DEFAULT.withUp(Up.X).withBackdrop(new SceneImporter.Options.Backdrop.Sky());
        SceneException e = assertThrows(SceneException.class, () -> SceneImporter.read(ball, tilted));
        assertTrue(e.getMessage().contains("y axis points upwards"), e.getMessage());
    }

    private static Shading.Background background(Scene scene) {
        return ((Shading.Physical) scene.shading()).background();
    }

    @Test
    void aBackgroundTakesThePlaceOfTheFilesAndLeavesItsLamps() throws IOException {
        String text = "<scene version=\"3.0.0\"><emitter type=\"constant\"/>%s<shape type=\"sphere\"/></scene>";
        SceneImporter.Options black =
                SceneImporter.Options.DEFAULT.withBackdrop(new SceneImporter.Options.Backdrop.Constant(Rgb.BLACK));
        Path lamp = Files.writeString(folder.resolve("a.xml"), text.formatted("<emitter type=\"point\"/>"));
        Scene lit = SceneImporter.read(lamp, black).scene();
        assertEquals(Shading.Background.Constant.BLACK, background(lit));
        assertInstanceOf(Light.Point.class, lit.lights().get(0));
        assertEquals(1, lit.lights().size());
        Path none = Files.writeString(folder.resolve("b.xml"), text.formatted(""));
        assertInstanceOf(
                Light.Rectangle.class,
                SceneImporter.read(none, black).scene().lights().get(0),
                "nothing would shine");
    }

    @Test
    void sensorsOfMitsubaAreChosenByNumberOrId() throws IOException {
        String sensor = "<sensor type=\"perspective\" id=\"%s\"><float name=\"fov\" value=\"%d\"/>"
                + "<film type=\"hdrfilm\"><integer name=\"width\" value=\"%d\"/></film></sensor>";
        Path file = Files.writeString(
                folder.resolve("two.xml"),
                "<scene version=\"3.0.0\">" + sensor.formatted("front", 40, 100) + sensor.formatted("side", 50, 200)
                        + "<shape type=\"sphere\"/></scene>");
        for (String name : List.of("1", "side")) {
            assertEquals(
                    200,
                    SceneImporter.read(file, SceneImporter.Options.DEFAULT.withCamera(name))
                            .scene()
                            .width());
        }
        assertEquals(
                100,
                SceneImporter.read(file, SceneImporter.Options.DEFAULT).scene().width());
        SceneException e = assertThrows(
                SceneException.class, () -> SceneImporter.read(file, SceneImporter.Options.DEFAULT.withCamera("2")));
        assertEquals(
                file + ": has no camera \"2\"; its cameras are 0 \"front\", 1 \"side\"",
                e.problems().get(0).toString());
    }

    @Test
    void aFileWhoseLightsAreAllLeftOutIsLitAndSaysSo() throws IOException {
        String text = "<scene version=\"3.0.0\"><emitter type=\"moonlight\"/>%s<shape type=\"sphere\"/></scene>";
        SceneImporter.Result dark = SceneImporter.read(
                Files.writeString(folder.resolve("dark.xml"), text.formatted("")), SceneImporter.Options.DEFAULT);
        assertEquals(1, dark.scene().lights().size());
        assertTrue(dark.notes().stream().anyMatch(n -> n.contains("a soft light stands in")), "" + dark.notes());
        SceneImporter.Result lit = SceneImporter.read(
                Files.writeString(folder.resolve("lit.xml"), text.formatted("<emitter type=\"constant\"/>")),
                SceneImporter.Options.DEFAULT);
        assertEquals(0, lit.scene().lights().size());
        assertTrue(lit.notes().stream().noneMatch(n -> n.contains("a soft light stands in")), "" + lit.notes());
    }

    @Test
    void aBrokenModelIsToldByItsNameInOneLine() throws IOException {
        Path file = Files.writeString(folder.resolve("broken.ply"), "ply\nformat ascii 1.0\nelement vertex 9999\n");
        SceneException e =
                assertThrows(SceneException.class, () -> SceneImporter.read(file, SceneImporter.Options.DEFAULT));
        assertEquals(1, e.problems().size());
        assertTrue(e.problems().get(0).toString().startsWith(file.toString()), e.getMessage());
        assertEquals(1, e.problems().get(0).toString().lines().count());
    }
}
