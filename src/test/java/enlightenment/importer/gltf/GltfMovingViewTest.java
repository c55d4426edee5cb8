package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.cli.CliRun;
import enlightenment.importer.SceneImporter;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Motions of cameras and lights in glTF files, against closed forms at frames. */
class GltfMovingViewTest {
    /** Floats of the file, times a few operations. */
    private static final double CLOSE = 1e-6;

    private static final float ROOT = (float) StrictMath.sqrt(0.5);
    private static final SceneImporter.Options EIGHT = SceneImporter.Options.DEFAULT.withFramesPerSecond(8);
    private static final float[] A_SECOND = {0, 1};

    @TempDir
    Path folder;

    private final GltfFile file = new GltfFile();
    private final GltfMotion motion = new GltfMotion(file);

    GltfMovingViewTest() {
        file.square("");
        file.add("cameras", "{'type':'perspective','perspective':{'yfov':1,'znear':0.1}}");
        file.add("cameras", "{'type':'orthographic','orthographic':{'xmag':2,'ymag':1,'znear':0,'zfar':9}}");
        file.with("'extensions':{'KHR_lights_punctual':{'lights':[{'type':'point'},{'type':'spot','spot':{}},"
                + "{'type':'directional'}]}}");
        file.add("nodes", "{'mesh':0}");
    }

    private static String light(int index) {
        return "'extensions':{'KHR_lights_punctual':{'light':" + index + "}}";
    }

    private Scene scene() throws IOException {
        SceneImporter.Result imported = motion.read(folder, EIGHT);
        assertEquals("[]", imported.notes().toString());
        return imported.scene();
    }

    private static void assertNear(double x, double y, double z, Vec3 found) {
        assertTrue(found.minus(new Vec3(x, y, z)).length() < CLOSE, () -> "%s %s %s, but %s".formatted(x, y, z, found));
    }

    private static Set<String> targets(Scene scene) {
        Set<String> targets = new TreeSet<>();
        scene.animation().orElseThrow().tracks().forEach(t -> targets.add(t.target()));
        return targets;
    }

    private static Camera.Perspective camera(SceneReader.Frames frames, int frame) {
        return (Camera.Perspective) frames.read(frame).camera();
    }

    private static Vec3 view(Camera.Perspective camera) {
        return camera.eye().directionTo(camera.lookAt()).normalized();
    }

    /** Along a straight line the keys of the file are enough. */
    @Test
    void aCameraOnRailsHasTheKeysOfTheFile() throws IOException {
        file.add("nodes", "{'camera':0,'translation':[9,9,9]}");
        motion.move(1, "translation", "LINEAR", new float[] {0.5f, 1, 2}, 0, 1, 5, 4, 1, 5, 0, 1, 9);
        Scene scene = scene();
        SceneReader.Frames frames = SceneReader.Frames.of(scene, "rails");
        double[] x = {0, 0, 0, 0, 0, 1, 2, 3, 4, 3.5, 3, 2.5};
        for (int n = 0; n < x.length; n++) {
            Camera.Perspective camera = camera(frames, n);
            double z = Math.max(5, 5 + (n - 8) / 2.0);
            assertNear(x[n], 1, z, camera.eye().toVec3());
            assertNear(0, 0, -1, view(camera));
        }
        assertEquals(16, scene.animation().orElseThrow().frames());
        assertEquals(Set.of("/camera/eye/0", "/camera/eye/2", "/camera/lookAt/0", "/camera/lookAt/2"), targets(scene));
        assertEquals(
                "[4, 8, 16]",
                scene.animation().orElseThrow().tracks().get(0).keys().keySet().toString());
    }

    /** A camera on an arm of length 2 that turns about y looks along the arm's tangent. */
    @Test
    void aCameraOnATurningArmLooksWithIt() throws IOException {
        file.add("nodes", "{'children':[2],'translation':[0,1,0]}");
        file.add("nodes", "{'camera':0,'translation':[2,0,0]}");
        motion.move(1, "rotation", "LINEAR", A_SECOND, 0, 0, 0, 1, 0, 1, 0, 0);
        motion.move(1, "translation", "LINEAR", A_SECOND, 0, 1, 0, 0, 9, 0);
        SceneReader.Frames frames = SceneReader.Frames.of(scene(), "arm");
        for (int n = 0; n < 8; n++) {
            double a = n * StrictMath.PI / 8;
            Camera.Perspective camera = camera(frames, n);
            assertNear(
                    2 * StrictMath.cos(a),
                    1 + n,
                    -2 * StrictMath.sin(a),
                    camera.eye().toVec3());
            assertNear(-StrictMath.sin(a), 0, -StrictMath.cos(a), view(camera));
            assertNear(0, 1, 0, camera.up());
        }
    }

