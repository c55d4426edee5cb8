package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.scene.ClassicShading;
import enlightenment.scene.PhysicalShading;
import enlightenment.scene.Shading;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/** Reads and writes the shading part; its key {@code "model"} says which other keys it has. */
final class Shadings {
    /** Keys of classic shading that somebody may expect in physical shading, and why they are not there. */
    private static final Map<String, String> ONLY_CLASSIC = Map.of(
            "ambient",
            "belongs to classic shading: in physical shading all light comes from the lights and the background",
            "shadow",
            "belongs to classic shading: in physical shading nothing of a hidden light arrives");

    private static final String LIGHT = Values.COLOR
            + ", [r, g, b] with components in 0..1, or { \"linear\": [r, g, b] } with components of at least 0";

    private Shadings() {}

    /** The names of all models. */
    static List<String> models() {
        return List.of(Shading.Model.CLASSIC.word(), Shading.Model.PHYSICAL.word());
    }

    /** Null after a problem. */
    static Shading read(JsonValue v, JsonPointer place, Values values) {
        return v instanceof JsonValue.Obj o
                        && o.get("model") instanceof JsonValue.Str s
                        && s.text.equals(Shading.Model.PHYSICAL.word())
                ? physical(v, place, values)
                : classic(v, place, values);
    }

    private static Shading classic(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, Vocabulary.CLASSIC_SHADING, values);
        if (f == null) {
            return null;
        }
        f.word("model", models(), List.of(), Shading.Model.CLASSIC.word());
        ClassicShading d = ClassicShading.DEFAULT;
        double ambient = f.number("ambient", d.ambient());
        double shadow = f.number("shadow", d.shadow());
        DisplayRgb background = f.color("background", d.background());
        int maxBounces = f.integer("maxBounces", 0, ClassicShading.MAX_BOUNCES, d.maxBounces());
        return f.make(() -> new ClassicShading(ambient, shadow, background, maxBounces));
    }

    private static Shading physical(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, Vocabulary.PHYSICAL_SHADING, ONLY_CLASSIC, values);
        if (f == null) {
            return null;
        }
        OptionalInt maxBounces = f.has("maxBounces")
                ? OptionalInt.of(f.integer("maxBounces", 0, PhysicalShading.MAX_BOUNCES, 0))
                : PhysicalShading.DEFAULT.maxBounces();
        Rgb background = f.has("background")
                ? light(f.get("background"), f.at("background"), values)
                : PhysicalShading.DEFAULT.background();
        return f.make(() -> new PhysicalShading(maxBounces, background));
    }

    /** Linear light, or a colour of a screen that is decoded; null after a problem. */
    private static Rgb light(JsonValue v, JsonPointer place, Values values) {
        if (!(v instanceof JsonValue.Obj)) {
            return Rgb.of(values.color(v, place, LIGHT));
        }
        Fields f = Fields.of(v, place, Vocabulary.LINEAR_COLOR, values);
        JsonPointer at = place.child("linear");
        JsonValue.Arr a = f.has("linear") ? values.array(f.get("linear"), at, 3, "three numbers [r, g, b]") : null;
        if (a == null) {
            return null;
        }
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            rgb[i] = values.number(a.get(i), at.child(i));
            if (rgb[i] < 0) {
                values.problems().add(a.get(i), at.child(i), "must be a number of at least 0, not " + rgb[i]);
            }
        }
        return f.make(() -> new Rgb(rgb[0], rgb[1], rgb[2]));
    }

    static JsonValue write(Shading shading, JsonObjectBuilder p) {
        p.text("model", shading.model().word());
        if (shading instanceof PhysicalShading s) {
            if (!s.background().equals(PhysicalShading.DEFAULT.background()) || p.animated("background")) {
                p.put(
                        "background",
                        p.child("background").linear("linear", s.background()).json());
            }
            if (s.maxBounces().isPresent()) {
                p.whole("maxBounces", s.maxBounces().getAsInt());
            }
            return p.json();
        }
        ClassicShading s = (ClassicShading) shading;
        p.number("ambient", s.ambient()).number("shadow", s.shadow());
        p.colorUnless(ClassicShading.DEFAULT.background(), "background", s.background());
        return p.wholeUnless(ClassicShading.DEFAULT.maxBounces(), "maxBounces", s.maxBounces())
                .json();
    }
}
