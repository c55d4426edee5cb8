package enlightenment.render;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;

/**
 * Scenes that are unlike the shipped ones: full of what is finer than a pixel, or with next to nothing to see. Their picture is
 * the rectangle of 4 by 3 around the origin of the plane z = 0, seen from in front, 128 × 96 pixels of 1/32.
 */
final class FineScenes {
    static final int WIDTH = 128;
    static final int HEIGHT = 96;

    private static final double PIXEL = 1 / 32.0;
    private static final Shading.Classic DIM = new Shading.Classic(0.15, 0, DisplayRgb.BLACK, 8);

    static final List<String> NAMES = List.of("wires", "slats", "grid", "lamps", "noise", "spot");

    private FineScenes() {}

    /** @param directory where a scene may keep its texture */
    static Scene of(String name, Path directory) {
        Scene.Builder b = Scene.builder()
                .name(name)
                .size(WIDTH, HEIGHT)
                .shading(DIM)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 0, -10), ExactPoint.of(0, 0, 0), Vec3.Y, 3));
        switch (name) {
            case "wires" -> wires(b, 0.05, 0.33);
            case "hairs" -> wires(b, 0.01, 0.03);
            case "slats" -> slats(b);
            case "grid" -> grid(b);
            case "lamps" -> lamps(b);
            case "noise" -> noise(b, directory);
            case "spot" -> spot(b);
            case "comb" -> comb(b);
            default -> throw new IllegalArgumentException(name);
        }
        return b.build();
    }

    private static void wall(Scene.Builder b, double z, Material material) {
        b.object(TestScenes.rectangle(-9, -9, z, -9, 9, z, 9, 9, z, 9, -9, z), material);
    }

    private static Cylinder rod(ExactPoint base, ExactPoint top, double radius) {
        return new Cylinder(base, top, radius, true);
    }

    private static Light sun() {
        return new Light.Sphere(ExactPoint.of(-6, 9, -20), 0.5, DisplayRgb.WHITE);
    }

    /** White wires at all angles before a dark wall, of widths in this range of pixels. */
    private static void wires(Scene.Builder b, double least, double most) {
        wall(b, 1, TestScenes.matte(0.1, 0.12, 0.15));
        Random random = new Random(1);
        for (int k = 0; k < 16; k++) {
            double angle = Math.PI * (k + 0.3) / 16;
            double offset = 2.6 * random.nextDouble() - 1.3;
            double x = Math.cos(angle);
            double y = Math.sin(angle);
            double width = PIXEL * (least + (most - least) * k / 15);
            b.object(
                    rod(
                            ExactPoint.of(-offset * y - 4 * x, offset * x - 4 * y, -0.05 * k),
                            ExactPoint.of(-offset * y + 4 * x, offset * x + 4 * y, -0.05 * k),
                            width / 2),
                    TestScenes.matte(1, 1, 1));
        }
        b.light(sun());
    }

    /** Slats of 0.45 of a pixel every 1.03 pixels, a little askew, over half of the picture; dark behind. */
    private static void slats(Scene.Builder b) {
        wall(b, 1, TestScenes.matte(0.05, 0.05, 0.08));
        double step = 1.03 * PIXEL;
        double width = 0.45 * PIXEL;
        for (int k = 0; k < 66; k++) {
            double x = -1.2 + k * step;
            b.object(
                    TestScenes.rectangle(x, -1.3, 0, x + 0.1, 1.3, 0, x + 0.1 + width, 1.3, 0, x + width, -1.3, 0),
                    TestScenes.matte(1, 0.9, 0.7));
        }
        b.light(sun());
    }

    /** One slat for each column of 48, in its middle: every pixel is like the others, and its corners show none of it. */
    private static void comb(Scene.Builder b) {
        b.shading(new Shading.Classic(1, 1, DisplayRgb.BLACK, 8));
        wall(b, 1, TestScenes.matte(0, 0, 0));
        double step = 4 / 48.0;
        for (int k = 0; k < 48; k++) {
            double x = -2 + (k + 0.3) * step;
            double right = x + 0.4 * step;
            b.object(TestScenes.rectangle(x, -2, 0, x, 2, 0, right, 2, 0, right, -2, 0), TestScenes.matte(1, 1, 1));
        }
    }

    /** A hundred thin cylinders across and a hundred down, 1.28 pixels apart, their shadow on a wall. */
    private static void grid(Scene.Builder b) {
        wall(b, 0.7, TestScenes.matte(0.7, 0.6, 0.5));
        for (int k = 0; k < 100; k++) {
            double x = -2.03 + 4.08 * k / 99;
            double y = -1.53 + 3.06 * k / 99;
            double radius = PIXEL * 0.14;
            b.object(
                    rod(ExactPoint.of(x, -2, 0), ExactPoint.of(x + 0.07, 2, 0.1), radius),
                    TestScenes.matte(0.2, 0.5, 1));
            b.object(
                    rod(ExactPoint.of(-3, y, 0.2), ExactPoint.of(3, y + 0.05, 0.2), radius),
                    TestScenes.matte(1, 0.4, 0.2));
        }
        b.light(new Light.Sphere(ExactPoint.of(-6, 9, -20), 0.2, DisplayRgb.WHITE));
    }

    /** A floor with balls and posts under 36 small lights. */
    private static void lamps(Scene.Builder b) {
        b.camera(new Camera.Perspective(ExactPoint.of(0, 2.2, -5), ExactPoint.of(0, 0.4, 0), Vec3.Y, 40));
        b.object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), TestScenes.matte(0.9, 0.9, 0.9));
        for (int k = 0; k < 12; k++) {
            double x = k % 4 - 1.5;
            double z = k / 4 - 1;
            if (k % 2 == 0) {
                b.object(Sphere.of(ExactPoint.of(x, 0.4, z), 0.3), TestScenes.matte(1, 0.6, 0.3));
            } else {
                b.object(rod(ExactPoint.of(x, 0, z), ExactPoint.of(x, 1, z), 0.03), TestScenes.matte(0.3, 0.6, 1));
            }
        }
        for (int k = 0; k < 36; k++) {
            b.light(new Light.Sphere(ExactPoint.of(0.8 * (k % 6) - 2, 3, 0.8 * (k / 6) - 2), 0.08, DisplayRgb.WHITE));
        }
    }

    /** A texture of black and white texels of about 0.8 of a pixel. */
    private static void noise(Scene.Builder b, Path directory) {
        Path file = NoiseTexture.write(directory, 160, 120);
        Material texture = Material.Matte.of(new Texture.File(file, Texture.Filter.NEAREST, Texture.Encoding.SRGB));
        b.object(TestScenes.rectangle(-2.1, -1.55, 0, -2, 1.55, 0, 2.1, 1.5, 0, 2, -1.6, 0), texture);
        b.light(sun());
    }

    /** One lit spot, a fortieth of the width, in the dark. */
    private static void spot(Scene.Builder b) {
        b.shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 8));
        wall(b, 0, TestScenes.matte(1, 1, 1));
        b.camera(new Camera.Orthographic(ExactPoint.of(0, 0, -3), ExactPoint.of(0, 0, 0), Vec3.Y, 3));
        double hole = 0.04;
        double at = 0.4;
        b.object(
                TestScenes.rectangle(-9, -9, -6, -9, 9, -6, at - hole, 9, -6, at - hole, -9, -6),
                TestScenes.matte(0, 0, 0));
        b.object(
                TestScenes.rectangle(at + hole, -9, -6, at + hole, 9, -6, 9, 9, -6, 9, -9, -6),
                TestScenes.matte(0, 0, 0));
        b.object(
                TestScenes.rectangle(
                        at - hole, -9, -6, at - hole, at - hole, -6, at + hole, at - hole, -6, at + hole, -9, -6),
                TestScenes.matte(0, 0, 0));
        b.object(
                TestScenes.rectangle(
                        at - hole, at + hole, -6, at - hole, 9, -6, at + hole, 9, -6, at + hole, at + hole, -6),
                TestScenes.matte(0, 0, 0));
        b.light(new Light.Sphere(ExactPoint.of(at, at, -8), 0.02, DisplayRgb.WHITE));
    }
}
