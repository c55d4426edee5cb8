package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Transform;
import enlightenment.material.Composite;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneWriterTest {
    @TempDir
    Path folder;

    private static final TriangleMesh CORNER =
            TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});

    private static Scene.Builder scene() {
        return Scene.builder().camera(new Camera.Isometric(ExactPoint.ORIGIN, 5));
    }

    private static Sphere ball() {
        return Sphere.of(ExactPoint.of("0.1", "0", "1e5"), 0.1);
    }

    @Test
    void shippedScenesAreReadBackEqual() {
        Path scenes = Documents.shippedScenes(folder);
        for (String name : Documents.shippedNames()) {
            Scene scene = SceneReader.read(scenes.resolve(name));
            Path elsewhere = folder.resolve(name);
            SceneWriter.write(scene, elsewhere);
            assertEquals(scene, SceneReader.read(elsewhere), name);
        }
    }

    @Test
    void theDocumentWithEverythingIsReadBackEqual() {
        Scene scene = Documents.read(Documents.EVERYTHING, Documents.withImage(folder));
        String json = SceneWriter.toJson(scene, folder);
        assertEquals(scene, Documents.read(json, folder));
        assertEquals(json, SceneWriter.toJson(Documents.read(json, folder), folder));
    }

    @Test
    void randomScenesAreReadBackEqual() throws IOException {
        Path images = Documents.withImage(Files.createDirectories(folder.resolve("images")));
        RandomScenes scenes = new RandomScenes(20, images);
        for (int i = 0; i < 500; i++) {
            Scene scene = scenes.next();
            String json = SceneWriter.toJson(scene, folder);
            assertEquals(scene, Documents.read(json, folder), json);
        }
    }

    @Test
    void randomScenesSurviveAFile() throws IOException {
        Path images = Documents.withImage(Files.createDirectories(folder.resolve("images")));
        Path file = Files.createDirectories(folder.resolve("a/b")).resolve("scene.json");
        RandomScenes scenes = new RandomScenes(21, images);
        for (int i = 0; i < 20; i++) {
            Scene scene = scenes.next();
            SceneWriter.write(scene, file);
            assertEquals(scene, SceneReader.read(file));
        }
    }

    @Test
    void theTextIsMadeToBeRead() {
        Material gold = Material.Matte.of(Texture.of(DisplayRgb.ofBytes(255, 215, 0)));
        String json = SceneWriter.toJson(
                scene().material("gold", gold)
                        .object(ball(), gold)
                        .object(ball(), Material.Mirror.of(Texture.of(DisplayRgb.of(0.1, 0.2, 0.3))))
                        .build(),
                folder);
        assertEquals(
                """
                {
                  "image": { "width": 800, "height": 400 },
                  "camera": { "type": "isometric", "lookAt": [0, 0, 0], "height": 5 },
                  "shading": { "model": "classic", "ambient": 0.5, "shadow": 0.5 },
                  "materials": {
                    "gold": { "type": "matte", "color": "#ffd700" }
                  },
                  "objects": [
                    { "type": "sphere", "center": [0.1, 0, 100000], "radius": 0.1, "material": "gold" },
                    {
                      "type": "sphere",
                      "center": [0.1, 0, 100000],
                      "radius": 0.1,
                      "material": { "type": "mirror", "color": [0.1, 0.2, 0.3] }
                    }
                  ],
                  "render": { "method": "raytrace", "antialias": 4, "shadowSamples": 10 }
                }
                """,
                json);
    }

    /** A name stands before its use, so a part that is named later is written out; and maps of one colour get names. */
    @Test
    void partsThatAreNamedLaterAndMapsOfOneColourAreReadBackEqual() {
        Texture red = Texture.of(DisplayRgb.of(1, 0.25, 0));
        Material wood = Material.Matte.of(Texture.of(DisplayRgb.ofBytes(1, 2, 3)));
        Material turned = new Composite.NormalMap(new Composite.Mask(wood, red), Texture.of(Rgb.gray(0.5)));
        Scene scene = scene().shading(Shading.Physical.DEFAULT)
                .material("turned", turned)
                .material("wood", wood)
                .object(ball(), turned)
                .build();
        Scene back = Documents.read(SceneWriter.toJson(scene, folder), folder);
        assertEquals(scene.materials(), back.materials());
        assertEquals(scene.objects(), back.objects());
        assertEquals(2, back.textures().size());
    }

    @Test
    void texturesWithoutNamesGetNames() {
        Documents.withImage(folder);
        Texture image = new Texture.File(folder.resolve("ice.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB);
        Texture checks = new Texture.Checker(List.of(DisplayRgb.BLACK, DisplayRgb.WHITE), 4);
        Scene scene = scene().texture("texture 1", Texture.of(DisplayRgb.BLACK))
                .object(ball(), Material.Matte.of(image))
                .object(ball(), Material.Mirror.of(checks))
                .object(ball(), Material.Mirror.of(image))
                .build();
        Scene read = Documents.read(SceneWriter.toJson(scene, folder), folder);
        assertEquals(scene.objects(), read.objects());
        assertEquals(
                Map.of("texture 1", Texture.of(DisplayRgb.BLACK), "texture 2", image, "texture 3", checks),
                read.textures());
    }

    @Test
    void pathsOfTexturesAreRelativeToTheFile() throws IOException {
        Documents.withImage(folder);
        Texture image = new Texture.File(folder.resolve("ice.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB);
        Scene scene = scene().texture("ice", image).build();
        Path file = Files.createDirectories(folder.resolve("x/y")).resolve("scene.json");
        SceneWriter.write(scene, file);
        assertTrue(Files.readString(file).contains("\"../../ice.png\""));
        assertEquals(scene, SceneReader.read(file));
    }

    /** As a mesh is sent to other machines: by the name of a file that holds it as it is, whatever it was read from. */
    @Test
    void aMeshMayHaveTheNameOfAFileThatHoldsIt() throws IOException {
        Transform transform = Transform.of(new Transform.Scale(new Vec3(1, -1, 0.1)));
        Material black = Material.Matte.of(Texture.of(DisplayRgb.BLACK));
        Scene scene = scene().object(Mesh.of(CORNER, transform), black).build();
        String json = SceneWriter.toJson(scene, new SceneWriter.FileNames() {
            @Override
            public String of(Path file) {
                throw new AssertionError(file);
            }

            @Override
            public Optional<String> of(TriangleMesh mesh) {
                return Optional.of(mesh.digest());
            }
        });
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MeshFiles.writePly(CORNER, bytes);
        SceneReader.NamedFiles files = new SceneReader.NamedFiles(Map.of(CORNER.digest(), bytes.toByteArray()));
        Mesh read =
                (Mesh) SceneReader.readNamed(json, files, "").objects().get(0).shape();
        assertEquals(CORNER, read.triangles());
        assertEquals(transform, read.transform());
        Mesh again =
                (Mesh) SceneReader.readNamed(json, files, "").objects().get(0).shape();
        assertSame(read.triangles(), again.triangles());
    }

    @Test
    void whatIsAnimatedIsWrittenEvenWhereItIsUsual() {
        TreeMap<Integer, BigDecimal> keys = new TreeMap<>(Map.of(0, BigDecimal.ZERO, 10, BigDecimal.ONE));
        Scene scene = scene().material("black", Material.Matte.of(Texture.of(DisplayRgb.BLACK)))
                .object(ball(), Material.Matte.of(Texture.of(DisplayRgb.BLACK)))
                .animation(new Animation(
                        11,
                        25,
                        List.of(
                                new Animation.Track("/objects/0/rotation", keys),
                                new Animation.Track("/objects/0/material/color/1", keys))))
                .build();
        String json = SceneWriter.toJson(scene, folder);
        assertTrue(json.contains("\"rotation\": 0,"), json);
        assertTrue(json.contains("\"material\": { \"type\": \"matte\", \"color\": [0, 0, 0] }"), json);
        assertEquals(scene, Documents.read(json, folder));
    }

    @Test
    void aShutterOfMinusZeroIsShutAsAnyOther() {
        Scene plain = Scene.builder()
                .camera(new Camera.Isometric(ExactPoint.ORIGIN, 5))
                .animation(new Animation(10, 25, List.of(), -0.0, 16))
                .build();
        assertEquals(plain, Documents.read(SceneWriter.toJson(plain, folder), folder));
        assertEquals(new Animation(10, 25, List.of(), 0, 16), plain.animation().orElseThrow());
    }

    @Test
    void whatTheFormatCannotSayIsRefused() {
        TreeMap<Integer, BigDecimal> keys = new TreeMap<>(Map.of(0, BigDecimal.ZERO));
        refused(
                "/animation/tracks/0/target",
                scene().animation(new Animation(1, 25, List.of(new Animation.Track("/objects/7/radius", keys))))
                        .build());
        Material black = Material.Matte.of(Texture.of(DisplayRgb.BLACK));
        refused("/objects/0", scene().object(Mesh.of(CORNER), black).build());
        refused("/name", scene().name("a\ud800b").build());
        refused("/materials/\udc00", scene().material("\udc00", black).build());
        for (String x : new String[] {"1e-500", "1e400", "1e-9999", "1." + "1".repeat(2000)}) {
            refused(
                    "/objects/0/center/1",
                    scene().object(Sphere.of(ExactPoint.of("0", x, "0"), 1), black)
                            .build());
        }
    }

    @Test
    void textsAndKeysAreWrittenAsLongAsTheyCanBeReadAndNoLonger() {
        Material black = Material.Matte.of(Texture.of(DisplayRgb.BLACK));
        Scene longest = scene().name("n".repeat(1_000_000))
                .material("k".repeat(10_000), black)
                .build();
        assertEquals(longest, Documents.read(SceneWriter.toJson(longest, folder), folder));
        refused("/name", scene().name("n".repeat(1_000_001)).build());
        refused("/materials", scene().material("k".repeat(10_001), black).build());
    }

    /** A frame with an open shutter was read at its moments, which the file would not have: the blur would be lost without a word. */
    @Test
    void aFrameWithMotionBlurIsRefused() {
        Scene scene = scene().build();
        refused("", scene.withInstants(List.of(scene, scene)));
    }

    private void refused(String pointer, Scene scene) {
        SceneException e = assertThrows(SceneException.class, () -> SceneWriter.toJson(scene, folder));
        assertEquals(pointer, e.problems().get(0).pointer());
    }

    @Test
    void aFolderThatIsNotThereIsAFailureOfWriting() {
        Path nowhere = folder.resolve("no/such/folder/scene.json");
        assertThrows(UncheckedIOException.class, () -> SceneWriter.write(scene().build(), nowhere));
    }
}
