package enlightenment.compiled;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.color.Encoding;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneProblemsTest {
    @Test
    void eachImageIsReadOnce(@TempDir Path folder) throws IOException {
        for (String name : List.of("a.png", "b.png", "around.png", "c.png")) {
            ImageFiles.writePng(new Image(4, 2, new float[24], Encoding.DISPLAY), folder.resolve(name));
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
