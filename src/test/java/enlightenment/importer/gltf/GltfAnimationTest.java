package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.geometry.Mesh;
import enlightenment.importer.SceneImporter;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Animation;
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

/** Motions of nodes in glTF files, against closed forms at frames. */
class GltfAnimationTest {
    /** Floats of the file, times a few operations. */
    private static final double CLOSE = 1e-6;

    private static final float ROOT = (float) StrictMath.sqrt(0.5);

    @TempDir
    Path folder;

    private final GltfFile file = new GltfFile();
    private final GltfMotion motion = new GltfMotion(file);

    GltfAnimationTest() {
        file.square("");
    }

    private void move(int node, String path, String interpolation, float[] times, float... values) {
        motion.move(node, path, interpolation, times, values);
    }

    private SceneImporter.Result imported(SceneImporter.Options options) throws IOException {
        return motion.read(folder, options);
    }

    private Scene scene() throws IOException {
        return imported(SceneImporter.Options.DEFAULT.withFramesPerSecond(8)).scene();
    }

    private static Vec3 moved(Scene scene, int frame, double x, double y, double z) {
        Mesh mesh = (Mesh) SceneReader.Frames.of(scene, "moving")
                .read(frame)
                .objects()
                .get(0)
                .shape();
        return mesh.transform().apply(ExactPoint.of(x, y, z)).toVec3();
    }

    private static void assertNear(double x, double y, double z, Vec3 found) {
        assertTrue(found.minus(new Vec3(x, y, z)).length() < CLOSE, () -> "%s %s %s, but %s".formatted(x, y, z, found));
    }

    private static Set<String> targets(Scene scene) {
        Set<String> targets = new TreeSet<>();
        scene.animation().orElseThrow().tracks().forEach(t -> targets.add(t.target()));
        return targets;
    }

    /** A full turn in four keys of 90 degrees: at frame n the point (1, 0, 0) is at n/32 of the circle. */
    @Test
    void aTurningNodeIsAtItsAngle() throws IOException {
        file.add("nodes", "{'mesh':0}");
        move(
                0,
                "rotation",
                "LINEAR",
                new float[] {0, 1, 2, 3, 4},
                0,
                0,
                0,
                1,
                0,
                0,
                ROOT,
                ROOT,
                0,
                0,
                1,
                0,
                0,
                0,
                ROOT,
                -ROOT,
                0,
                0,
                0,
                -1);
        Scene scene = scene();
        assertEquals(32, scene.animation().orElseThrow().frames());
        assertEquals(8, scene.animation().orElseThrow().framesPerSecond());
        for (int frame = 0; frame < 32; frame++) {
            double angle = frame * StrictMath.PI / 16;
            assertNear(StrictMath.cos(angle), StrictMath.sin(angle), 0, moved(scene, frame, 1, 0, 0));
        }
        assertEquals(Set.of("/objects/0/transform/1/angle"), targets(scene));
        Animation.Track track = scene.animation().orElseThrow().tracks().get(0);
        assertEquals(360, track.keys().get(32).doubleValue(), 1e-4);
        assertEquals(5, track.keys().size(), "linear angles need the file's keys only");
    }

    /** About an axis that changes: the closed form of the shorter arc between two quaternions 120 degrees apart. */
    @Test
    void aRotationAboutChangingAxesTakesTheShorterArc() throws IOException {
        file.add("nodes", "{'mesh':0}");
        // From a quarter about x to the negative of a quarter about y, which is the same rotation as the quarter.
        move(0, "rotation", "LINEAR", new float[] {0, 1}, ROOT, 0, 0, ROOT, 0, -ROOT, 0, -ROOT);
        Scene scene = scene();
        for (int frame = 0; frame < 8; frame++) {
            // The quaternions have the dot product 1/2: an arc of 60 degrees.
            double arc = StrictMath.PI / 3;
            double s = frame / 8.0;
            double a = StrictMath.sin((1 - s) * arc) / StrictMath.sin(arc) * StrictMath.sqrt(0.5);
            double b = StrictMath.sin(s * arc) / StrictMath.sin(arc) * StrictMath.sqrt(0.5);
            double w = a + b;
            // The image of z: the third column of the matrix of the quaternion (a, b, 0, w).
            assertNear(2 * b * w, -2 * a * w, 1 - 2 * (a * a + b * b), moved(scene, frame, 0, 0, 1));
        }
        assertEquals(9, targets(scene).size(), "the linear part of a matrix");
    }

