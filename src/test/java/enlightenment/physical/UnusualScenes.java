package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Scenes with numbers at the ends of their ranges, and with many lights of different kinds. */
final class UnusualScenes {
    private static final Rgb WARM = new Rgb(5, 4, 2);
    private static final Light CEILING = panel(0.05, 1.9, 0, 0.6, WARM, false);
    private static final Shape BALL = ball(-0.35, 0.45, -0.1, 0.42);
    private static final Shape CUBE = new Cube(at(0.4, 0.6, -0.2), 0.55, new Vec3(20, 30, 40));

    private UnusualScenes() {}

    static void addTo(Map<String, Scene.Builder> scenes) {
        surfaces(scenes);
        lights(scenes);
        cameras(scenes);
    }

    private static void surfaces(Map<String, Scene.Builder> scenes) {
        scenes.put(
                "nearly mirrors",
                room().light(CEILING)
                        .object(BALL, Glossy.of(linear(0.9, 0.8, 0.7), 0.06))
                        .object(CUBE, Glossy.of(linear(0.7, 0.8, 0.9), 0.15)));
        scenes.put(
                "the roughest",
                room().light(CEILING)
                        .object(BALL, Glossy.of(linear(0, 0.5, 1), 1))
                        .object(CUBE, new Glossy(linear(0, 0.5, 1), 1, Optional.empty(), false, Rgb.BLACK)));
        scenes.put(
                "hardly rough matte",
                room().light(CEILING)
                        .object(BALL, matte(1, 0.5, 0).withRoughness(0.02))
                        .object(CUBE, matte(1, 0.5, 0).withRoughness(1)));
        scenes.put(
                "hardly rough glass",
                room().light(CEILING)
                        .object(
                                BALL,
                                Glass.of(linear(1, 1, 1), 1.5)
                                        .withRoughness(0.15)
                                        .withMultipleScattering(false))
                        .object(
                                CUBE,
                                Glass.of(linear(1, 1, 1), 0.8)
                                        .withRoughness(0.9)
                                        .withMultipleScattering(false)));
        Texture checker = new Texture.Checker(List.of(DisplayRgb.of(0.9, 0.5, 0.7), new Rgb(0.05, 0.3, 0.9)), 6);
        scenes.put(
                "checkered metal, mirror and glass",
                room().light(CEILING)
                        .object(BALL, Glossy.of(checker, 0.6))
                        .object(ball(0.4, 0.4, -0.3, 0.35), Material.Mirror.of(checker))
                        .object(ball(0.1, 1.2, -0.2, 0.35), Glass.of(checker, 1.3)));
        scenes.put(
                "rough glass in glass",
                room().light(CEILING)
                        .object(ball(0, 0.9, -0.2, 0.7), Glass.of(linear(1, 0.9, 0.9), 1.3))
                        .object(
                                ball(0.1, 0.9, -0.3, 0.4),
                                new Glass(linear(1, 1, 1), 1.7, 1, 1, true)
                                        .withRoughness(0.5)
                                        .withAbsorption(Rgb.gray(0.2))
                                        .withMultipleScattering(false)));
    }

    private static void lights(Map<String, Scene.Builder> scenes) {
        Material.Matte glow = matte(0.6, 0.3, 0.1).withRadiance(new Rgb(1, 2, 4));
        scenes.put("glowing cube", room().object(CUBE, glow).object(BALL, PhysicalScenes.WHITE));
        scenes.put(
                "glowing metal cube",
                room().object(CUBE, new Glossy(linear(0.9, 0.5, 0.2), 0.5, Optional.empty(), true, new Rgb(1, 2, 4)))
                        .object(BALL, matte(0.7, 0.7, 0.7).withRoughness(1)));
        Scene.Builder many = room().object(BALL, PhysicalScenes.WHITE)
                .object(CUBE, Glossy.of(linear(0.9, 0.7, 0.5), 0.7))
                .shading(shading(0.05));
        for (int k = 0; k < 12; k++) {
            double angle = k * 2.399963;
            double x = (0.25 + 0.05 * k) * Math.cos(angle);
            double z = (0.25 + 0.05 * k) * Math.sin(angle);
            many.light(sphereLight(x, 1.35 + 0.01 * k, z, 0.06, 4 + k))
                    .light(panel(z, 1.7 + 0.01 * k, -x, 0.08, new Rgb(12, 3, k), k % 2 == 0))
                    .object(new Box(at(x, 1.5, z), at(x + 0.08, 1.55 + 0.01 * k, z + 0.05)), glow);
            if (k % 3 == 0) {
                many.light(new Light.Point(at(-z, 1, x), Rgb.WHITE, Emission.intensity(Rgb.gray(0.03 * k))))
                        .object(new Cylinder(at(-x, 0.9, -z), at(-x, 1.1, -z), 0.07, k % 2 == 0), glow);
            }
        }
        scenes.put("many lights of all kinds", many);
        scenes.put(
                "a bright light that is hidden and a dim one",
                room().light(sphereLight(0, -0.5, 0, 0.3, 1000))
                        .light(CEILING)
                        .object(BALL, PhysicalScenes.WHITE)
                        .object(new Box(at(-3, -2, -3), at(3, -0.9, 3)), PhysicalScenes.WHITE)
                        .object(new Box(at(-3, -0.1, -3), at(3, -0.05, 3)), PhysicalScenes.WHITE));
    }

    private static void cameras(Map<String, Scene.Builder> scenes) {
        scenes.put(
                "wide angle in a small room",
                room().light(CEILING)
                        .object(BALL, Material.Mirror.of(linear(0.9, 0.9, 0.9)))
                        .camera(new Camera.Perspective(
                                at(0.2, 1.2, -0.7), at(-0.1, 0.7, 0.3), new Vec3(0.3, 1, 0.2), 120)));
        scenes.put(
                "through a small window",
                room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                        .object(BALL, PhysicalScenes.WHITE)
                        .camera(new Camera.Window(
                                at(0.3, 1.3, -1.2),
                                at(-0.1, 0.5, -0.8),
                                at(-0.15, 1.1, -0.7),
                                at(0.4, 1.1, -0.6),
                                at(0.45, 0.5, -0.7),
                                0)));
    }
}
