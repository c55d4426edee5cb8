package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example of docs/guide/importing.md: it compiles, stands there as it does here, and makes a picture of a model. */
class ThumbnailTest {
    private static final Path PAGE = Path.of("docs/guide/importing.md");
    private static final Path HERE = Path.of("src/test/java/enlightenment/importer/gltf/ThumbnailTest.java");

    @TempDir
    Path folder;

    private static void makeThumbnail(Path file, Path picture) throws IOException {
        SceneImporter.Result model = SceneImporter.read(file, SceneImporter.Options.DEFAULT);
        RenderSettings small =
                RenderSettings.of(model.scene()).withSize(160, 120).withSamples(8);
        ImageFiles.writePng(Renderer.render(model.scene(), small), picture);
    }

    @Test
    void theExampleOfThePageIsThisOne() throws IOException {
        String page = Files.readString(PAGE);
        String example = page.substring(page.indexOf("```java\n") + 8, page.lastIndexOf("```"));
        assertTrue(Files.readString(HERE).contains(example.indent(8)), "docs/guide/importing.md shows other code");
    }

    /** A green cube on the grey ground: its pixels, and no others, are more green than red and blue. */
    @Test
    void itShowsTheModelInTheMiddle() throws IOException {
        GltfFile file = new GltfFile();
        file.add("materials", "{'pbrMetallicRoughness':{'baseColorFactor':[0.1,0.6,0.1,1],'metallicFactor':0}}");
        int p = file.floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1);
        int i = file.indices(
                0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7,
                5);
        file.add("meshes", "{'primitives':[{'attributes':{'POSITION':" + p + "},'indices':" + i + ",'material':0}]}");
        file.add("nodes", "{'mesh':0}");
        Path model = Files.write(folder.resolve("cube.glb"), file.glb());
        Path picture = folder.resolve("cube.png");
        makeThumbnail(model, picture);
        Image image = ImageFiles.read(picture);
        assertEquals(160, image.width());
        assertTrue(isGreen(image, 80, 60), "the middle shows the cube");
        assertTrue(!isGreen(image, 5, 5) && !isGreen(image, 154, 114), "the corners do not");
    }

    private static boolean isGreen(Image image, int x, int y) {
        float green = image.component(x, y, 1);
        return green > 1.3 * image.component(x, y, 0) && green > 1.3 * image.component(x, y, 2);
    }
}