    @Test
    void stepsJumpAtTheirKeys() throws IOException {
        file.add("nodes", "{'mesh':0,'translation':[9,9,9]}");
        move(0, "translation", "STEP", new float[] {0.25f, 0.5f, 0.7f}, 1, 2, 3, 4, 2, 3, 5, 2, 3);
        Scene scene = scene();
        double[] x = {1, 1, 1, 1, 4, 4};
        for (int frame = 0; frame < x.length; frame++) {
            assertNear(x[frame], 2, 3, moved(scene, frame, 0, 0, 0));
        }
        assertEquals(6, scene.animation().orElseThrow().frames());
        assertEquals(Set.of("/objects/0/transform/1/translate/0"), targets(scene));
    }

    /** Hermite's form at the middle of a key interval of length d: (v0 + v1)/2 + d (b0 - a1)/8. */
    @Test
    void cubicSplinesFollowTheirTangents() throws IOException {
        file.add("nodes", "{'mesh':0}");
        move(
                0,
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
        Scene scene = scene();
        assertNear((1 + 3) / 2.0 + 2 * (4 + 2) / 8.0, 2.5, 2 * (1 - 3) / 8.0, moved(scene, 8, 0, 0, 0));
        assertNear(1, 0, 0, moved(scene, 0, 0, 0, 0));
        // s = 1/4: h00 = 27/32, h10 = 9/64, h01 = 5/32, h11 = -3/64.
        assertNear(
                27 / 32.0 + 3 * 5 / 32.0 + 2 * (4 * 9 / 64.0 + 2 * 3 / 64.0),
                5 * 5 / 32.0,
                2 * (9 / 64.0 - 3 * 3 / 64.0),
                moved(scene, 4, 0, 0, 0));
    }

    /** The chain of a wheel that turns on a car that moves, within a node that stands, is multiplied out by hand. */
    @Test
    void motionsOfParentsAddUp() throws IOException {
        file.add("nodes", "{'mesh':0,'translation':[0,1,0],'scale':[2,2,2]}");
        file.add("nodes", "{'children':[0],'translation':[0,0,5]}");
        file.add("nodes", "{'children':[1]}");
        file.add("nodes", "{'children':[2],'translation':[100,0,0]}");
        file.with("'scenes':[{'nodes':[3]}]");
        move(0, "rotation", "LINEAR", new float[] {0, 1}, 0, 0, 0, 1, 0, 0, 1, 0);
        move(2, "translation", "LINEAR", new float[] {0, 1}, 0, 0, 0, 8, 0, 0);
        Scene scene = scene();
        for (int frame = 0; frame < 8; frame++) {
            double angle = frame * StrictMath.PI / 8;
            assertNear(
                    100 + frame + 2 * StrictMath.cos(angle),
                    1 + 2 * StrictMath.sin(angle),
                    5,
                    moved(scene, frame, 1, 0, 0));
        }
        assertEquals(2, targets(scene).size());
    }

    @Test
    void aGrowingNodeIsScaledAndOneThatVanishesKeepsItsRest() throws IOException {
        file.add("nodes", "{'mesh':0,'scale':[3,3,3]}");
        move(0, "scale", "LINEAR", new float[] {0, 1}, 1, 1, 1, 5, 9, 1);
        assertNear(2, 3, 0, moved(scene(), 2, 1, 1, 0));
        GltfAnimationTest other = new GltfAnimationTest();
        other.folder = folder;
        other.file.add("nodes", "{'mesh':0,'scale':[3,3,3]}");
        other.move(0, "scale", "LINEAR", new float[] {0, 1}, 1, 1, 1, 0, 0, 0);
        SceneImporter.Result still = other.imported(SceneImporter.Options.DEFAULT);
        assertTrue(
                still.notes().toString().contains("keeps that of its rest"),
                still.notes().toString());
        Mesh mesh = (Mesh) still.scene().objects().get(0).shape();
        assertEquals(new Vec3(3, 0, 0), mesh.transform().applyLinear(Vec3.X));
    }

    /** Between frames, as motion blur sees it, a matrix is off by at most the square of the angle of a frame over 8. */
    @Test
    void matricesBetweenFramesAreWithinTheirBound() {
        double[] a = Quaternions.unit(new double[] {0.1, 0.7, -0.2, 0.6});
        double[] b = Quaternions.unit(new double[] {0.2, 0.6, 0.1, 0.7});
        double angle = 2 * StrictMath.acos(Quaternions.dot(a, b));
        double most = 0;
        for (int i = 0; i <= 64; i++) {
            double s = i / 64.0;
            Vec3 arc = column(Quaternions.slerp(a, b, s));
            Vec3 chord = column(a).times(1 - s).plus(column(b).times(s));
            most = Math.max(most, arc.minus(chord).length());
        }
        assertTrue(most <= angle * angle / 8 && most > 0, most + " of " + angle * angle / 8);
    }

    private static Vec3 column(double[] q) {
        return NodeTree.rotation(q).column(0);
    }

    @Test
    void whatIsLeftOutIsNoted() throws IOException {
        file.add("nodes", "{'mesh':0}");
        move(0, "translation", "LINEAR", new float[] {0, 1}, 0, 0, 0, 1, 0, 0);
        motion.addChannel("{'sampler':0,'target':{'node':0,'path':'weights'}}");
        motion.add("");
        String notes = imported(SceneImporter.Options.DEFAULT).notes().toString();
        assertTrue(notes.contains("morph targets"), notes);
        assertTrue(notes.contains("animations: of 2, the first is taken: 0"), notes);
    }

    private String problem() {
        SceneException e = assertThrows(SceneException.class, () -> imported(SceneImporter.Options.DEFAULT));
        assertEquals(1, e.problems().size());
        assertEquals(1, e.problems().get(0).toString().lines().count());
        return e.problems().get(0).message();
    }

    private GltfAnimationTest fresh() {
        GltfAnimationTest other = new GltfAnimationTest();
        other.folder = folder;
        other.file.add("nodes", "{'mesh':0}");
        return other;
    }

    private String problem(String interpolation, float[] times, float... values) {
        GltfAnimationTest other = fresh();
        other.move(0, "translation", interpolation, times, values);
        return other.problem();
    }

    private static void assertSays(String expected, String said) {
        assertTrue(said.contains(expected), said);
    }

    @Test
    void hostileKeysAreOneLine() throws IOException {
        float[] two = {0, 0, 0, 1, 1, 1};
        assertSays("animations/0/samplers/0: input: times", problem("LINEAR", new float[] {1, 1}, two));
        assertSays("key 1 is at 0.5", problem("LINEAR", new float[] {1, 0.5f}, two));
        assertSays("key 0 is at NaN", problem("LINEAR", new float[] {Float.NaN, 1}, two));
        assertSays("key 1 is at Infinity", problem("LINEAR", new float[] {0, Float.POSITIVE_INFINITY}, two));
        assertSays("key 0 is at -1.0", problem("LINEAR", new float[] {-1, 1}, two));
        assertSays("must be finite", problem("LINEAR", new float[] {0, 1}, 0, 0, 0, 1, Float.NaN, 1));
        assertSays("must have 3 elements, not 2", problem("LINEAR", new float[] {0, 1, 2}, two));
        assertSays("must have 6 elements, not 2", problem("CUBICSPLINE", new float[] {0, 1}, two));
        assertSays("LINEAR, STEP or CUBICSPLINE", problem("BEZIER", new float[] {0, 1}, two));
        assertSays("more than 100000 frames", problem("LINEAR", new float[] {0, 3e38f}, two));
    }

    @Test
    void moreKeysThanTheFileHoldsAreRefusedBeforeTheyTakeMemory() {
        GltfAnimationTest many = fresh();
        int input = many.file.add("accessors", "{'type':'SCALAR','componentType':5126,'count':1000000000}");
        int output = many.file.add("accessors", "{'type':'VEC3','componentType':5126,'count':1000000000}");
        many.motion.move(0, "translation", "LINEAR", input, output);
        assertSays("has 1000000000 elements", many.problem());
        GltfAnimationTest wide = new GltfAnimationTest();
        wide.folder = folder;
        int in = wide.file.floats("SCALAR", 1, 0.01f, 4000);
        int out = wide.file.floats("VEC3", 3, 0, 0, 0, 1, 1, 1);
        for (int node = 0; node < 20; node++) {
            wide.file.add("nodes", "{'mesh':0}");
            wide.motion.move(node, "translation", "LINEAR", in, out);
        }
        assertSays("one key too many", wide.problem());
    }

    @Test
    void channelsOfWhatIsNotThereAreRefused() throws IOException {
        GltfAnimationTest none = fresh();
        none.move(7, "translation", "LINEAR", new float[] {0}, 1, 2, 3);
        assertSays("animations/0/channels/0/target/node: is 7, and there are 1", none.problem());
        GltfAnimationTest matrix = new GltfAnimationTest();
        matrix.folder = folder;
        matrix.file.add("nodes", "{'mesh':0,'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}");
        matrix.move(0, "translation", "LINEAR", new float[] {0}, 1, 2, 3);
        assertSays("moves a node with a matrix", matrix.problem());
    }

    @Test
    void aFilmOfTheFileIsThatOfTheConvertedScene() throws IOException {
        file.add("nodes", "{'mesh':0}");
        move(0, "rotation", "LINEAR", new float[] {0, 1}, 0, 0, 0, 1, 0, ROOT, 0, ROOT);
        imported(SceneImporter.Options.DEFAULT);
        Path glb = folder.resolve("moving.glb");
        Path json = folder.resolve("moving.json");
        CliRun converted = CliRun.of("convert", glb, json, "--fps", "4");
        assertEquals(0, converted.code(), converted.err());
        assertEquals("", converted.err(), "nothing is left out");
        Object[] more = {"--size", "16x12", "--samples", "1"};
        CliRun direct = CliRun.of(
                "animate", glb, "-o", folder.resolve("a-%d.png"), "--fps", "4", more[0], more[1], more[2], more[3]);
        assertEquals(0, direct.code(), direct.err());
        CliRun indirect =
                CliRun.of("animate", json, "-o", folder.resolve("b-%d.png"), more[0], more[1], more[2], more[3]);
        assertEquals(0, indirect.code(), indirect.err());
        for (int frame = 0; frame < 4; frame++) {
            assertEquals(
                    -1,
                    Files.mismatch(folder.resolve("a-" + frame + ".png"), folder.resolve("b-" + frame + ".png")),
                    "frame " + frame);
        }
        assertTrue(Files.mismatch(folder.resolve("a-0.png"), folder.resolve("a-3.png")) >= 0, "it moves");
        assertTrue(Files.notExists(folder.resolve("a-4.png")));
        CliRun none = CliRun.of("render", glb, "-o", folder.resolve("c.png"), "--fps", "4", "--frame", "4");
        assertEquals(2, none.code());
        assertEquals(
                glb + ": /animation: there is no frame 4; the frames are 0..3 (in frame 4)",
                none.err().strip());
    }

    /** Three animations: to 1, 2 and 3 along x. */
    private void addThree() {
        file.add("nodes", "{'mesh':0}");
        for (int n = 1; n <= 3; n++) {
            GltfMotion one = new GltfMotion(file);
            one.move(0, "translation", "LINEAR", new float[] {0, 1}, 0, 0, 0, n, 0, 0);
            one.add(n == 1 ? "" : ",'name':'Walk " + n + "\\u001b'");
        }
    }

    private double end(String animation) throws IOException {
        Path glb = folder.resolve("three.glb");
        Files.write(glb, file.glb());
        SceneImporter.Result imported = SceneImporter.read(
                glb, SceneImporter.Options.DEFAULT.withFramesPerSecond(8).withAnimation(animation));
        assertEquals("[]", imported.notes().toString(), "what was chosen needs no note");
        return 8 * moved(imported.scene(), 1, 0, 0, 0).x();
    }

    @Test
    void anAnimationIsChosenByNumberOrName() throws IOException {
        addThree();
        assertEquals(1, end("0"), CLOSE);
        assertEquals(3, end("2"), CLOSE);
        assertEquals(2, end("Walk 2\u001b"), CLOSE);
    }

    @Test
    void anAnimationThatIsNotThereIsRefusedWithAList() throws IOException {
        addThree();
        Path glb = folder.resolve("three.glb");
        Files.write(glb, file.glb());
        for (String wrong : new String[] {"3", "-1", "Run"}) {
            CliRun run = CliRun.of("animate", glb, "-o", folder.resolve("p-%d.png"), "--animation", wrong);
            assertEquals(2, run.code());
            assertEquals(
                    glb + ": has no animation \"" + wrong + "\"; its animations are 0, 1 \"Walk 2?\", 2 \"Walk 3?\"",
                    run.err().strip());
        }
        Path json = folder.resolve("three.json");
        CliRun without = CliRun.of("convert", glb, json);
        assertEquals(0, without.code());
        assertTrue(without.err().contains("animations: of 3, the first is taken: 0"), without.err());
        CliRun other = CliRun.of("validate", json, "--animation", "1");
        assertEquals(2, other.code());
        assertTrue(other.err().contains("--animation is for files of other programs"), other.err());
    }
}
