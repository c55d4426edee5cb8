package enlightenment.scene.json;

import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.util.List;
import java.util.Map;

/** The named materials, and materials where they are used. */
final class Materials {
    static final Family<Material> FAMILY = new Family<Material>(
                    "material",
                    "a material",
                    null,
                    Vocabulary.PLANNED_MATERIALS,
                    List.of(),
                    Materials::read,
                    Materials::write)
            .with("matte", Material.Matte.class, "color | receivesShadows")
            .with("mirror", Material.Mirror.class, "color | receivesShadows")
            .with("glass", Material.Glass.class, "color indexOfRefraction | transparency priority receivesShadows");

    private Materials() {}

    private static Material read(String type, Fields f) {
        return switch (type) {
            case "matte" -> matte(f);
            case "mirror" -> mirror(f);
            case "glass" -> glass(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Material value, JsonObjectBuilder p) {
        if (value instanceof Material.Matte m) {
            p.texture("color", m.color()).flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Material.Mirror m) {
            p.texture("color", m.color()).flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Material.Glass g) {
            p.texture("color", g.color())
                    .number("indexOfRefraction", g.indexOfRefraction())
                    .numberUnless(1, "transparency", g.transparency())
                    .wholeUnless(0, "priority", g.priority())
                    .flagUnless(true, "receivesShadows", g.receivesShadows());
        } else {
            throw Family.unknown(value);
        }
    }

    /** Reads the part {@code materials} into the library. */
    static void readNamed(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "materials by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            values.library().materials.put(o.key(i), inline(o.value(i), place.child(o.key(i)), values));
        }
    }

    /** A name or a material; null after a problem, here or where the material has its name. */
    static Material use(JsonValue v, JsonPointer place, Values values) {
        if (v instanceof JsonValue.Str s) {
            return named(s, place, values);
        }
        if (v instanceof JsonValue.Obj) {
            return inline(v, place, values);
        }
        values.problems().add(v, place, "must be the name of a material, or a material { ... }, not " + v.describe());
        return null;
    }

    private static Material named(JsonValue.Str name, JsonPointer place, Values values) {
        Map<String, Material> named = values.library().materials;
        if (!named.containsKey(name.text)) {
            String instead = named.isEmpty()
                    ? "; the scene names no materials (/materials)"
                    : Suggestion.of(name.text, named.keySet(), "there are");
            values.problems().add(name, place, "unknown material " + Plain.quoted(name.text) + instead);
        }
        return named.get(name.text);
    }

    private static Material inline(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, FAMILY, values);
        return f == null ? null : FAMILY.read(f);
    }

    private static Material matte(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        return color == null ? null : f.make(() -> new Material.Matte(color, shadows));
    }

    private static Material mirror(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        return color == null ? null : f.make(() -> new Material.Mirror(color, shadows));
    }

    private static Material glass(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        double index = f.number("indexOfRefraction");
        double transparency = f.number("transparency", 1);
        int priority = f.integer("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        return color == null ? null : f.make(() -> new Material.Glass(color, index, transparency, priority, shadows));
    }

    private static boolean receivesShadows(Fields f) {
        return f.flag("receivesShadows", true);
    }
}
