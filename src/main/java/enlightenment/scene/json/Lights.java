package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import java.util.ArrayList;
import java.util.List;

/** The lights. */
final class Lights {
    static final Family<Light> FAMILY = new Family<Light>(
                    "light", "a light", null, List.of(), Vocabulary.PLANNED_LIGHT_KEYS, Lights::read, Lights::write)
            .with("sphere", Light.Sphere.class, "center radius color |")
            .with("rectangle", Light.Rectangle.class, "corners color |")
            .with("point", Light.Point.class, "position color |");

    private Lights() {}

    private static Light read(String type, Fields f) {
        return switch (type) {
            case "sphere" -> sphere(f);
            case "rectangle" -> rectangle(f);
            case "point" -> point(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Light value, JsonObjectBuilder p) {
        if (value instanceof Light.Sphere s) {
            p.point("center", s.center()).number("radius", s.radius()).color("color", s.color());
        } else if (value instanceof Light.Rectangle r) {
            p.points("corners", r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight())
                    .color("color", r.color());
        } else if (value instanceof Light.Point q) {
            p.point("position", q.position()).color("color", q.color());
        } else {
            throw Family.unknown(value);
        }
    }

    /** The lights that have no problems. */
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
        DisplayRgb color = color(f);
        return f.make(() -> new Light.Sphere(center, radius, color));
    }

    private static Light rectangle(Fields f) {
        List<ExactPoint> c = f.points("corners", 4, Shapes.CORNERS);
        DisplayRgb color = color(f);
        return f.make(() -> new Light.Rectangle(c.get(0), c.get(1), c.get(2), c.get(3), color));
    }

    private static Light point(Fields f) {
        ExactPoint position = f.point("position");
        DisplayRgb color = color(f);
        return f.make(() -> new Light.Point(position, color));
    }

    private static DisplayRgb color(Fields f) {
        return f.color("color", DisplayRgb.WHITE);
    }
}
