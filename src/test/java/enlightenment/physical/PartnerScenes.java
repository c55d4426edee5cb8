package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.atMost;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static enlightenment.physical.PhysicalScenes.view;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.Method;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Small scenes, each with something that the path tracer does in its own way and the naive tracer does not know. Lights are large
 * enough to be met by chance.
 */
final class PartnerScenes {
    private static final Rgb WARM = new Rgb(5, 4, 2);
    private static final Texture WHITE = linear(1, 1, 1);
    private static final Material MIRROR = Material.Mirror.of(linear(0.95, 0.9, 0.85));
    private static final Material GLASS = Glass.of(linear(0.95, 1, 0.9), 1.5);
    private static final Glossy.Conductor COPPER =
            new Glossy.Conductor(new Rgb(0.2, 0.92, 1.1), new Rgb(3.91, 2.45, 2.14));
    private static final Shape BALL = ball(-0.35, 0.45, -0.1, 0.42);
    static final Shape BLOCK = new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1));
    private static final Light CEILING = panel(0.05, 1.9, 0, 0.6, WARM, false);
    private static final Light LAMP = sphereLight(0.2, 1.5, -0.1, 0.3, 6);

    private PartnerScenes() {}

    static Map<String, Scene> all() {
        Map<String, Scene.Builder> scenes = new TreeMap<>();
        lights(scenes);
        glowing(scenes);
        surfaces(scenes);
        glass(scenes);
        surroundings(scenes);
        limits(scenes);
        MeetingScenes.addTo(scenes);
        UnusualScenes.addTo(scenes);
        MediaScenes.addTo(scenes);
        MeshScenes.addTo(scenes);
        Map<String, Scene> built = new TreeMap<>();
        scenes.forEach((name, scene) -> built.put(name, scene.name(name).build()));
        return built;
    }

    /** Those that a method can render. */
    static Map<String, Scene> of(Method method) {
        Map<String, Scene> some = all();
        some.values().removeIf(scene -> !Method.supports(method, scene));
        return some;
    }

    private static Scene.Builder furnished() {
        return room().object(BALL, PhysicalScenes.WHITE).object(BLOCK, PhysicalScenes.GREEN);
    }

    private static void lights(Map<String, Scene.Builder> scenes) {
        scenes.put("sphere light", furnished().light(LAMP));
        scenes.put("sphere light in a wall", furnished().light(sphereLight(-0.9, 1.1, 0.4, 0.35, 6)));
        scenes.put(
                "sphere light of a power",
                furnished()
                        .light(new Light.Sphere(
                                at(0.2, 1.5, -0.1),
                                0.3,
                                DisplayRgb.of(1, 0.8, 0.6),
                                Emission.power(new Rgb(20, 30, 40)))));
        scenes.put("panel to one side", furnished().light(CEILING));
        scenes.put("panel to two sides", furnished().light(panel(0.1, 1.2, 0.1, 0.35, WARM, true)));
        scenes.put(
                "leaning panel of a power",
                furnished()
                        .light(new Light.Rectangle(
                                at(-0.9, 0.9, 0.85),
                                at(-0.9, 1.7, 0.55),
                                at(-0.1, 1.8, 0.65),
                                at(-0.1, 1.0, 0.95),
                                new Rgb(1, 0.5, 0.25),
                                false,
                                Emission.power(Rgb.gray(20)))));
        scenes.put(
                "point light",
                furnished().light(new Light.Point(at(0.1, 1.5, -0.4), Rgb.WHITE, Emission.intensity(WARM))));
        scenes.put(
                "point light behind a pane",
                room().light(new Light.Point(at(0.1, 1.7, 0.1), Rgb.WHITE, Emission.intensity(WARM)))
                        .object(
                                TestScenes.rectangle(-0.9, 1.3, -0.6, -0.9, 1.1, 0.9, 0.5, 1.1, 0.9, 0.5, 1.3, -0.6),
                                GLASS));
        scenes.put(
                "lights that hide each other",
                furnished().light(LAMP).light(panel(0.2, 1.1, -0.1, 0.4, new Rgb(0.5, 1, 2), true)));
        scenes.put(
                "lights of all kinds",
                furnished()
                        .light(sphereLight(-0.6, 1.5, 0.3, 0.2, 8))
                        .light(panel(0.3, 1.8, 0.2, 0.4, WARM, false))
                        .light(new Light.Point(at(0, 1.2, -0.7), Rgb.WHITE, Emission.intensity(Rgb.gray(0.5))))
                        .object(ball(0.8, 0.2, -0.7, 0.15), matte(0.5, 0.5, 0.5).withRadiance(Rgb.gray(4))));
        Scene.Builder many = furnished();
        for (int k = 0; k < 24; k++) {
            double angle = k * 2.399963;
            double r = 0.2 + 0.03 * k;
            many.light(sphereLight(r * Math.cos(angle), 1.3 + 0.025 * k, r * Math.sin(angle), 0.05, 6 + k));
        }
        scenes.put("many lights", many);
        scenes.put(
                "within a light",
                view(16, 16)
                        .object(BALL, PhysicalScenes.WHITE)
                        .object(BLOCK, MIRROR)
                        .light(sphereLight(0, 1, 0, 5, 0.5)));
    }

    private static void glowing(Map<String, Scene.Builder> scenes) {
        Material.Matte glow = matte(0.6, 0.3, 0.1).withRadiance(new Rgb(1, 2, 4));
        scenes.put("glowing ball", room().object(BALL, glow).object(BLOCK, PhysicalScenes.WHITE));
        scenes.put("glowing block", room().object(BALL, PhysicalScenes.WHITE).object(BLOCK, glow));
        scenes.put(
                "glowing disk and triangle",
                room().object(new Disk(at(-0.3, 1.3, 0.2), new Vec3(0.2, -1, 0.3), 0.4), glow)
                        .object(new Triangle(at(0.2, 0.1, 0.6), at(0.3, 1.1, 0.8), at(0.9, 0.2, 0.1)), glow)
                        .object(BALL, PhysicalScenes.WHITE));
        scenes.put(
                "glowing tubes",
                room().object(new Cylinder(at(-0.7, 1.6, 0.2), at(0.6, 1.5, 0), 0.15, true), glow)
                        .object(new Cylinder(at(0.5, 0.3, -0.2), at(0.6, 0.9, 0.2), 0.3, false), glow));
        scenes.put(
                "glowing mirror and metal",
                room().object(BALL, new Material.Mirror(linear(0.8, 0.8, 0.8), true, new Rgb(1, 2, 1)))
                        .object(BLOCK, new Glossy(WHITE, 0.6, Optional.of(COPPER), true, new Rgb(0.5, 0.2, 2))));
    }

    private static void surfaces(Map<String, Scene.Builder> scenes) {
        scenes.put("mirror", room().light(LAMP).object(BALL, MIRROR).object(BLOCK, PhysicalScenes.WHITE));
        scenes.put(
                "mirrors facing each other",
                room().light(CEILING)
                        .object(BLOCK, MIRROR)
                        .object(BALL, MIRROR)
                        .object(
                                TestScenes.rectangle(-0.9, 0.1, -0.9, -0.9, 1.9, -0.9, -0.9, 1.9, 0.9, -0.9, 0.1, 0.9),
                                MIRROR));
        scenes.put(
                "rough matte",
                room().light(LAMP)
                        .object(BALL, matte(0.8, 0.5, 0.3).withRoughness(1))
                        .object(BLOCK, matte(0.8, 0.5, 0.9).withRoughness(0.5)));
        scenes.put(
                "metals",
                room().light(CEILING)
                        .object(BALL, Glossy.metal(linear(1, 0.9, 0.8), COPPER, 0.5))
                        .object(BLOCK, Glossy.of(linear(0.9, 0.6, 0.3), 0.8)));
        scenes.put(
                "coated",
                room().light(CEILING)
                        .object(BALL, new Coated(linear(0.9, 0.5, 0.1), 0, 1.9, true, Rgb.BLACK, 0))
                        .object(BLOCK, Coated.of(linear(0.2, 0.9, 0.6), 0.5)));
        scenes.put(
                "principled",
                room().light(CEILING)
                        .object(
                                BALL,
                                new Principled(
                                        linear(0.9, 0.5, 0.1),
                                        Texture.Amount.of(0.5),
                                        Texture.Amount.of(0.6),
                                        2,
                                        0.5,
                                        new Principled.Clearcoat(0.8, Texture.Amount.of(0.5)),
                                        new Principled.Sheen(1, 0.5),
                                        Rgb.BLACK,
                                        0))
                        .object(
                                BLOCK,
                                Principled.of(linear(0.2, 0.9, 0.6), 0.3, 0).withClearcoat(0.5, 0)));
        scenes.put(
                "walls of plastic and metal",
                room(
                                Principled.of(linear(0.7, 0.8, 0.6), 0.4, 0),
                                Glossy.metal(linear(1, 0.9, 0.8), COPPER, 0.5),
                                Principled.of(linear(0.2, 0.9, 0.6), 0.5, 0.5))
                        .light(panel(-0.2, 0.4, 0.6, 0.3, WARM, false))
                        .object(BALL, Coated.of(linear(0.2, 0.4, 0.9), 0.5))
                        .object(BLOCK, Glossy.of(linear(0.9, 0.6, 0.3), 0.8)));
        Texture shares = new Texture.Checker(List.of(Rgb.gray(0.375), new Rgb(1, 0.75, 0.5)), 3);
        scenes.put(
                "checkered roughness",
                room().light(LAMP)
                        .object(
                                BALL,
                                Principled.of(linear(0.9, 0.6, 0.3), 0, 0)
                                        .withRoughness(
                                                new Texture.Amount.Textured(shares, Texture.Amount.Channel.RED, 0.75))
                                        .withMetallic(Texture.Amount.of(shares)))
                        .object(
                                TestScenes.rectangle(0.2, 0.1, -0.3, 0.2, 1, -0.1, 0.9, 1, 0.2, 0.9, 0.1, 0),
                                Glossy.of(linear(0.9, 0.9, 0.9), 0)
                                        .withRoughness(
                                                new Texture.Amount.Textured(shares, Texture.Amount.Channel.GREEN, 1))));
        scenes.put(
                "coated, mirror and glass",
                room().light(LAMP)
                        .object(BALL, Coated.of(linear(0.1, 0.5, 0.9), 0))
                        .object(BLOCK, new Coated(linear(0, 0.1, 0), 0, 3, false, Rgb.BLACK, 0))
                        .object(ball(-0.5, 1.4, -0.3, 0.25), MIRROR)
                        .object(ball(0.3, 1.2, -0.3, 0.25), GLASS));
        scenes.put(
                "metals that scatter once",
                room().light(LAMP)
                        .object(BALL, new Glossy(WHITE, 0.9, Optional.of(COPPER), false, Rgb.BLACK))
                        .object(BLOCK, new Glossy(linear(0.7, 0.8, 0.9), 0.4, Optional.empty(), false, Rgb.BLACK)));
        scenes.put(
                "checkered",
                view(16, 16)
                        .light(LAMP)
                        .object(
                                TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1),
                                Material.Matte.of(new Texture.Checker(
                                        List.of(DisplayRgb.of(0.9, 0.8, 0.7), new Rgb(0.05, 0.1, 0.2)), 5)))
                        .object(
                                BALL,
                                Material.Matte.of(new Texture.Checker(
                                        List.of(DisplayRgb.of(0.9, 0.8, 0.7), DisplayRgb.of(0.2, 0.3, 0.4)), 6))));
    }

    /** Glass of which a share is an opaque surface that is not matte. */
    private static void opaqueInPart(Map<String, Scene.Builder> scenes) {
        Texture tint = linear(0.9, 0.6, 0.5);
        Glass half = new Glass(tint, 1.5, 0.4, 0, true);
        scenes.put(
                "half of glass, half of metal or of lacquer",
                room().light(CEILING)
                        .object(BALL, half.withOpaque(Glossy.of(tint, 0.4)))
                        .object(BLOCK, half.withOpaque(Coated.of(linear(0.3, 0.6, 0.9), 0))));
        Principled plastic = Principled.of(linear(0.4, 0.7, 0.5), 0.25, 0.3).withClearcoat(0.6, 0.2);
        scenes.put(
                "half of rough glass, half of plastic",
                room().light(CEILING)
                        .object(
                                BALL,
                                half.withRoughness(0.5)
                                        .withMultipleScattering(false)
                                        .withOpaque(plastic))
                        .object(
                                TestScenes.rectangle(0.2, 0.1, -0.3, 0.2, 1, -0.1, 0.9, 1, 0.2, 0.9, 0.1, 0),
                                half.withOpaque(plastic)));
    }

    private static void glass(Map<String, Scene.Builder> scenes) {
        scenes.put("glass", room().light(CEILING).object(BALL, GLASS).object(BLOCK, PhysicalScenes.WHITE));
        scenes.put(
                "glass that absorbs",
                room().light(CEILING)
                        .object(BALL, Glass.of(WHITE, 1.3).withAbsorption(new Rgb(0.2, 1, 3)))
                        .object(BLOCK, Glass.of(WHITE, 1.7).withAbsorption(new Rgb(2, 0.5, 0))));
        Glass water = new Glass(linear(0.9, 0.95, 1), 1.33, 1, 0, true);
        Glass inner = new Glass(linear(1, 0.9, 0.9), 1.8, 1, 2, true);
        scenes.put(
                "nested glass",
                room().light(CEILING)
                        .object(ball(0, 0.8, -0.2, 0.7), water.withAbsorption(new Rgb(0.5, 0.1, 0)))
                        .object(ball(0.1, 0.7, -0.3, 0.3), inner.withAbsorption(new Rgb(0, 0.4, 1)))
                        .object(ball(-0.5, 1.1, -0.3, 0.35), new Glass(WHITE, 1, 1, 3, true))
                        .object(ball(0.4, 1.2, -0.1, 0.1), matte(0.7, 0.2, 0.2)));
        scenes.put(
                "equal glass",
                room().light(CEILING)
                        .object(ball(0, 0.8, -0.2, 0.6), Glass.of(linear(0.9, 0.8, 1), 1.4))
                        .object(ball(0.3, 0.9, -0.3, 0.5), Glass.of(linear(0.7, 1, 0.9), 1.4)));
        scenes.put(
                "half of glass",
                room().light(CEILING).object(BALL, new Glass(linear(0.9, 0.6, 0.5), 1.5, 0.4, 0, true)));
        opaqueInPart(scenes);
        scenes.put(
                "rough glass",
                room().light(CEILING)
                        .object(BALL, Glass.of(WHITE, 1.5).withRoughness(0.6).withMultipleScattering(false))
                        .object(
                                BLOCK,
                                Glass.of(linear(0.8, 1, 1), 1.3)
                                        .withRoughness(0.4)
                                        .withAbsorption(Rgb.gray(0.3))
                                        .withMultipleScattering(false)));
        Texture frost = new Texture.Checker(List.of(Rgb.BLACK, new Rgb(0.5, 0.75, 1)), 4);
        scenes.put(
                "checkered glass and clear coat",
                room().light(CEILING)
                        .object(
                                BALL,
                                Glass.of(linear(0.9, 1, 0.95), 1.5)
                                        .withRoughness(
                                                new Texture.Amount.Textured(frost, Texture.Amount.Channel.GREEN, 1)))
                        .object(
                                TestScenes.rectangle(0.2, 0.1, -0.3, 0.2, 1, -0.1, 0.9, 1, 0.2, 0.9, 0.1, 0),
                                Principled.of(linear(0.9, 0.6, 0.3), 0.5, 0)
                                        .withRoughness(Texture.Amount.of(frost))
                                        .withClearcoat(new Principled.Clearcoat(
                                                0.8,
                                                new Texture.Amount.Textured(
                                                        frost, Texture.Amount.Channel.RED, 0.75)))));
        scenes.put(
                "pane",
                furnished()
                        .light(CEILING)
                        .object(
                                TestScenes.rectangle(-0.6, 0.2, -0.9, -0.7, 1.7, -0.5, 0.6, 1.7, -0.8, 0.7, 0.2, -1.2),
                                Glass.of(linear(0.9, 0.7, 1), 1.5)));
        scenes.put(
                "pane over a lamp",
                furnished()
                        .light(sphereLight(0, 1.6, 0, 0.3, 6))
                        .object(new Disk(at(0, 1.2, 0), new Vec3(0.1, 1, 0), 0.5), GLASS));
        scenes.put("bulb", room().light(sphereLight(0, 1, 0, 0.3, 6)).object(ball(0.05, 1, 0, 0.5), GLASS));
        scenes.put("eye in glass", furnished().light(CEILING).object(ball(0, 1, -3.4, 0.4), Glass.of(WHITE, 1.5)));
        scenes.put(
                "eye in two solids",
                furnished()
                        .light(CEILING)
                        .object(ball(0, 1, -3.4, 0.4), water.withAbsorption(Rgb.gray(0.5)))
                        .object(ball(0.1, 1, -3.4, 0.6), inner));
    }

    private static void surroundings(Map<String, Scene.Builder> scenes) {
        Scene.Builder open = view(16, 16)
                .shading(shading(0.4))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), PhysicalScenes.RED)
                .object(BLOCK, Glossy.of(linear(0.9, 0.8, 0.7), 0.6));
        scenes.put("background", open);
        scenes.put(
                "background and lights",
                furnished().shading(shading(0.3)).light(LAMP).object(ball(0.3, 1.2, 0.2, 0.2), GLASS));
        scenes.put(
                "window",
                furnished()
                        .light(LAMP)
                        .camera(new Camera.Window(
                                at(0.1, 1.1, -3),
                                at(-0.9, 0, -0.95),
                                at(-0.9, 1.9, -0.9),
                                at(0.9, 1.9, -0.8),
                                at(0.9, 0, -0.85),
                                0)));
    }

    private static void limits(Map<String, Scene.Builder> scenes) {
        for (int most = 0; most <= 3; most++) {
            scenes.put(
                    "at most " + most,
                    furnished()
                            .light(LAMP)
                            .shading(atMost(most, 0.2))
                            .object(ball(0.3, 1.2, -0.3, 0.25), GLASS)
                            .object(ball(-0.5, 1.4, -0.3, 0.25), MIRROR));
        }
    }
}
