package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayCurve;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Animation;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.Problems;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SceneReaderTest {
    @TempDir
    Path folder;

    private static ExactPoint p(double x, double y, double z) {
        return ExactPoint.of(x, y, z);
    }

    private static Texture plain(int r, int g, int b) {
        return Texture.of(DisplayRgb.ofBytes(r, g, b));
    }

    @Test
    void everyKeyOfEveryTypeArrivesWhereItBelongs() throws IOException {
        Scene s = Documents.read(Documents.EVERYTHING, Documents.withImage(folder));
        Texture ice = new Texture.File(folder.resolve("ice.png"), Texture.Filter.NEAREST, Texture.Encoding.LINEAR);
        Texture checks = new Texture.Checker(List.of(DisplayRgb.WHITE, DisplayRgb.of(0, 0.5, 1)), 8);
        assertEquals(Map.of("ice", ice, "checks", checks, "plain", plain(0, 0, 255)), s.textures());
        Material matte = new Material.Matte(ice, false);
        Material chrome = new Material.Mirror(Texture.of(DisplayRgb.of(0.1, 0.2, 0.3)), true, Rgb.gray(0.5));
        Material glass = new Glass(plain(254, 254, 254), 1.5, 0.875, -2, true)
                .withRoughness(new Texture.Amount.Textured(checks, Texture.Amount.Channel.RED, 0.25))
                .withAbsorption(new Rgb(0.5, 0, 2))
                .withMultipleScattering(false)
                .withDispersion(36.5);
        Material lens = Glass.of(plain(254, 254, 254), 1.8125).withSmoothRefraction(true);
        Material ember = new Material.Matte(
                Texture.of(new Rgb(0.25, 0.5, 1)),
                true,
                0.625,
                new Rgb(4, 2, 0),
                2.5,
                new Material.EmissionPattern(Optional.of(checks), Material.EmissionPattern.Side.FRONT));
        Material copper = new Glossy(
                plain(255, 238, 255),
                0.375,
                Optional.of(new Glossy.Conductor(new Rgb(0.2, 0.92, 1.1), new Rgb(3.91, 2.45, 2.14))),
                false,
                Rgb.gray(1.5),
                0.25);
        Material varnish = new Coated(plain(128, 64, 32), 0.6875, 1.75, true, Rgb.gray(0.375), 0.125);
        Material enamel = new Principled(
                plain(17, 33, 49),
                new Texture.Amount.Textured(ice, Texture.Amount.Channel.BLUE, 1),
                new Texture.Amount.Textured(checks, Texture.Amount.Channel.MEAN, 0.75),
                1.625,
                0.5,
                new Principled.Clearcoat(0.25, new Texture.Amount.Textured(ice, Texture.Amount.Channel.GREEN, 0.125)),
                new Principled.Sheen(0.4375, 0.3125),
                Rgb.gray(0.0625),
                3);
        Material wax = new Material.Scattering(
                new Medium.Colored(DisplayRgb.ofBytes(0xf0, 0xe0, 0xc0), new Rgb(0.3, 0.2, 0.1), 0.375),
                1.44,
                0.125,
                3);
        Material milk = Material.Scattering.of(Medium.Coefficients.of(new Rgb(6, 5, 4), Rgb.gray(0.125)));
        Material marker = new Material.Fluorescent(
                Texture.of(DisplayRgb.of(0.5, 0.25, 0)),
                new Material.WavelengthBand(320, 450),
                new Material.WavelengthBand(500, 600.5),
                0.875,
                Rgb.gray(0.5),
                0.75);
        Material leaf = new Composite.Mask(Material.Matte.of(plain(0x30, 0x60, 0x20)), ice);
        Material grey = Material.Matte.of(plain(192, 192, 192));
        Material rust = new Composite.Mix(leaf, grey, Texture.of(Rgb.gray(0.5625)));
        Material grooves = new Composite.NormalMap(rust, plain(0, 0, 255));
        Material hammered = new Composite.Bump(grooves, ice, -0.0625);
        Map<String, Material> materials = new HashMap<>(Map.of(
                "ice", matte, "chrome", chrome, "glass", glass, "lens", lens, "ember", ember, "copper", copper,
                "varnish", varnish, "wax", wax, "milk", milk, "marker", marker));
        materials.putAll(
                Map.of("enamel", enamel, "leaf", leaf, "rust", rust, "grooves", grooves, "hammered", hammered));
        assertEquals(materials, s.materials());
        assertEquals(new Scene.Display(-0.5, DisplayCurve.Tone.FILMIC), s.display());
        assertEquals(new Camera.Window(p(0, 1, -3), p(-3, 0, 0), p(-3, 3, 0), p(3, 3, 0), p(3, 0, 0), 0.5), s.camera());
        assertEquals(new Shading.Classic(0.25, 0.75, DisplayRgb.ofBytes(16, 32, 48), 7), s.shading());
        ChosenSettings chosen =
                ChosenSettings.of(new BuiltInMethod.RayTraceSettings(7)).with(ChosenSettings.Common.SEED, 99);
        assertEquals(new RenderSettings.Defaults(Method.CLUSTER, 3, chosen), s.render());
        assertEquals(
                List.of(
                        new Light.Sphere(
                                p(0, 1, 1),
                                0.15,
                                DisplayRgb.WHITE,
                                Emission.radiance(new Rgb(200, 150, 100)).withUltraviolet(7)),
                        new Light.Rectangle(
                                p(0, 9, 0),
                                p(0, 9, 1),
                                p(1, 9, 1),
                                p(1, 9, 0),
                                DisplayRgb.ofBytes(255, 255, 238),
                                false,
                                Emission.power(Rgb.gray(40))),
                        new Light.Point(p(0, 5, 5), DisplayRgb.WHITE, Emission.intensity(Rgb.gray(3)))),
                s.lights());
        Material tiles = Material.Matte.of(checks);
        Material ink = Material.Matte.of(plain(1, 2, 3));
        Path file = folder.resolve("gem.obj");
        assertEquals(
                List.of(
                        object("ball", new Sphere(ExactPoint.of("-2", "1.1", "4"), 1.5, 200), matte),
                        object("wall", new Rectangle(p(-6, -6, 8), p(-6, 6, 8), p(6, 6, 8), p(6, -6, 8)), chrome),
                        object("dish", new Disk(p(0, 0, 5), new Vec3(0, 2, 0), 2.5), glass),
                        object("rod", new Cylinder(p(1, 0, 0), p(1, 2, 0), 0.3, false), tiles),
                        object("hat", new Cone(p(2, 0, 0), p(2, 3, 0), 0.7, 0.1, false), matte),
                        new SceneObject(
                                "die",
                                new Cube(p(3, 0, 3), 1.25, new Vec3(10, 20, 30)),
                                matte,
                                List.of(matte, matte, chrome, chrome, glass, ink)),
                        object("brick", new Box(p(0, 0, 7), p(1, 2, 8)), matte),
                        object("ring", new Torus(p(0, 4, 4), Vec3.Z, 1.75, 0.35), chrome),
                        object("sail", new Triangle(p(0, 0, 9), p(1, 0, 9), p(0, 1, 9)), matte),
                        object(
                                "gem",
                                gem(
                                        new MeshFiles.Origin(file, "upper", MeshFiles.Origin.Normals.SMOOTH, 40),
                                        new Transform.Scale(new Vec3(0.5, 0.5, 0.5)),
                                        new Transform.Rotate(new Vec3(0, 45, 0)),
                                        new Transform.Translate(ExactPoint.of("0.1", "2", "3"))),
                                glass),
                        object(
                                "stone",
                                gem(
                                        new MeshFiles.Origin(file, "lower", MeshFiles.Origin.Normals.SMOOTH, 30),
                                        new Transform.Scale(new Vec3(1, 2, 3)),
                                        new Transform.RotateAbout(new Vec3(0, 1, 1), 30),
                                        new Transform.Matrix(
                                                Vec3.X, new Vec3(0, 0, -1), Vec3.Y, ExactPoint.of("5.5", "0.1", "7"))),
                                matte),
                        object("", new Sphere(ExactPoint.of("4", "0.1", "9"), 0.5, 0), matte),
                        object(
                                "",
                                gem(
                                        new MeshFiles.Origin(file, "upper", MeshFiles.Origin.Normals.SMOOTH, 40),
                                        new Transform.Translate(p(1, 0, 0)),
                                        new Transform.Translate(ExactPoint.of("4", "0.1", "9"))),
                                chrome)),
                s.objects());
        TreeMap<Integer, BigDecimal> keys = new TreeMap<>(Map.of(0, BigDecimal.ONE, 10, BigDecimal.valueOf(2)));
        assertEquals(
                Optional.of(new Animation(11, 25, List.of(new Animation.Track("/objects/0/center/1", keys)))),
                s.animation());
        assertEquals("everything", s.name());
        assertEquals(40, s.width());
        assertEquals(20, s.height());
    }

    private static Mesh gem(MeshFiles.Origin origin, Transform.Step... steps) throws IOException {
        TriangleMesh triangles = origin.of(MeshFiles.read(origin.file(), MeshFiles.MAX_TRIANGLES));
        return new Mesh(triangles, Optional.of(origin), Transform.of(steps));
    }

    private static SceneObject object(String name, enlightenment.geometry.Shape shape, Material material) {
        return new SceneObject(name, shape, material, List.of());
    }

    @Test
    void whatIsNotSaidHasItsDefault() {
        Scene s = Documents.read(
                Documents.withObjects("{\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1,"
                        + " \"material\": {\"type\": \"glass\", \"color\": \"#FFFFFF\", \"indexOfRefraction\": 1.5}},"
                        + "{\"type\": \"cone\", \"base\": [0, 0, 0], \"apex\": [0, 1, 0], \"radius\": 1,"
                        + " \"material\": {\"type\": \"matte\", \"color\": [0, 0, 0]}}"),
                folder);
        assertEquals("", s.name());
        assertEquals(Shading.Classic.DEFAULT, s.shading());
        assertEquals(Scene.Display.DEFAULT, s.display());
        assertEquals(RenderSettings.Defaults.DEFAULT, s.render());
        assertEquals(List.of(), s.lights());
        assertEquals(Optional.empty(), s.animation());
        assertEquals(
                SceneObject.of(Sphere.of(ExactPoint.ORIGIN, 1), Glass.of(Texture.of(DisplayRgb.WHITE), 1.5)),
                s.objects().get(0));
        assertEquals(
                new Cone(ExactPoint.ORIGIN, p(0, 1, 0), 1, 0, true),
                s.objects().get(1).shape());
    }

    @Test
    void theOtherCamerasAreRead() {
        String window = Documents.EVERYTHING.substring(
                Documents.EVERYTHING.indexOf("{ \"type\": \"window\""),
                Documents.EVERYTHING.indexOf(",\n  \"shading\""));
        Documents.withImage(folder);
        assertEquals(
                new Camera.Perspective(p(0, 1, 2), p(3, 4, 5), Vec3.Y, 40),
                Documents.read(
                                Documents.edited(
                                        window,
                                        "{\"type\": \"perspective\", \"eye\": [0,1,2], \"lookAt\": [3,4,5],"
                                                + " \"fieldOfView\": 40}"),
                                folder)
                        .camera());
        assertEquals(
                new Camera.Orthographic(p(0, 1, 2), p(3, 4, 5), Vec3.X, 40),
                Documents.read(
                                Documents.edited(
                                        window,
                                        "{\"type\": \"orthographic\", \"eye\": [0,1,2], \"lookAt\": [3,4,5],"
                                                + " \"up\": [1,0,0], \"height\": 40}"),
                                folder)
                        .camera());
        assertEquals(
                new Camera.Panorama(p(0, 1, 2), p(3, 4, 5), Vec3.Y, 0.25, Camera.Handedness.RIGHT),
                Documents.read(
                                Documents.edited(
                                        window,
                                        "{\"type\": \"panorama\", \"eye\": [0,1,2], \"lookAt\": [3,4,5],"
                                                + " \"eyeSeparation\": 0.25, \"handedness\": \"right\"}"),
                                folder)
                        .camera());
        assertEquals(
                new Camera.Isometric(p(3, 4, 5), 40),
                Documents.read(
                                Documents.edited(
                                        window, "{\"type\": \"isometric\", \"lookAt\": [3,4,5], \"height\": 40}"),
                                folder)
                        .camera());
    }

    private static Scene withLens(String lens, OptionalInt frame) {
        String scene =
                """
                {
                  "image": { "width": 4, "height": 2 },
                  "camera": {
                    "type": "perspective", "eye": [0, 1, 2], "lookAt": [3, 4, 5], "fieldOfView": 40,
                    "fieldOfViewAxis": "larger", "lens": LENS
                  },
                  "shading": { "model": "physical" },
                  "objects": [],
                  "animation": {
                    "frames": 11, "framesPerSecond": 10,
                    "tracks": [{ "target": "/camera/lens/focusDistance", "keys": { "0": 4, "10": 8 } }]
                  }
                }
                """
                        .replace("LENS", lens);
        return SceneReader.readBytes(scene.getBytes(StandardCharsets.UTF_8), Path.of(""), "lens.json", frame);
    }

    @Test
    void aLensIsReadAndItsFocusCanBeMovedByATrack() {
        String lens = "{ \"radius\": 0.5, \"focusDistance\": 4, \"blades\": 6, \"rotation\": 15 }";
        Camera.Perspective expected = new Camera.Perspective(p(0, 1, 2), p(3, 4, 5), Vec3.Y, 40)
                .withAxis(Camera.FieldOfViewAxis.LARGER)
                .withLens(new Camera.Lens(0.5, 4, 6, 15));
        assertEquals(expected, withLens(lens, OptionalInt.empty()).camera());
        assertEquals(
                expected.withLens(new Camera.Lens(0.5, 6, 6, 15)),
                withLens(lens, OptionalInt.of(5)).camera());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "{ 'radius': -1, 'focusDistance': 4 }; /camera/lens/radius; at least 0",
                "{ 'radius': 1, 'focusDistance': 0 }; /camera/lens/focusDistance; greater than 0",
                "{ 'radius': 4001, 'focusDistance': 4 }; /camera/lens/radius; at most 1000 times",
                "{ 'radius': 1, 'focusDistance': 4, 'blades': 2 }; /camera/lens/blades; from 3 to 100",
                "{ 'radius': 1, 'focusDistance': 4, 'blades': 101 }; /camera/lens/blades; not 101",
                "{ 'radius': 1, 'focusDistance': 4, 'aperture': 2 }; /camera/lens/aperture; radius",
                "{ 'radius': 1 }; /camera/lens/focusDistance; missing",
                "7; /camera/lens; object"
            },
            quoteCharacter = '"')
    void aLensThatIsNoneIsRefusedAtItsPlace(String lens, String place, String problem) {
        String message = assertThrows(
                        SceneException.class, () -> withLens(lens.replace('\'', '"'), OptionalInt.empty()))
                .getMessage();
        assertTrue(message.contains(place), message);
        assertTrue(message.contains(problem), message);
    }

    @Test
    void aCubeWithFacesNeedsNoMaterialOfItsOwn() {
        Documents.withImage(folder);
        Scene s = Documents.read(
                Documents.edited("\"color\": \"#010203\" }], \"material\": \"ice\"", "\"color\": \"#010203\" }]"),
                folder);
        SceneObject die = s.objects().get(5);
        assertEquals(die.faces().get(0), die.material());
    }

    @Test
    void coordinatesAreExactAndOtherNumbersTheNearestDouble() {
        Scene s = Documents.read(
                Documents.withObjects("{\"type\": \"sphere\", \"center\": [1000000000000000.00000000001, 1e-300, 5],"
                        + " \"radius\": 0.1000000000000000055511151231257827021181583404541015625,"
                        + " \"material\": {\"type\": \"matte\", \"color\": \"#000000\"}}"),
                folder);
        Sphere sphere = (Sphere) s.objects().get(0).shape();
        assertEquals(
                new BigDecimal("1000000000000000.00000000001"), sphere.center().x());
        assertEquals(0, new BigDecimal("1e-300").compareTo(sphere.center().y()));
        assertEquals(0.1, sphere.radius());
    }

    @Test
    void commentsAndAByteOrderMarkAreSkipped() throws IOException {
        Path file = folder.resolve("scene.json");
        String json = "\ufeff// a comment\n" + Documents.withObjects(" /* no\n objects */ ");
        Files.writeString(file, json);
        assertEquals(List.of(), SceneReader.read(file).objects());
    }

    @Test
    void framesBetweenKeysAreExact() throws IOException {
        Documents.withImage(folder);
        Path file = folder.resolve("scene.json");
        Files.writeString(
                file,
                Documents.edited(
                        "\"keys\": { \"0\": 1, \"10\": 2 } }",
                        "\"keys\": { \"2\": 1, \"5\": 1.1, \"9\": 1e-300 } },"
                                + "{ \"target\": \"/materials/chrome/color/2\", \"keys\": { \"0\": 0, \"10\": 1 } },"
                                + "{ \"target\": \"/image/width\", \"keys\": { \"0\": 10, \"10\": 30 } }"));
        String[] y = {
            "1",
            "1",
            "1",
            // 1 + 1/30 and 1 + 2/30, cut
            "1.0" + "3".repeat(Tracks.DECIMALS - 1),
            "1.0" + "6".repeat(Tracks.DECIMALS - 1),
            "1.1"
        };
        for (int frame = 0; frame < y.length; frame++) {
            Scene s = SceneReader.read(file, frame);
            assertEquals(
                    new BigDecimal(y[frame]),
                    ((Sphere) s.objects().get(0).shape()).center().y());
            Texture.Solid color = (Texture.Solid) s.materials().get("chrome").color();
            assertEquals(frame / 10.0, color.color().display().b());
            assertEquals(10 + 2 * frame, s.width());
        }
        assertEquals(40, SceneReader.read(file).width());
        assertEquals(
                0,
                new BigDecimal("1e-300")
                        .compareTo(((Sphere) SceneReader.read(file, 10)
                                        .objects()
                                        .get(0)
                                        .shape())
                                .center()
                                .y()));
    }

    @Test
    void aFrameThatIsNotThereIsRefused() throws IOException {
        Documents.withImage(folder);
        Path animated = folder.resolve("animated.json");
        Files.writeString(animated, Documents.EVERYTHING);
        for (int frame : new int[] {-1, 11, Integer.MAX_VALUE}) {
            Problem problem = onlyProblem(() -> SceneReader.read(animated, frame));
            assertEquals("/animation", problem.pointer());
            assertTrue(problem.message().contains("the frames are 0..10"), problem.message());
        }
        Path still = folder.resolve("still.json");
        Files.writeString(still, Documents.withObjects(""));
        assertTrue(onlyProblem(() -> SceneReader.read(still, 0)).message().contains("no animation"));
    }

    @Test
    void aFrameThatCannotBeIsRefusedAndNamed() throws IOException {
        Documents.withImage(folder);
        Path file = folder.resolve("scene.json");
        Files.writeString(
                file,
                Documents.edited(
                        "/objects/0/center/1\", \"keys\": { \"0\": 1,", "/objects/0/radius\", \"keys\": { \"0\": -2,"));
        Problem problem = onlyProblem(() -> SceneReader.read(file, 3));
        assertEquals("/objects/0/radius", problem.pointer());
        assertTrue(problem.message().contains("-0.8"), problem.message());
        assertTrue(problem.message().contains("in frame 3"), problem.message());
        SceneReader.read(file, 6);
    }

    @Test
    void filesThatAreNoSceneFilesAreRefused() throws IOException {
        Path missing = folder.resolve("missing.json");
        assertTrue(onlyProblem(() -> SceneReader.read(missing)).message().contains("no such file"));
        assertEquals(
                missing.toString(), onlyProblem(() -> SceneReader.read(missing)).file());
        assertTrue(onlyProblem(() -> SceneReader.read(folder)).message().contains("is a folder"));
        Path empty = Files.writeString(folder.resolve("empty.json"), " // nothing\n");
        assertTrue(onlyProblem(() -> SceneReader.read(empty)).message().contains("is empty"));
        Path latin =
                Files.write(folder.resolve("latin.json"), "{\"name\": \"Bär\"}".getBytes(StandardCharsets.ISO_8859_1));
        assertTrue(onlyProblem(() -> SceneReader.read(latin)).message().contains("UTF-8"));
        Path image = Files.write(folder.resolve("image.json"), Documents.PNG_START);
        assertTrue(onlyProblem(() -> SceneReader.read(image)).message().contains("UTF-8"));
    }

    private static Problem onlyProblem(org.junit.jupiter.api.function.Executable reading) {
        List<Problem> problems = assertThrows(SceneException.class, reading).problems();
        assertEquals(1, problems.size(), () -> problems.toString());
        return problems.get(0);
    }

    @Test
    void pathsAreRelativeToTheSceneFile() throws IOException {
        Path sub = Files.createDirectories(folder.resolve("a/b"));
        Files.createDirectories(folder.resolve("images"));
        Files.write(folder.resolve("images/photo.jpg"), new byte[] {(byte) 0xff, (byte) 0xd8, (byte) 0xff, 0});
        Path file = Documents.withImage(sub).resolve("scene.json");
        Files.writeString(file, Documents.edited("\"ice.png\"", "\"../../images/photo.jpg\""));
        Texture.File texture = (Texture.File) SceneReader.read(file).textures().get("ice");
        assertEquals(folder.resolve("images/photo.jpg"), texture.file());
    }

    @Test
    void aMillionDigitsCostNothing() {
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (String number : List.of("1e1000000000", "-1e-999999999", "0.1e2000000000")) {
            long before = thread.getCurrentThreadAllocatedBytes();
            Problem problem = Documents.problem(Documents.edited("1.25", number), Documents.withImage(folder));
            long bytes = thread.getCurrentThreadAllocatedBytes() - before;
            assertEquals("/objects/5/radius", problem.pointer());
            assertTrue(problem.message().contains(number), problem.message());
            // Written out, the number would take 400 million bytes in binary.
            assertTrue(bytes < 20_000_000, bytes + " bytes for " + number);
        }
    }

    /** No time is asserted: what is quadratic in the objects would take hours, and the limit of the whole suite ends it. */
    @Test
    void aHundredThousandObjectsAreRead() {
        int count = 100_000;
        StringBuilder objects = new StringBuilder();
        for (int i = 0; i < count; i++) {
            objects.append(i > 0 ? ",\n" : "")
                    .append("{\"type\": \"sphere\", \"center\": [")
                    .append(i % 100 + 0.25)
                    .append(", ")
                    .append(i / 100 % 100 + 0.125)
                    .append(", ")
                    .append(i / 10_000 + 0.0625)
                    .append("], \"radius\": 0.375, \"material\": \"m\"}");
        }
        String json = Documents.withObjects(objects.toString())
                .replaceFirst("\\{", "{\"materials\": {\"m\": {\"type\": \"matte\", \"color\": \"#ffffff\"}},");
        Scene s = Documents.read(json, folder);
        assertEquals(count, s.objects().size());
        assertEquals(
                Sphere.of(p(99.25, 99.125, 9.0625), 0.375),
                s.objects().get(count - 1).shape());
    }

    @Test
    void allProblemsAreToldInTheOrderOfTheirPlaces() {
        String json = Documents.EVERYTHING
                .replace("\"radius\": 1.5", "\"radius\": -1.5")
                .replace("\"width\": 40", "\"width\": 0")
                .replace("\"majorRadius\": 1.75", "\"majorRadius\": 0.1")
                .replace("\"seed\": 99", "\"sead\": 99")
                .replace("\"type\": \"triangle\"", "\"type\": \"triangles\"");
        List<String> pointers = new ArrayList<>();
        for (Problem problem : Documents.problems(json, Documents.withImage(folder))) {
            pointers.add(problem.pointer());
            assertEquals("scene.json", problem.file());
        }
        assertEquals(
                List.of(
                        "/image/width",
                        "/objects/0/radius",
                        "/objects/7/minorRadius",
                        "/objects/8/type",
                        "/render/sead"),
                pointers);
    }

    @Test
    void aFileOfNothingButMistakesIsCutShort() {
        String json = Documents.withObjects("1,".repeat(4999) + "1");
        List<Problem> problems = Documents.problems(json, folder);
        assertEquals(Problems.MOST_KEPT + 1, problems.size());
        assertEquals("and 4000 more problems", problems.get(Problems.MOST_KEPT).message());
    }
}
