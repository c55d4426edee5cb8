package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.sphereLight;

import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.scene.Method;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.List;

/** Scenes with something of all that physical light knows, for tests that what should not matter does not. */
public final class InvarianceScenes {
    private InvarianceScenes() {}

    /** Lights that are stated by their radiance: any scale can be had. */
    public static Scene byRadiance() {
        return furnished()
                .light(sphereLight(-0.4, 1.6, 0.1, 0.2, 9))
                .light(panel(0.5, 1.8, 0.3, 0.3, new Rgb(5, 4, 2), false))
                .object(ball(0.75, 0.2, -0.75, 0.15), matte(0.5, 0.5, 0.5).withRadiance(new Rgb(1, 2, 4)))
                .build();
    }

    /** Lights of a power or intensity, which grows with areas. */
    public static Scene byPower() {
        return furnished()
                .light(new Light.Sphere(
                        at(-0.4, 1.6, 0.1), 0.2, DisplayRgb.of(1, 0.8, 0.6), Emission.power(new Rgb(20, 30, 40))))
                .light(new Light.Point(at(0.3, 1.2, -0.7), Rgb.WHITE, Emission.intensity(new Rgb(0.5, 0.4, 0.3))))
                .light(new Light.Rectangle(
                        at(0.2, 1.8, 0.6),
                        at(0.2, 1.8, 0),
                        at(0.8, 1.8, 0),
                        at(0.8, 1.8, 0.6),
                        Rgb.WHITE,
                        true,
                        Emission.power(new Rgb(9, 8, 7))))
                .build();
    }

    /** Fluorescent surfaces, and lights of ultraviolet. */
    public static Scene inBlackLight() {
        Material ink = new Material.Fluorescent(
                new Texture.Checker(List.of(new Rgb(0.8, 0.7, 0.1), new Rgb(0.05, 0.1, 0.2)), 4),
                new Material.WavelengthBand(320, 480),
                new Material.WavelengthBand(470, 640),
                0.9);
        Emission power = Emission.power(new Rgb(1, 2, 9));
        Emission intensity = Emission.intensity(new Rgb(0.3, 0.2, 0.5));
        return furnished()
                .object(ball(-0.1, 1.3, 0.3, 0.25), ink)
                .object(new Box(at(-0.9, 0.01, 0.3), at(-0.5, 0.5, 0.9)), ink)
                .light(new Light.Sphere(at(-0.4, 1.6, 0.1), 0.2, Rgb.WHITE, power.withUltraviolet(40)))
                .light(new Light.Point(at(0.3, 1.2, -0.7), Rgb.WHITE, intensity.withUltraviolet(3)))
                .build();
    }

    /** More lights than are weighed one by one, where many of them are equally strong. */
    public static Scene ofManyLights() {
        Scene.Builder scene = furnished();
        for (int k = 0; k < 27; k++) {
            scene.light(
                    sphereLight(-0.6 + 0.6 * (k % 3), 1 + 0.4 * (k / 3 % 3), -0.6 + 0.6 * (k / 9), 0.05, 5 + k % 4));
        }
        return scene.build();
    }

    /** The methods that render physical light. */
    public static List<Method> methods() {
        return Method.all().stream()
                .filter(method -> method.shadings().contains(Shading.Model.PHYSICAL))
                .toList();
    }

    private static Scene.Builder furnished() {
        Glossy.Conductor copper = new Glossy.Conductor(new Rgb(0.2, 0.92, 1.1), new Rgb(3.91, 2.45, 2.14));
        Material checkered = Material.Matte.of(
                new Texture.Checker(List.of(DisplayRgb.of(0.9, 0.8, 0.7), new Rgb(0.05, 0.1, 0.2)), 5));
        Material glass = Glass.of(linear(1, 0.9, 0.95), 1.5).withAbsorption(new Rgb(0.1, 0.7, 0.3));
        return PhysicalScenes.room()
                .size(32, 24)
                .shading(PhysicalScenes.shading(0.1))
                .object(ball(-0.45, 0.45, 0.2, 0.4), Material.Mirror.of(linear(0.9, 0.95, 1)))
                .object(ball(0.35, 0.5, -0.4, 0.35), glass)
                .object(ball(0.45, 0.6, -0.35, 0.15), Glass.of(linear(1, 1, 1), 1.2))
                .object(
                        new Box(at(0.3, 0.01, 0.2), at(0.8, 0.9, 0.8)),
                        matte(0.5, 0.6, 0.7).withRoughness(0.6))
                .object(
                        new Cylinder(at(-0.7, 0.1, -0.5), at(-0.3, 0.6, -0.7), 0.15, true),
                        Glossy.metal(linear(1, 1, 1), copper, 0.4))
                .object(
                        new Disk(at(-0.1, 1.2, 0.7), new Vec3(0.2, 0.3, -1), 0.3),
                        Glossy.of(linear(0.8, 0.7, 0.3), 0.7))
                .object(ball(-0.2, 0.15, -0.8, 0.12), checkered);
    }
}