    @Test
    void aCameraThatRollsTurnsItsUp() throws IOException {
        file.add("nodes", "{'camera':0,'translation':[0,0,5]}");
        motion.move(1, "rotation", "LINEAR", A_SECOND, 0, 0, 0, 1, 0, 0, 1, 0);
        Scene scene = scene();
        SceneReader.Frames frames = SceneReader.Frames.of(scene, "roll");
        for (int n = 0; n < 8; n++) {
            double a = n * StrictMath.PI / 8;
            assertNear(
                    -StrictMath.sin(a), StrictMath.cos(a), 0, camera(frames, n).up());
            assertNear(0, 0, -1, view(camera(frames, n)));
        }
        assertEquals(Set.of("/camera/up/0", "/camera/up/1"), targets(scene));
    }

    @Test
    void aParallelViewGrowsWithItsNode() throws IOException {
        file.add("nodes", "{'camera':1,'translation':[0,0,5]}");
        motion.move(1, "scale", "LINEAR", A_SECOND, 1, 1, 1, 3, 3, 3);
        SceneImporter.Result imported = motion.read(folder, EIGHT.withCamera("1"));
        SceneReader.Frames frames = SceneReader.Frames.of(imported.scene(), "zoom");
        for (int n = 0; n < 8; n++) {
            Camera.Orthographic camera = (Camera.Orthographic) frames.read(n).camera();
            assertEquals(2 * (1 + n / 4.0), camera.height(), CLOSE);
        }
    }

    /** Hermite's form, as of objects, by a parent; and a step beside it. */
    @Test
    void lightsFollowSplinesAndSteps() throws IOException {
        file.add("nodes", "{'children':[2],'translation':[0,0,1]}");
        file.add("nodes", "{" + light(0) + ",'translation':[0,1,0]}");
        file.add("nodes", "{" + light(0) + "}");
        motion.move(
                1,
                "translation",
                "CUBICSPLINE",
                new float[] {0, 2},
                7,
                7,
                7,
                1,
                0,
                0,
                4,
                0,
                1,
                -2,
                0,
                3,
                3,
                5,
                0,
                7,
                7,
                7);
        motion.move(3, "translation", "STEP", new float[] {0, 0.7f}, 1, 2, 3, 4, 5, 6);
        SceneReader.Frames frames = SceneReader.Frames.of(scene(), "lamps");
        Light.Point spline = (Light.Point) frames.read(8).lights().get(0);
        assertNear(
                (1 + 3) / 2.0 + 2 * (4 + 2) / 8.0,
                1 + 2.5,
                2 * (1 - 3) / 8.0,
                spline.position().toVec3());
        for (int n = 0; n < 16; n++) {
            Light.Point step = (Light.Point) frames.read(n).lights().get(1);
            int jump = n < 6 ? 0 : 3;
            assertNear(1 + jump, 2 + jump, 3 + jump, step.position().toVec3());
        }
    }

    @Test
    void spotsAndSunsTurn() throws IOException {
        file.add("nodes", "{" + light(1) + ",'translation':[3,0,0]}");
        file.add("nodes", "{" + light(2) + "}");
        for (int node = 1; node <= 2; node++) {
            motion.move(node, "rotation", "LINEAR", A_SECOND, 0, 0, 0, 1, 0, ROOT, 0, ROOT);
        }
        Scene scene = scene();
        SceneReader.Frames frames = SceneReader.Frames.of(scene, "sun");
        for (int n = 0; n < 8; n++) {
            double a = n * StrictMath.PI / 16;
            Light.Spot spot = (Light.Spot) frames.read(n).lights().get(0);
            Light.Distant sun = (Light.Distant) frames.read(n).lights().get(1);
            assertNear(3, 0, 0, spot.position().toVec3());
            assertNear(-StrictMath.sin(a), 0, -StrictMath.cos(a), spot.direction());
            assertNear(-StrictMath.sin(a), 0, -StrictMath.cos(a), sun.direction());
        }
        assertEquals(4, targets(scene).size(), "x and z of each direction");
    }

