package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.importer.support.Affine;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;

/** Reads the emitters that are no shapes. */
final class EmitterReader {
    private final SceneIndex scene;
    private final Affine world;
    private final EmissionReader emissions;
    private final DirectedLights directed;

    /** Whether the scene has a background already: there can be one only. */
    private boolean hasBackground;

    EmitterReader(SceneIndex scene, Affine world) {
        this.scene = scene;
        this.world = world;
        emissions = new EmissionReader(scene);
        directed = new DirectedLights(scene, world);
    }

    /** Adds an emitter to the scene. */
    void add(XmlElement e) {
        Properties p = new Properties(e);
        p.ignore("sampling_weight", "id");
        switch (e.type()) {
            case "constant" -> background(e, new Shading.Background.Constant(emissions.light(p, "radiance", 1)));
            case "envmap" -> picture(p);
            case "sun", "sky", "sunsky" -> sky(p);
            case "point" -> point(p);
            case "spot" -> directed.spot(p);
            case "projector" -> directed.projector(p);
            case "directional" -> directional(p);
            default -> {
                scene.note(e, e.described() + " is left out: there is no such light here");
                scene.draft().leaveOutLight();
                return;
            }
        }
        scene.noteUnused(p);
    }

    private void background(XmlElement e, Shading.Background background) {
        if (hasBackground) {
            scene.note(e, e.described() + " is left out: another light comes from everywhere");
            return;
        }
        hasBackground = true;
        scene.draft().background(background);
    }

    private void picture(Properties p) {
        XmlElement e = p.element();
        Affine map = world.after(p.transform("to_world"));
        double scale = p.number("scale", 1);
        if (scale < 0) {
            throw e.failure("must have a scale that is not negative");
        }
        // Where the middle of the picture is.
        Vec3 middle = map.vector(Vec3.Z);
        double azimuth = StrictMath.toDegrees(StrictMath.atan2(middle.x(), middle.z()));
        try {
            Path file = scene.file(p.text("filename", ""));
            Texture.Encoding encoding =
                    TextureReader.isOfFloats(file) ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB;
            background(
                    e,
                    new Shading.Background.Picture(
                            new Texture.File(file, Texture.Filter.BILINEAR, encoding), Rgb.gray(scale), azimuth));
        } catch (IOException problem) {
            scene.note(e, "the picture around the scene is left out: " + problem.getMessage());
            scene.draft().leaveOutLight();
        }
    }

    private void sky(Properties p) {
        XmlElement e = p.element();
        Vec3 sun = p.point("sun_direction", new Vec3(0, 0, 0));
        p.ignore("sun_aperture", "complex_sun", "sun_radius_scale", "stretch", "resolution");
        if (sun.maxAbs() == 0) {
            scene.note(e, e.described() + " is left out: only one with sun_direction can be read");
            scene.draft().leaveOutLight();
            return;
        }
        Vec3 d = world.after(p.transform("to_world")).vector(sun).normalized();
        double elevation = StrictMath.toDegrees(StrictMath.asin(StrictMath.min(StrictMath.max(d.y(), 0), 1)));
        double azimuth = StrictMath.toDegrees(StrictMath.atan2(d.x(), d.z()));
        double turbidity = StrictMath.min(
                StrictMath.max(p.number("turbidity", 3), Shading.Background.Sky.LEAST_TURBIDITY),
                Shading.Background.Sky.GREATEST_TURBIDITY);
        double albedo = StrictMath.min(new TextureReader(scene).number(p, "albedo", 0.3), 1);
        double scale = StrictMath.max(p.number(e.type().equals("sun") ? "sun_scale" : "sky_scale", 1), 0);
        p.ignore("sun_scale", "sky_scale", "scale");
        scene.note(e, e.described() + " becomes a sky by another model: it is not of equal brightness");
        background(
                e,
                new Shading.Background.Sky(
                        elevation,
                        azimuth,
                        turbidity,
                        Rgb.gray(albedo),
                        Rgb.gray(scale),
                        !e.type().equals("sky")));
    }

    private void point(Properties p) {
        Affine map = world.after(p.transform("to_world"));
        Vec3 at = map.point(p.point("position", new Vec3(0, 0, 0)));
        Rgb intensity = emissions.light(p, "intensity", 1);
        scene.draft().light(new Light.Point(Affine.exact(at), Rgb.WHITE, Emission.intensity(intensity)));
    }

    /** A direction in which light travels, +z by itself; its disk is as wide as the sun's, not a point as in Mitsuba. */
    private void directional(Properties p) {
        Affine map = world.after(p.transform("to_world"));
        Vec3 direction = map.vector(p.point("direction", Vec3.Z));
        Rgb irradiance = emissions.light(p, "irradiance", 1);
        try {
            scene.draft().light(new Light.Distant(direction, irradiance));
        } catch (InvalidValueException problem) {
            throw p.element().failure(problem.getMessage());
        }
    }
}
