package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import java.util.ArrayList;
import java.util.List;

/** Reads the lights. */
final class Lights {
    private static final Fields.Family FAMILY =
            new Fields.Family("a light", Vocabulary.LIGHTS, List.of(), Vocabulary.PLANNED_LIGHT_KEYS);

    private Lights() {}

    /** The lights that have no problems. */
    static List<Light> read(JsonValue v, JsonPointer place, Values values) {
        List<Light> lights = new ArrayList<>();
        JsonValue.Arr a = values.array(v, place, -1, "an array of lights");
        for (int i = 0; a != null && i < a.size(); i++) {
            Fields f = Fields.of(a.get(i), place.child(i), FAMILY, null, values);
            Light light = f == null ? null : light(f);
            if (light != null) {
                lights.add(light);
            }
        }
        return lights;
    }

    private static Light light(Fields f) {
        DisplayRgb color = f.color("color", DisplayRgb.WHITE);
        switch (f.type(null)) {
            case "sphere": {
                ExactPoint center = f.point("center");
                double radius = f.number("radius");
                return f.make(() -> new Light.Sphere(center, radius, color));
            }
            case "rectangle": {
                List<ExactPoint> c = f.points("corners", 4, SceneObjects.CORNERS);
                return f.make(() -> new Light.Rectangle(c.get(0), c.get(1), c.get(2), c.get(3), color));
            }
            default: {
                ExactPoint position = f.point("position");
                return f.make(() -> new Light.Point(position, color));
            }
        }
    }
}
