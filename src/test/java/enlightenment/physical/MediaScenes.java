package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static enlightenment.physical.PhysicalScenes.view;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Partner scenes with media that scatter light. */
final class MediaScenes {
    private static final Rgb WARM = new Rgb(5, 4, 2);
    private static final Light CEILING = panel(0.05, 1.9, 0, 0.6, WARM, false);
    private static final Light LAMP = sphereLight(0.2, 1.5, -0.1, 0.3, 6);
    private static final Light POINT = new Light.Point(at(0.1, 1.5, -0.4), Rgb.WHITE, Emission.intensity(WARM));
    private static final Medium WAX = medium(new Rgb(6, 5, 3), new Rgb(0.06, 0.2, 0.6), 0.3);
    private static final Medium MILK = medium(new Rgb(8, 7, 6), new Rgb(0.1, 0.2, 0.8), 0.5);
    private static final Medium FOG = medium(new Rgb(0.4, 0.3, 0.2), new Rgb(0.05, 0.05, 0.1), 0.5);
    private static final Medium GREY_FOG = medium(Rgb.gray(0.3), Rgb.gray(0.05), -0.3);
    private static final Material GLASS = Glass.of(linear(0.95, 1, 0.9), 1.5);
    private static final Material MIRROR = Material.Mirror.of(linear(0.95, 0.9, 0.85));

    private MediaScenes() {}

    static Medium medium(Rgb scattering, Rgb absorption, double anisotropy) {
        return new Medium.Coefficients(scattering, absorption, anisotropy);
    }

    static Shading.Physical in(Medium medium, OptionalInt maxBounces, double background) {
        return new Shading.Physical(
                maxBounces, new Shading.Background.Constant(Rgb.gray(background)), Optional.of(medium));
    }

    private static Scene.Builder foggy(Medium medium) {
        return room().shading(in(medium, OptionalInt.empty(), 0.5));
    }

    static void addTo(Map<String, Scene.Builder> scenes) {
        solids(scenes);
        fog(scenes);
        scenes.put(
                "milk in glass",
                room().light(CEILING)
                        .object(ball(0, 0.7, -0.1, 0.6), GLASS)
                        .object(ball(0.02, 0.7, -0.1, 0.5), new Material.Scattering(MILK, 1.33, 0, 1)));
        scenes.put(
                "milk between panes of air",
                room().light(CEILING)
                        .object(
                                new Box(at(-0.7, 0.1, -0.4), at(0.6, 1.1, 0.5)),
                                new Material.Scattering(MILK, 1.33, 0, 0))
                        .object(ball(-0.1, 0.6, -0.2, 0.3), new Material.Scattering(FOG, 1, 0, 1)));
        scenes.put(
                "clouds that overlap",
                view(16, 16)
                        .shading(PhysicalScenes.shading(0.4))
                        .light(LAMP)
                        .light(POINT)
                        .object(ball(-0.2, 0.9, 0, 0.6), Material.Scattering.of(WAX))
                        .object(ball(0.3, 1.1, -0.2, 0.6), new Material.Scattering(FOG, 1, 0, 2))
                        .object(ball(0.1, 0.4, 0.1, 0.4), PhysicalScenes.GREEN));
    }

    private static void solids(Map<String, Scene.Builder> scenes) {
        scenes.put(
                "ball of wax",
                room().light(LAMP)
                        .light(CEILING)
                        .object(ball(-0.35, 0.5, -0.1, 0.45), Material.Scattering.of(WAX))
                        .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), Material.Scattering.of(MILK)));
        scenes.put(
                "rough jade",
                room().light(LAMP).object(ball(0, 0.7, -0.1, 0.6), new Material.Scattering(WAX, 1.4, 0.5, 0)));
        scenes.put(
                "lamp in milk",
                room().object(ball(0.2, 1.3, -0.1, 0.5), new Material.Scattering(WAX, 1.3, 0, 0))
                        .light(sphereLight(0.2, 1.3, -0.1, 0.25, 9)));
        scenes.put(
                "lamp in a cloud",
                room().object(ball(0.2, 1.3, -0.1, 0.5), Material.Scattering.of(WAX))
                        .light(sphereLight(0.2, 1.3, -0.1, 0.25, 9))
                        .light(POINT));
    }

    private static void fog(Map<String, Scene.Builder> scenes) {
        scenes.put("fog", foggy(FOG).light(LAMP).object(ball(-0.35, 0.45, -0.1, 0.42), PhysicalScenes.WHITE));
        scenes.put(
                "fog with a mirror and glass",
                foggy(GREY_FOG)
                        .light(LAMP)
                        .light(panel(-0.5, 1.9, 0.2, 0.4, WARM, false))
                        .object(ball(-0.45, 0.45, 0.1, 0.42), MIRROR)
                        .object(ball(0.45, 0.4, -0.3, 0.38), GLASS));
        scenes.put(
                "at most 2 in fog",
                room().shading(in(FOG, OptionalInt.of(2), 0.5))
                        .light(CEILING)
                        .object(ball(-0.35, 0.45, -0.1, 0.42), Material.Scattering.of(WAX)));
        scenes.put(
                "fog that only absorbs",
                view(16, 16)
                        .shading(in(medium(Rgb.BLACK, new Rgb(0.3, 0, 0.2), 0), OptionalInt.empty(), 0.5))
                        .light(LAMP)
                        .object(ball(-0.35, 0.45, -0.1, 0.42), PhysicalScenes.WHITE));
    }
}
