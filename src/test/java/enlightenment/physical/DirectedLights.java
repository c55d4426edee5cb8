package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.room;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/** Scenes with points that shine into some directions. */
final class DirectedLights {
    static final List<BuiltInMethod> METHODS = List.of(
            BuiltInMethod.RAYTRACE,
            BuiltInMethod.CLUSTER,
            BuiltInMethod.LIGHT,
            BuiltInMethod.BIDIRECTIONAL,
            BuiltInMethod.METROPOLIS);

    static final double[] POWER = {5, 3, 2};

    private static final Emission WATTS = Emission.power(new Rgb(POWER[0], POWER[1], POWER[2]));

    /** Wide, with a waist, dark above; the same to the left and to the right. */
    private static final Path LAMP = lamp();

    private static final Path PICTURE = picture();

    private DirectedLights() {}

    private static Light projector(ExactPoint at, Vec3 direction, double fieldOfView, Emission emission) {
        Texture.File picture = new Texture.File(PICTURE, Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
        return new Light.Projector(at, picture, direction, Vec3.Z, fieldOfView, Rgb.WHITE, emission);
    }

    /** Grey, so that power is that of each band. */
    private static Path picture() {
        try {
            Path file = Files.createTempFile("picture", ".png");
            file.toFile().deleteOnExit();
            float[] grey = {1, 0, 0.4f, 0.8f, 0, 0, 1, 0.1f, 0.5f, 1, 0, 0.2f};
            float[] rgb = new float[3 * grey.length];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = grey[i / 3];
            }
            ImageFiles.writePng(new Image(4, 3, rgb), file);
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Path lamp() {
        String text =
                """
                IESNA:LM-63-1995
                TILT=NONE
                1 -1 2 5 3 1 2 0 0 0
                1 1 40
                0 20 40 60 80
                0 90 180
                90 80 40 20 0
                90 20 70 30 0
                90 60 10 0 0
                """;
        try {
            Path file = Files.createTempFile("lamp", ".ies");
            file.toFile().deleteOnExit();
            return Files.writeString(file, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Lights in the middle of a ball of radius 1, of that power, which leave what is above dark. */
    static Map<String, Light> down() {
        Map<String, Light> lights = new LinkedHashMap<>();
        lights.put("spot", new Light.Spot(at(0.1, 0, 0.05), new Vec3(0, -2, 0.1), 60, 30, Rgb.WHITE, WATTS));
        lights.put("ies", new Light.Ies(at(0.1, 0, 0.05), LAMP, new Vec3(0.1, -1, 0), 40, Rgb.WHITE, WATTS));
        lights.put("projector", projector(at(0.1, 0, 0.05), new Vec3(0.1, -1, 0), 80, WATTS));
        return lights;
    }

    static Map<String, Scene> scenes() {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        scenes.put(
                "spot in a room",
                furnished()
                        .light(new Light.Spot(at(0.2, 1.8, -0.3), new Vec3(-0.3, -1, 0.2), 35, 10, Rgb.WHITE, WATTS))
                        .build());
        scenes.put(
                "spot on mirror and glass",
                specular()
                        .light(new Light.Spot(at(0.1, 1.9, -0.4), new Vec3(0, -1, 0.2), 50, 40, Rgb.WHITE, WATTS))
                        .light(new Light.Spot(at(-0.9, 1.5, 0), new Vec3(1, -1, -0.1), 8, 2, Rgb.WHITE, WATTS))
                        .build());
        scenes.put(
                "spot in fog",
                foggy().light(new Light.Spot(at(0.1, 1.5, -0.4), new Vec3(-0.2, -1, 0.3), 30, 15, Rgb.WHITE, WATTS))
                        .build());
        scenes.put(
                "luminaires in a room",
                furnished()
                        .light(new Light.Ies(at(0.2, 1.8, -0.3), LAMP, new Vec3(-0.3, -1, 0.2), 15, Rgb.WHITE, WATTS))
                        .light(new Light.Ies(
                                at(-0.7, 0.2, 0.3),
                                LAMP,
                                new Vec3(0, 1, 0),
                                0,
                                new Rgb(1, 0.5, 0.2),
                                Emission.intensity(Rgb.gray(0.01))))
                        .build());
        scenes.put(
                "luminaire on mirror and glass",
                specular()
                        .light(new Light.Ies(at(0.1, 1.9, -0.4), LAMP, new Vec3(0, -1, 0.2), 70, Rgb.WHITE, WATTS))
                        .build());
        scenes.put(
                "luminaire in fog",
                foggy().light(new Light.Ies(at(0.1, 1.5, -0.4), LAMP, new Vec3(-0.2, -1, 0.3), 0, Rgb.WHITE, WATTS))
                        .build());
        scenes.put(
                "projector in a room",
                furnished()
                        .light(projector(at(0.2, 1.7, -0.9), new Vec3(-0.2, -0.7, 1), 60, WATTS))
                        .build());
        scenes.put(
                "projector on mirror and glass",
                specular()
                        .light(projector(at(0.1, 1.9, -0.4), new Vec3(0, -1, 0.2), 90, WATTS))
                        .build());
        scenes.put(
                "projector in fog",
                foggy().light(projector(at(0.1, 1.5, -0.4), new Vec3(-0.2, -1, 0.3), 50, WATTS))
                        .build());
        Scene.Builder many = furnished();
        for (int k = 0; k < 24; k++) {
            many.light(new Light.Spot(
                    at(0.8 * Math.sin(k), 1.9, 0.8 * Math.cos(k)),
                    new Vec3(Math.sin(3 * k), -1, Math.cos(5 * k)),
                    15 + 5 * (k % 9),
                    5,
                    Rgb.WHITE,
                    Emission.intensity(Rgb.gray(1 + k % 3))));
        }
        scenes.put("many spots", many.build());
        return scenes;
    }

    private static Scene.Builder specular() {
        return room().object(ball(-0.4, 0.5, 0.1, 0.35), Material.Mirror.of(linear(0.9, 0.9, 0.9)))
                .object(ball(0.4, 0.5, -0.2, 0.35), Glass.of(linear(1, 1, 1), 1.5));
    }

    private static Scene.Builder foggy() {
        return furnished()
                .shading(MediaScenes.in(MediaScenes.medium(Rgb.gray(0.4), Rgb.gray(0.05), 0.3), OptionalInt.of(6), 0));
    }

    private static Scene.Builder furnished() {
        return room().object(ball(-0.35, 0.45, -0.1, 0.42), PhysicalScenes.WHITE)
                .object(new Box(at(0.15, 0.02, -0.6), at(0.7, 0.8, 0.1)), PhysicalScenes.GREEN);
    }
}
