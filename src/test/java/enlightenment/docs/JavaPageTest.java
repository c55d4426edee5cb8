package enlightenment.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The examples of docs/guide/java.md: they stand there as they do here, and do what the page says. */
class JavaPageTest {
    private static final Path HERE = Path.of("src/test/java/enlightenment/docs/JavaPageTest.java");

    @TempDir
    Path folder;

    @Test
    void everyExampleOfThePageIsOneOfThese() throws IOException {
        String code = Files.readString(HERE);
        int examples = 0;
        for (String block : GuidePages.blocks(Path.of("docs/guide/java.md"), "java")) {
            assertTrue(code.contains(block.indent(8)), block);
            examples++;
        }
        assertEquals(6, examples);
    }

    @Test
    void aSceneFileBecomesAPicture() throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes/fire-and-ice.json"));
        Image image = Renderer.render(scene, RenderSettings.of(scene).withSize(160, 80));
        ImageFiles.writePng(image, folder.resolve("fire-and-ice.png"));
        assertEquals(160, ImageFiles.read(folder.resolve("fire-and-ice.png")).width());
    }

    private static Scene ball() {
        Texture red = new Texture.Solid(new Rgb(0.5, 0.1, 0.05));
        Texture grey = new Texture.Solid(Rgb.gray(0.6));
        Scene scene = Scene.builder()
                .size(160, 120)
                .camera(new Camera.Perspective(ExactPoint.of(0, 1.5, -6), ExactPoint.of(0, 0.8, 0), Vec3.Y, 30))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(0.2)))
                .light(new Light.Sphere(ExactPoint.of(-3, 5, -3), 1, DisplayRgb.WHITE, Emission.radiance(Rgb.gray(12))))
                .object(Sphere.of(ExactPoint.of(0, 1, 0), 1), Coated.of(red, 0.3))
                .object(Sphere.of(ExactPoint.of(0, -1000, 0), 1000), Material.Matte.of(grey))
                .build();
        return scene;
    }

    /** The ball is in the middle, and redder than what is around it. */
    @Test
    void aSceneInCodeIsShownInAnApplication() {
        Scene scene = ball();
        Image image = Renderer.render(scene);
        BufferedImage picture = image.toBufferedImage();
        assertTrue(red(picture, 80, 55) > 1.5 * blue(picture, 80, 55), "the middle is red");
        assertTrue(red(picture, 5, 110) < 1.2 * blue(picture, 5, 110), "the floor is grey");
    }

    private static int red(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) >> 16 & 0xff;
    }

    private static int blue(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xff;
    }

    @Test
    void aMeshOfPositionsAndIndicesIsASolid() {
        float[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        int[] faces = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        Mesh tetrahedron = Mesh.of(corners, faces);
        assertTrue(tetrahedron.enclosesVolume());
        assertEquals(1 / 6.0, tetrahedron.triangles().volume(), 1e-12);
    }

    @Test
    void anErrorIsAskedForAndARenderIsStopped() {
        Scene scene = ball();
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(Method.CLUSTER)
                .withError(0.02)
                .withSeconds(20);
        RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        double error = result.report().sampling().errorHigh();
        assertTrue(error > 0 && error <= 0.02, "error " + error);

        AtomicBoolean cancelled = new AtomicBoolean();
        RenderProgress progress = (done, total, soFar) -> {
            if (done * 2 >= total) {
                cancelled.set(true);
            }
        };
        RenderRequest request =
                RenderRequest.of(scene, settings).withProgress(progress).withCancelled(cancelled::get);
        RenderResult partial = Renderer.render(request);
        assertTrue(!partial.complete() || cancelled.get());
    }
}
