package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.file.FileFailure;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.photometry.IesFile;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Reads and writes the lights. */
final class Lights {
    private static final String NOT_OF_DISTANT = "belongs to other lights; a distant light has \"irradiance\"";

    static final Family<Light> FAMILY = new Family<Light>(
                    "light", "a light", null, Map.of(), Lights::read, Lights::write)
            .with(
                    "sphere",
                    Light.Sphere.class,
                    "center radius color | radiance power ultraviolet",
                    notOfSurfaces("sphere"))
            .with(
                    "rectangle",
                    Light.Rectangle.class,
                    "corners color | twoSided radiance power ultraviolet",
                    notOfSurfaces("rectangle"))
            .with("point", Light.Point.class, "position color | intensity power ultraviolet", notOfPoints("point"))
            .with(
                    "spot",
                    Light.Spot.class,
                    "position direction angle color | innerAngle intensity power ultraviolet",
                    notOfPoints("spot"))
            .with(
                    "projector",
                    Light.Projector.class,
                    "position texture direction fieldOfView color | up intensity power ultraviolet",
                    notOfPoints("projector"))
            .with(
                    "ies",
                    Light.Ies.class,
                    "position file color | direction rotation intensity power ultraviolet",
                    notOfPoints("ies"))
            .with(
                    "distant",
                    Light.Distant.class,
                    "direction | color angle irradiance",
                    Map.of(
                            "radiance", NOT_OF_DISTANT,
                            "intensity", NOT_OF_DISTANT,
                            "power", NOT_OF_DISTANT));

    /** The default direction of lights. */
    private static final Vec3 DOWN = Vec3.of(0, -1, 0);

    private Lights() {}

    private static Map<String, String> notOfSurfaces(String type) {
        return Map.of("intensity", "belongs to point lights; a " + type + " light has \"radiance\" or \"power\"");
    }

    private static Map<String, String> notOfPoints(String type) {
        return Map.of(
                "radiance", "belongs to lights with a surface; a " + type + " light has \"intensity\" or \"power\"");
    }

    /** The emission with its ultraviolet part; null if the record refuses that. */
    private static Emission emission(Fields f, Emission unlessGiven) {
        Emission visible = visible(f, unlessGiven);
        double ultraviolet = f.number("ultraviolet", 0);
        return f.make(() -> visible.withUltraviolet(ultraviolet));
    }

    /** The visible emission: in the usual quantity of the light, or as power; both are a problem. */
    private static Emission visible(Fields f, Emission unlessGiven) {
        String usual = unlessGiven.quantity().key();
        if (!f.has("power")) {
            return f.has(usual) ? new Emission(unlessGiven.quantity(), f.bands(usual, Rgb.WHITE)) : unlessGiven;
        }
        if (f.has(usual)) {
            f.problem("power", "stands beside \"" + usual + "\"; a light has one of the two");
        }
        return Emission.power(f.bands("power", Rgb.WHITE));
    }

    private static void write(Emission emission, Emission usual, JsonObjectBuilder p) {
        String key = emission.quantity().key();
        if (emission.quantity() != usual.quantity() || !emission.value().equals(usual.value()) || p.animated(key)) {
            p.bands(key, emission.value());
        }
        p.numberUnless(0, "ultraviolet", emission.ultraviolet());
    }

