package enlightenment.render;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;

/** Small scenes unlike those that come with the program, in which an estimate of the error may well be wrong. */
final class HardScenes {
    static final int WIDTH = 96;
    static final int HEIGHT = 64;

    /** All of them; the last of their names are of textures that lie exactly on the pixels, where a single sample has no error. */
    static final List<String> NAMES = List.of(
            "slats",
            "screen",
            "grid",
            "wires",
            "dots",
            "noise",
            "soft-noise",
            "tiles",
            "floor",
            "lights",
            "spot",
            "half");

    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));
    private static final Light LAMP = new Light.Sphere(ExactPoint.of(-2, 3, -5), 0.4, DisplayRgb.WHITE);

    private HardScenes() {}

    static Scene of(String name) {
        Scene.Builder b = Scene.builder()
                .name(name)
                .size(WIDTH, HEIGHT)
                .camera(new Camera.Orthographic(
                        ExactPoint.of(0, 0, -10), ExactPoint.of(0, 0, 0), new Vec3(0.2, 1, 0), 2))
                .render(new RenderSettings.Defaults(
                        Method.RAYTRACE, 1, ChosenSettings.of(new BuiltInMethod.RayTraceSettings(1))));
        switch (name) {
            case "slats" -> slats(b.light(LAMP), 0.0191, 0.4);
            case "screen" -> screen(b);
            case "grid" -> grid(b.light(LAMP), 100, 0.004);
            case "wires" -> grid(b.light(LAMP), 6, 0.0008);
            case "dots" -> dots(b);
            case "noise" -> b.object(sheet(1.7), texture(noise(), Texture.Filter.NEAREST));
            case "soft-noise" -> b.object(sheet(1.7), texture(noise(), Texture.Filter.BILINEAR));
            case "tiles" -> b.object(sheet(2), checker(151.7));
            case "floor" -> floor(b);
            case "lights" -> lights(b);
            case "spot" -> b.object(sheet(0.17), checker(23)).light(LAMP);
            case "half" -> half(b.light(LAMP));
            default -> throw new IllegalArgumentException(name);
        }
        return b.build();
    }

    private static void slats(Scene.Builder b, double pitch, double share) {
        for (int k = -110; k < 110; k++) {
            double x = k * pitch;
            b.object(new Box(ExactPoint.of(x, -2, 0), ExactPoint.of(x + share * pitch, 2, 0.05)), WHITE);
        }
    }

    /** Slats before a lit wall, with their shadows on it, under a perspective camera. */
    private static void screen(Scene.Builder b) {
        slats(b.light(LAMP), 0.0283, 0.5);
        b.camera(new Camera.Perspective(ExactPoint.of(0.4, 0.3, -4), ExactPoint.of(0, 0, 0), new Vec3(0, 1, 0), 30))
                .object(TestScenes.rectangle(-6, -6, 1, -6, 6, 1, 6, 6, 1, 6, -6, 1), TestScenes.matte(0.8, 0.5, 0.3));
    }

    private static void grid(Scene.Builder b, int lines, double radius) {
        for (int k = 0; k < lines; k++) {
            double at = -1.6 + 3.2 * (k + 0.5) / lines;
            b.object(new Cylinder(ExactPoint.of(at, -2, 0), ExactPoint.of(at, 2, 0), radius, true), WHITE);
            b.object(new Cylinder(ExactPoint.of(-2, at, 0), ExactPoint.of(2, at, 0), radius, true), WHITE);
        }
    }

    /** Five balls smaller than a pixel on black. */
    private static void dots(Scene.Builder b) {
        Random random = new Random(3);
        for (int k = 0; k < 5; k++) {
            ExactPoint at = ExactPoint.of(2.4 * random.nextDouble() - 1.2, 1.8 * random.nextDouble() - 0.9, 0);
            b.object(Sphere.of(at, 0.012), WHITE);
        }
        b.light(LAMP);
    }

    /** A square sheet across the line of sight, half as wide as that. */
    private static Rectangle sheet(double half) {
        double h = half + 0.003;
        return TestScenes.rectangle(-half, -h, 0, -half, h, 0, half, h, 0, half, -h, 0);
    }

    private static Material checker(double scale) {
        return Material.Matte.of(new Texture.Checker(List.of(DisplayRgb.WHITE, DisplayRgb.of(0.1, 0.1, 0.3)), scale));
    }

    private static Material texture(Path file, Texture.Filter filter) {
        return Material.Matte.of(new Texture.File(file, filter, Texture.Encoding.SRGB));
    }

    /** A file of 97 × 101 independent texels: about as large as pixels on a sheet of 1.7. */
    private static Path noise() {
        Random random = new Random(1);
        float[] rgb = new float[3 * 97 * 101];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat();
        }
        try {
            Path file = Files.createTempFile("noise", ".png");
            file.toFile().deleteOnExit();
            ImageFiles.writePng(new Image(97, 101, rgb), file);
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A checkerboard towards the horizon. */
    private static void floor(Scene.Builder b) {
        b.camera(new Camera.Perspective(ExactPoint.of(0, 1, -5), ExactPoint.of(0, 0.8, 0), new Vec3(0, 1, 0), 40))
                .light(LAMP)
                .object(TestScenes.rectangle(-40, 0, -5, -40, 0, 75, 40, 0, 75, 40, 0, -5), checker(80));
    }

    /** A floor with balls under a field of small lights. */
    private static void lights(Scene.Builder b) {
        b.camera(new Camera.Perspective(ExactPoint.of(0, 3, -6), ExactPoint.of(0, 0.2, 0), new Vec3(0, 1, 0), 35))
                .shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 100))
                .object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), WHITE);
        for (int k = 0; k < 36; k++) {
            ExactPoint at = ExactPoint.of(-2.5 + k % 6, 2 + 0.1 * (k % 5), -2.5 + k / 6);
            b.light(new Light.Sphere(at, 0.05, DisplayRgb.of(0.06, 0.06, 0.05)));
        }
        for (int k = 0; k < 9; k++) {
            b.object(Sphere.of(ExactPoint.of(-1.5 + 1.5 * (k % 3), 0.4, -1.5 + 1.5 * (k / 3)), 0.35), WHITE);
        }
    }

    /** Noise of a texture in the left half, a ball and its shadow in the right. */
    private static void half(Scene.Builder b) {
        b.object(
                TestScenes.rectangle(-3.4, -1.7, 0, -3.4, 1.7, 0, 0, 1.7, 0, 0, -1.7, 0),
                texture(noise(), Texture.Filter.NEAREST));
        b.object(TestScenes.rectangle(0, -2, 0.5, 0, 2, 0.5, 4, 2, 0.5, 4, -2, 0.5), WHITE)
                .object(Sphere.of(ExactPoint.of(0.8, 0, 0), 0.5), TestScenes.matte(0.3, 0.5, 0.9));
    }
}
