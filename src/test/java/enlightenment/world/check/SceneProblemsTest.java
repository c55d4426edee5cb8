package enlightenment.world.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.SceneImages;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneProblemsTest {
    /** A texel of 1 and a sky of about 10 times 1e99: more than any float. The file has two names, and is told once. */
    @ParameterizedTest
    @ValueSource(strings = {"\"texture\": \"around\"", "\"type\": \"sky\", \"elevation\": 30"})
    void surroundingsThatAreTooBrightAreToldAtTheirRadiance(String kind, @TempDir Path folder) throws IOException {
        float[] white = new float[24];
        Arrays.fill(white, 1);
        ImageFiles.writePng(new Image(4, 2, white, Color.Encoding.DISPLAY), folder.resolve("around.png"));
        Scene scene = SceneReader.readString(
                """
                { "image": { "width": 8, "height": 6 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "shading": { "model": "physical", "background": { %s, "radiance": 1e99 } },
                  "textures": { "around": { "file": "around.png" }, "again": { "file": "around.png" } }, "objects": [] }
                """
                        .formatted(kind),
                folder,
                "");
        for (Executable use : List.<Executable>of(
                () -> SceneProblems.check(scene, RenderSettings.of(scene), path -> {}),
                () -> SceneCompiler.compile(scene, RenderSettings.of(scene)))) {
            List<Problem> problems = assertThrows(SceneException.class, use).problems();
            assertEquals(1, problems.size(), problems.toString());
            assertEquals("/shading/background/radiance", problems.get(0).pointer(), problems.toString());
            assertTrue(problems.get(0).message().contains("beyond the range of floats"), problems.toString());
        }
    }

    /** A PNG file that ends after its signature: of a part's colour, of a mask and of a bump around it. */
    @Test
    void imagesOfMaterialsThatAreMadeOfOthersAreReadToo(@TempDir Path folder) throws IOException {
        for (String name : List.of("color.png", "mask.png", "bump.png")) {
            Files.write(folder.resolve(name), new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        }
        Scene scene = SceneReader.readString(
                """
                { "image": { "width": 8, "height": 6 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "textures": { "color": { "file": "color.png" }, "mask": { "file": "mask.png" }, "bump": { "file": "bump.png" } },
                  "materials": {
                    "inner": { "type": "mask", "of": { "type": "matte", "color": { "texture": "color" } }, "map": { "texture": "mask" } },
                    "outer": { "type": "bump", "of": "inner", "map": { "texture": "bump" }, "height": 1 } },
                  "objects": [{ "type": "sphere", "center": [0, 0, 5], "radius": 1, "material": "outer" }] }
                """,
                folder,
                "");
        List<String> others = new ArrayList<>();
        List<Problem> problems = assertThrows(
                        SceneException.class,
                        () -> SceneProblems.check(scene, RenderSettings.of(scene), path -> others.add(path.toString())))
                .problems();
        assertEquals(
                List.of("/textures/color/file", "/textures/mask/file", "/textures/bump/file"),
                problems.stream().map(Problem::pointer).toList());
        assertEquals(List.of(), others);
    }

    @Test
    void eachImageIsReadOnce(@TempDir Path folder) throws IOException {
        for (String name : List.of("a.png", "b.png", "around.png", "c.png")) {
            ImageFiles.writePng(new Image(4, 2, new float[24], Color.Encoding.DISPLAY), folder.resolve(name));
        }
        Scene scene = SceneReader.readString(
                """
                { "image": { "width": 8, "height": 6 },
                  "camera": { "type": "perspective", "eye": [0, 0, 0], "lookAt": [0, 0, 1], "fieldOfView": 40 },
                  "shading": { "model": "physical", "background": { "texture": "around" } },
                  "textures": { "a": { "file": "a.png" }, "b": { "file": "b.png" }, "c": { "file": "c.png" }, "around": { "file": "around.png" } },
                  "objects": [
                    { "type": "sphere", "center": [0, 0, 5], "radius": 1, "material": { "type": "matte", "color": { "texture": "a" } } },
                    { "type": "sphere", "center": [3, 0, 5], "radius": 1, "material": { "type": "matte", "color": { "texture": "a" } } },
                    { "type": "sphere", "center": [6, 0, 5], "radius": 1, "material": { "type": "matte", "color": { "texture": "b" } } } ] }
                """,
                folder,
                "");
        List<String> read = new ArrayList<>();
        SceneImages images = new SceneImages(path -> {
            read.add(path.getFileName().toString());
            return null;
        });
        SceneProblems.check(
                scene,
                RenderSettings.of(scene),
                images,
                path -> read.add(path.getFileName().toString()));
        assertEquals(
                List.of("a.png", "around.png", "b.png", "c.png"),
                read.stream().sorted().toList());
    }
}