    /** A scale of 0, as exporters hide nodes by, is left out of what nodes carry, as for their meshes. */
    @Test
    void aScaleThatVanishesDoesNotPullALightIn() throws IOException {
        file.add("nodes", "{'children':[2]}");
        file.add("nodes", "{" + light(1) + ",'translation':[3,0,0]}");
        motion.move(1, "scale", "STEP", A_SECOND, 0, 0, 0, 1, 1, 1);
        SceneImporter.Result imported = motion.read(folder, EIGHT);
        assertTrue(imported.notes().toString().contains("keeps that of its rest"), imported.notes()::toString);
        Light.Spot spot = (Light.Spot) imported.scene().lights().get(0);
        assertNear(3, 0, 0, spot.position().toVec3());
        assertNear(0, 0, -1, spot.direction());
    }

    @Test
    void aViewFromOutsideStandsStill() throws IOException {
        file.add("nodes", "{'camera':0,'translation':[0,0,5]}");
        motion.move(1, "translation", "LINEAR", A_SECOND, 0, 0, 5, 0, 0, 9);
        SceneImporter.Result imported = motion.read(folder, EIGHT.withOrbit(SceneImporter.Options.Orbit.USUAL));
        assertTrue(imported.scene().animation().isEmpty());
    }

    /** Twelve nodes of scale 3e38, one in the other. */
    @Test
    void posesBeyondAllNumbersAreRefused() {
        for (int n = 1; n < 12; n++) {
            file.add("nodes", "{'children':[" + (n + 1) + "],'scale':[3e38,3e38,3e38]}");
        }
        file.add("nodes", "{" + light(0) + ",'translation':[3,0,0]}");
        motion.move(12, "translation", "LINEAR", A_SECOND, 1, 0, 0, 2, 0, 0);
        SceneException e = assertThrows(SceneException.class, () -> motion.read(folder, EIGHT));
        assertEquals("nodes/12: moves beyond all numbers", e.problems().get(0).message());
    }

    @Test
    void aFilmOfTheFileIsThatOfTheConvertedScene() throws IOException {
        file.add("nodes", "{'camera':0,'translation':[0.5,0.5,3]}");
        file.add("nodes", "{" + light(1) + ",'translation':[0.5,0.5,3]}");
        motion.move(
                1,
                "rotation",
                "CUBICSPLINE",
                A_SECOND,
                0,
                0,
                0,
                0,
                0,
                0,
                0,
                1,
                0,
                0.2f,
                0.3f,
                0,
                0,
                0,
                0,
                0,
                0,
                0,
                ROOT,
                ROOT,
                0,
                0,
                0,
                0);
        motion.move(2, "translation", "STEP", new float[] {0, 0.5f}, 0.5f, 0.5f, 3, 0.5f, 0.5f, 1);
        Path glb = folder.resolve("moving.glb");
        motion.read(folder, EIGHT);
        Path json = folder.resolve("moving.json");
        CliRun converted = CliRun.of("convert", glb, json, "--fps", "4", "--strict");
        assertEquals(0, converted.code(), converted.err());
        CliRun direct = CliRun.of(
                "animate", glb, "-o", folder.resolve("a-%d.png"), "--fps", "4", "--size", "16x12", "--samples", "1");
        assertEquals(0, direct.code(), direct.err());
        CliRun indirect =
                CliRun.of("animate", json, "-o", folder.resolve("b-%d.png"), "--size", "16x12", "--samples", "1");
        assertEquals(0, indirect.code(), indirect.err());
        for (int frame = 0; frame < 4; frame++) {
            Path a = folder.resolve("a-" + frame + ".png");
            assertEquals(-1, Files.mismatch(a, folder.resolve("b-" + frame + ".png")), "frame " + frame);
            assertTrue(frame == 0 || Files.mismatch(a, folder.resolve("a-0.png")) >= 0, "frame " + frame);
        }
    }
}
