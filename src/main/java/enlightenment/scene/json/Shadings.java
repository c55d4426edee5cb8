package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.material.Medium;
import enlightenment.scene.Shading;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Reads and writes the shading part; its key {@code "model"} says which other keys it has. */
final class Shadings {
    /** Keys of physical shading that classic shading refuses, with the message for each. */
    private static final Map<String, String> ONLY_PHYSICAL =
            Map.of("medium", "belongs to physical shading: classic shading has nothing that scatters light on its way");

    /** Keys of classic shading that physical shading refuses, with the message for each. */
    private static final Map<String, String> ONLY_CLASSIC = Map.of(
            "ambient",
            "belongs to classic shading: in physical shading all light comes from the lights and the background",
            "shadow",
            "belongs to classic shading: in physical shading nothing of a hidden light arrives");

    private static final String ONLY_COLOR =
            "must be a colour: pictures and skies belong to physical shading, \"model\": \"physical\"";

    private Shadings() {}

    /** The names of all models. */
    static List<String> models() {
        return List.of(Shading.Model.CLASSIC.word(), Shading.Model.PHYSICAL.word());
    }

    /** The shading; null after a problem. */
    static Shading read(JsonValue v, JsonPointer place, Values values) {
        return v instanceof JsonValue.Obj o
                        && o.get("model") instanceof JsonValue.Str s
                        && s.text.equals(Shading.Model.PHYSICAL.word())
                ? physical(v, place, values)
                : classic(v, place, values);
    }

    private static Shading classic(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, PartKeys.CLASSIC_SHADING, ONLY_PHYSICAL, values);
        if (f == null) {
            return null;
        }
        f.word("model", models(), Shading.Model.CLASSIC.word());
        Shading.Classic d = Shading.Classic.DEFAULT;
        double ambient = f.number("ambient", d.ambient());
        double shadow = f.number("shadow", d.shadow());
        DisplayRgb background = background(f, d);
        int maxBounces = f.integer("maxBounces", 0, Shading.Classic.MAX_BOUNCES, d.maxBounces());
        return f.make(() -> new Shading.Classic(ambient, shadow, background, maxBounces));
    }

    private static DisplayRgb background(Fields f, Shading.Classic unlessGiven) {
        if (Backgrounds.isMoreThanColor(f.get("background"))) {
            f.problem("background", ONLY_COLOR);
            return unlessGiven.background();
        }
        return f.color("background", unlessGiven.background()).display();
    }

    private static Shading physical(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, PartKeys.PHYSICAL_SHADING, ONLY_CLASSIC, values);
        if (f == null) {
            return null;
        }
        OptionalInt maxBounces = f.has("maxBounces")
                ? OptionalInt.of(f.integer("maxBounces", 0, Shading.Physical.MAX_BOUNCES, 0))
                : Shading.Physical.DEFAULT.maxBounces();
        Shading.Background background = f.has("background")
                ? Backgrounds.read(f.get("background"), f.at("background"), values)
                : Shading.Physical.DEFAULT.background();
        Medium medium = f.has("medium") ? Media.read(f.get("medium"), f.at("medium"), values) : null;
        return background == null
                ? null
                : f.make(() -> new Shading.Physical(maxBounces, background, Optional.ofNullable(medium)));
    }

    static JsonValue write(Shading shading, JsonObjectBuilder p) {
        p.text("model", shading.model().word());
        if (shading instanceof Shading.Physical s) {
            if (!s.background().equals(Shading.Physical.DEFAULT.background()) || p.animated("background")) {
                p.put("background", Backgrounds.write(s.background(), p.child("background")));
            }
            s.medium()
                    .ifPresent(m ->
                            p.put("medium", Media.write(m, p.child("medium")).json()));
            if (s.maxBounces().isPresent()) {
                p.whole("maxBounces", s.maxBounces().getAsInt());
            }
            return p.json();
        }
        Shading.Classic s = (Shading.Classic) shading;
        p.number("ambient", s.ambient()).number("shadow", s.shadow());
        p.colorUnless(Shading.Classic.DEFAULT.background(), "background", s.background());
        return p.wholeUnless(Shading.Classic.DEFAULT.maxBounces(), "maxBounces", s.maxBounces())
                .json();
    }
}
