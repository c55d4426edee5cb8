package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static enlightenment.physical.PhysicalScenes.view;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.Scene;
import java.util.Map;

/** Scenes in which lights, media and surfaces touch each other or lie within each other. */
final class MeetingScenes {
    private static final Rgb WARM = new Rgb(5, 4, 2);
    private static final Glass WATER = new Glass(linear(1, 1, 1), 1.33, 1, 0, true);

    private MeetingScenes() {}

    static void addTo(Map<String, Scene.Builder> scenes) {
        touching(scenes);
        within(scenes);
    }

    private static Scene.Builder furnished() {
        return room().object(ball(-0.35, 0.45, -0.1, 0.42), PhysicalScenes.WHITE)
                .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), PhysicalScenes.GREEN);
    }

    private static void touching(Map<String, Scene.Builder> scenes) {
        scenes.put("sphere light on the floor", furnished().light(sphereLight(-0.5, 0.25, -0.75, 0.25, 6)));
        scenes.put(
                "lights that cut each other",
                furnished().light(sphereLight(0.1, 1.5, 0, 0.3, 4)).light(panel(0.2, 1.55, -0.1, 0.4, WARM, true)));
        scenes.put(
                "light that cuts a block",
                furnished()
                        .light(sphereLight(0.2, 0.8, -0.2, 0.35, 4))
                        .light(new Light.Rectangle(
                                at(-0.8, 0.2, -0.5),
                                at(-0.8, 1.2, -0.5),
                                at(0.1, 1.2, 0.2),
                                at(0.1, 0.2, 0.2),
                                Rgb.WHITE,
                                true,
                                Emission.radiance(WARM))));
        scenes.put(
                "glowing wall",
                view(16, 16)
                        .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), PhysicalScenes.WHITE)
                        .object(TestScenes.rectangle(-1, 2, -1, -1, 2, 1, 1, 2, 1, 1, 2, -1), PhysicalScenes.RED)
                        .object(
                                TestScenes.rectangle(-1, 0, 1, -1, 2, 1, 1, 2, 1, 1, 0, 1),
                                matte(0.5, 0.5, 0.5).withRadiance(new Rgb(1, 0.8, 0.6)))
                        .object(
                                TestScenes.rectangle(-1, 0, -1, -1, 2, -1, -1, 2, 1, -1, 0, 1),
                                matte(0.7, 0.7, 0.2).withRoughness(0.9))
                        .object(
                                TestScenes.rectangle(1, 0, -1, 1, 2, -1, 1, 2, 1, 1, 0, 1),
                                Glossy.of(linear(0.9, 0.6, 0.3), 0.6)));
        scenes.put(
                "glass on the floor",
                furnished()
                        .light(panel(0.05, 1.9, 0, 0.6, WARM, false))
                        .object(ball(0.3, 0.2, -0.85, 0.2), Glass.of(linear(0.9, 1, 1), 1.5))
                        .object(ball(-0.5, 1.0, -0.3, 0.3), WATER));
        scenes.put(
                "light half in glass",
                room().light(sphereLight(0, 1.2, 0, 0.35, 4))
                        .object(ball(0.1, 0.8, -0.1, 0.5), Glass.of(linear(1, 0.9, 0.8), 1.5)));
    }

    private static void within(Map<String, Scene.Builder> scenes) {
        scenes.put(
                "under water",
                furnished()
                        .light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                        .object(ball(0, 1, -1, 6), WATER.withAbsorption(new Rgb(0.3, 0.1, 0.05))));
        scenes.put(
                "under water by a panel",
                room().light(panel(0.05, 1.9, 0, 0.6, WARM, false))
                        .object(new Box(at(-7, -7, -8), at(7, 8, 6)), WATER.withAbsorption(new Rgb(0.3, 0.1, 0.05)))
                        .object(ball(-0.35, 0.45, -0.1, 0.42), Glossy.of(linear(0.9, 0.8, 0.7), 0.7)));
        scenes.put(
                "under water by a point",
                furnished()
                        .light(new Light.Point(at(0.1, 1.5, -0.4), Rgb.WHITE, Emission.intensity(WARM)))
                        .object(ball(0, 1, -1, 6), WATER.withAbsorption(new Rgb(0.3, 0.1, 0.05))));
        scenes.put(
                "mist",
                furnished()
                        .light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                        .object(
                                ball(0.1, 0.8, -0.2, 0.9),
                                new Glass(linear(1, 1, 1), 1, 1, 0, true).withAbsorption(new Rgb(0.5, 1, 0.1))));
        scenes.put(
                "matte in glass",
                room().light(panel(0.05, 1.9, 0, 0.6, WARM, false))
                        .object(ball(0, 0.8, -0.2, 0.6), Glass.of(linear(1, 0.9, 0.8), 1.4))
                        .object(ball(-0.1, 0.8, -0.2, 0.35), matte(0.8, 0.6, 0.3)));
        scenes.put(
                "lamp and matte in glass",
                room().light(sphereLight(0.25, 1.0, -0.2, 0.2, 8))
                        .object(
                                ball(0, 0.8, -0.2, 0.7),
                                Glass.of(linear(1, 0.9, 0.8), 1.4).withAbsorption(new Rgb(0.2, 0.5, 1)))
                        .object(ball(-0.2, 0.8, -0.2, 0.3), matte(0.8, 0.6, 0.3)));
        scenes.put(
                "pane within water",
                room().light(panel(0.05, 1.9, 0, 0.6, WARM, false))
                        .object(new Box(at(-0.8, 0.1, -0.7), at(0.8, 1.5, 0.4)), WATER)
                        .object(
                                TestScenes.rectangle(-0.6, 0.3, -0.5, -0.6, 1.3, -0.2, 0.6, 1.3, -0.2, 0.6, 0.3, -0.5),
                                Glass.of(linear(0.9, 0.7, 1), 1.9)));
        scenes.put(
                "eye near a lamp",
                furnished()
                        .light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                        .camera(new Camera.Perspective(at(-0.9, 1.5, -0.9), at(0.3, 0.8, 0.2), Vec3.Y, 90)));
    }
}
