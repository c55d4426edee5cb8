package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.light.Light;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.math.Point;

/** Reads a light. */
final class LightBinder {
    private static final String[] PHYSICAL = {"radiance", "power", "intensity"};

    private LightBinder() {}

    /** The light, or null after a problem. */
    static Light read(Fields f, Problems problems) {
        String type = f.requiredWord("type", "a type of light", "sphere", "rectangle", "point");
        if (type == null) {
            return null;
        }
        for (String key : PHYSICAL) {
            if (f.has(key)) {
                int i = f.object.indexOf(key);
                problems.atKey(f.object, i, "\"" + key + "\" of a light is not available yet; expected \"color\" only");
            }
        }
        DisplayRgb color = f.color("color");
        try {
            switch (type) {
                case "sphere":
                    only(f, "a sphere light", "center", "radius");
                    Point center = f.point("center");
                    double radius = f.number("radius");
                    return f.sound() ? new Light.Sphere(center, radius, color) : null;
                case "rectangle":
                    only(f, "a rectangle light", "corners");
                    Point[] c = f.points("corners", 4, ShapeBinder.CORNERS);
                    return f.sound() ? new Light.Rectangle(c[0], c[1], c[2], c[3], color) : null;
                default:
                    only(f, "a point light", "position");
                    Point position = f.point("position");
                    return f.sound() ? new Light.Point(position, color) : null;
            }
        } catch (InvalidValueException e) {
            f.refuse(e);
            return null;
        }
    }

    private static void only(Fields f, String what, String... own) {
        int n = own.length;
        String[] keys = java.util.Arrays.copyOf(own, n + 2);
        keys[n] = "type";
        keys[n + 1] = "color";
        f.onlyExcept(PHYSICAL, what, keys);
    }
}