    private static Light read(String type, Fields f) {
        return switch (type) {
            case "sphere" -> sphere(f);
            case "rectangle" -> rectangle(f);
            case "point" -> point(f);
            case "spot" -> spot(f);
            case "projector" -> projector(f);
            case "ies" -> ies(f);
            case "distant" -> distant(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Light value, JsonObjectBuilder p) {
        if (value instanceof Light.Sphere s) {
            p.point("center", s.center()).number("radius", s.radius()).color("color", s.color());
            write(s.emission(), Emission.RADIANCE_1, p);
        } else if (value instanceof Light.Rectangle r) {
            p.points("corners", r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight())
                    .color("color", r.color())
                    .flagUnless(true, "twoSided", r.twoSided());
            write(r.emission(), Emission.RADIANCE_1, p);
        } else if (value instanceof Light.Point q) {
            p.point("position", q.position()).color("color", q.color());
            write(q.emission(), Emission.INTENSITY_1, p);
        } else if (value instanceof Light.Spot q) {
            p.point("position", q.position())
                    .vector("direction", q.direction())
                    .number("angle", q.angle())
                    .numberUnless(0, "innerAngle", q.innerAngle())
                    .color("color", q.color());
            write(q.emission(), Emission.INTENSITY_1, p);
        } else if (value instanceof Light.Projector q) {
            p.point("position", q.position())
                    .textureName("texture", q.picture())
                    .vector("direction", q.direction())
                    .vectorUnless(Vec3.Y, "up", q.up())
                    .number("fieldOfView", q.fieldOfView())
                    .color("color", q.color());
            write(q.emission(), Emission.INTENSITY_1, p);
        } else if (value instanceof Light.Ies q) {
            p.point("position", q.position())
                    .file("file", q.file())
                    .vectorUnless(DOWN, "direction", q.direction())
                    .numberUnless(0, "rotation", q.rotation())
                    .color("color", q.color());
            write(q.emission(), Emission.INTENSITY_1, p);
        } else if (value instanceof Light.Distant q) {
            p.vector("direction", q.direction())
                    .colorUnless(DisplayRgb.WHITE, "color", q.color())
                    .numberUnless(Light.Distant.USUAL_ANGLE, "angle", q.angle());
            write(q.emission(), Emission.IRRADIANCE_1, p);
        } else {
            throw Family.unknown(value);
        }
    }

    /** The lights without problems; the problems of the others are reported. */
    static List<Light> read(JsonValue v, JsonPointer place, Values values) {
        List<Light> lights = new ArrayList<>();
        JsonValue.Arr a = values.array(v, place, -1, "an array of lights");
        for (int i = 0; a != null && i < a.size(); i++) {
            Fields f = Fields.of(a.get(i), place.child(i), FAMILY, values);
            Light light = f == null ? null : FAMILY.read(f);
            if (light != null) {
                lights.add(light);
            }
        }
        return lights;
    }

    private static Light sphere(Fields f) {
        ExactPoint center = f.point("center");
        double radius = f.number("radius");
        Color color = color(f);
        Emission emission = emission(f, Emission.RADIANCE_1);
        return f.make(() -> new Light.Sphere(center, radius, color, emission));
    }

    private static Light rectangle(Fields f) {
        List<ExactPoint> c = f.points("corners", 4, Shapes.CORNERS);
        Color color = color(f);
        boolean twoSided = f.flag("twoSided", true);
        Emission emission = emission(f, Emission.RADIANCE_1);
        return f.make(() -> new Light.Rectangle(c.get(0), c.get(1), c.get(2), c.get(3), color, twoSided, emission));
    }

    private static Light point(Fields f) {
        ExactPoint position = f.point("position");
        Color color = color(f);
        Emission emission = emission(f, Emission.INTENSITY_1);
        return f.make(() -> new Light.Point(position, color, emission));
    }

    private static Light spot(Fields f) {
        ExactPoint position = f.point("position");
        Vec3 direction = f.direction("direction", DOWN);
        double angle = f.number("angle");
        double innerAngle = f.number("innerAngle", 0);
        Color color = color(f);
        Emission emission = emission(f, Emission.INTENSITY_1);
        return f.make(() -> new Light.Spot(position, direction, angle, innerAngle, color, emission));
    }

    private static Light projector(Fields f) {
        ExactPoint position = f.point("position");
        Texture texture = f.has("texture") ? Textures.ofSurface(f) : null;
        Vec3 direction = f.direction("direction", DOWN);
        Vec3 up = f.direction("up", Vec3.Y);
        double fieldOfView = f.number("fieldOfView");
        Color color = color(f);
        Emission emission = emission(f, Emission.INTENSITY_1);
        if (texture != null && !(texture instanceof Texture.File)) {
            f.problem("texture", "must name an image file: projectors have no other textures");
        }
        return texture instanceof Texture.File picture
                ? f.make(() -> new Light.Projector(position, picture, direction, up, fieldOfView, color, emission))
                : null;
    }

    private static Light ies(Fields f) {
        ExactPoint position = f.point("position");
        String written = f.text("file", "the path of an IES file");
        Path file = written == null ? null : Meshes.path(f, written);
        if (file != null) {
            checkTable(f, file, written);
        }
        Vec3 direction = f.direction("direction", DOWN);
        double rotation = f.number("rotation", 0);
        Color color = color(f);
        Emission emission = emission(f, Emission.INTENSITY_1);
        return f.make(() -> new Light.Ies(position, file, direction, rotation, color, emission));
    }

    private static Light distant(Fields f) {
        Vec3 direction = f.direction("direction", DOWN);
        double angle = f.number("angle", Light.Distant.USUAL_ANGLE);
        Color color = color(f);
        Emission emission = new Emission(Emission.Quantity.IRRADIANCE, f.bands("irradiance", Rgb.WHITE));
        return f.make(() -> new Light.Distant(direction, angle, color, emission));
    }

    private static void checkTable(Fields f, Path file, String written) {
        Map<String, byte[]> contents = f.values().library().contents;
        try {
            if (contents == null) {
                IesFile.read(file);
            } else {
                IesFile.of(contents.get(written));
            }
        } catch (IOException e) {
            f.problem("file", FileFailure.described(e));
        }
    }

    private static Color color(Fields f) {
        return f.color("color", DisplayRgb.WHITE);
    }
}
