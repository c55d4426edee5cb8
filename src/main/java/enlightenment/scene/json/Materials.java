package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads the named materials, and materials where they are used. */
final class Materials {
    private static final Fields.Family FAMILY =
            new Fields.Family("a material", Vocabulary.MATERIALS, Vocabulary.PLANNED_MATERIALS, List.of());

    private final Values values;
    private final Textures textures;
    /** Null for a material that is there but wrong: its own problem is enough. */
    private final Map<String, Material> named = new LinkedHashMap<>();

    Materials(Values values, Textures textures) {
        this.values = values;
        this.textures = textures;
    }

    /** Reads the part {@code materials}. */
    void readNamed(JsonValue v, JsonPointer place) {
        JsonValue.Obj o = values.object(v, place, "materials by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            named.put(o.key(i), inline(o.value(i), place.child(o.key(i))));
        }
    }

    Map<String, Material> named() {
        return named;
    }

    /** A name or a material; null after a problem, here or where the material has its name. */
    Material use(JsonValue v, JsonPointer place) {
        if (v instanceof JsonValue.Str s) {
            Material material = named.get(s.text);
            if (material == null && !named.containsKey(s.text)) {
                String there = Suggestion.of(s.text, named.keySet(), "there are");
                String none = "; the scene names no materials (/materials)";
                values.problems()
                        .add(v, place, "unknown material " + Plain.quoted(s.text) + (named.isEmpty() ? none : there));
            }
            return material;
        }
        if (v instanceof JsonValue.Obj) {
            return inline(v, place);
        }
        values.problems().add(v, place, "must be the name of a material, or a material { ... }, not " + v.describe());
        return null;
    }

    private Material inline(JsonValue v, JsonPointer place) {
        Fields f = Fields.of(v, place, FAMILY, null, values);
        if (f == null) {
            return null;
        }
        Texture color = f.has("color") ? textures.color(f.get("color"), f.at("color")) : Texture.of(DisplayRgb.BLACK);
        boolean shadows = f.flag("receivesShadows", true);
        switch (f.type(null)) {
            case "matte":
                return color == null ? null : f.make(() -> new Material.Matte(color, shadows));
            case "mirror":
                return color == null ? null : f.make(() -> new Material.Mirror(color, shadows));
            default: {
                double index = f.number("indexOfRefraction");
                double transparency = f.number("transparency", 1);
                int priority = f.integer("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
                return color == null
                        ? null
                        : f.make(() -> new Material.Glass(color, index, transparency, priority, shadows));
            }
        }
    }
}
