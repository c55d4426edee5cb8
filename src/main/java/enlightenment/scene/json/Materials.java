package enlightenment.scene.json;

import enlightenment.color.Rgb;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.util.Map;
import java.util.Optional;

/** The named materials, and materials where they are used. */
final class Materials {
    static final Family<Material> FAMILY = new Family<Material>(
                    "material", "a material", null, Vocabulary.PLANNED_MATERIALS, Materials::read, Materials::write)
            .with("matte", Material.Matte.class, "color | roughness radiance receivesShadows")
            .with("mirror", Material.Mirror.class, "color | radiance receivesShadows")
            .with(
                    "glossy",
                    Material.Glossy.class,
                    "color roughness | eta k multipleScattering radiance",
                    Map.of("receivesShadows", "belongs to classic shading, which has no glossy surfaces"))
            .with(
                    "glass",
                    Material.Glass.class,
                    "color indexOfRefraction | transparency priority roughness absorption multipleScattering receivesShadows",
                    Map.of(
                            "radiance",
                            "belongs to opaque materials: glass does not glow",
                            "dispersion",
                            "is not available yet: glass refracts all wavelengths alike"));

    private Materials() {}

    private static Material read(String type, Fields f) {
        return switch (type) {
            case "matte" -> matte(f);
            case "mirror" -> mirror(f);
            case "glossy" -> glossy(f);
            case "glass" -> glass(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Material value, JsonObjectBuilder p) {
        if (value instanceof Material.Matte m) {
            p.texture("color", m.color())
                    .numberUnless(0, "roughness", m.roughness())
                    .bandsUnless(Rgb.BLACK, "radiance", m.radiance())
                    .flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Material.Mirror m) {
            p.texture("color", m.color())
                    .bandsUnless(Rgb.BLACK, "radiance", m.radiance())
                    .flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Material.Glossy g) {
            p.texture("color", g.color()).number("roughness", g.roughness());
            g.conductor().ifPresent(c -> p.bands("eta", c.eta()).bands("k", c.k()));
            p.flagUnless(true, "multipleScattering", g.multipleScattering())
                    .bandsUnless(Rgb.BLACK, "radiance", g.radiance());
        } else if (value instanceof Material.Glass g) {
            p.texture("color", g.color())
                    .number("indexOfRefraction", g.indexOfRefraction())
                    .numberUnless(1, "transparency", g.transparency())
                    .wholeUnless(0, "priority", g.priority())
                    .numberUnless(0, "roughness", g.roughness())
                    .bandsUnless(Rgb.BLACK, "absorption", g.absorption())
                    .flagUnless(true, "multipleScattering", g.multipleScattering())
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
        double roughness = f.number("roughness", 0);
        Rgb radiance = radiance(f);
        return color == null ? null : f.make(() -> new Material.Matte(color, shadows, roughness, radiance));
    }

    private static Material mirror(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        Rgb radiance = radiance(f);
        return color == null ? null : f.make(() -> new Material.Mirror(color, shadows, radiance));
    }

    private static Material glossy(Fields f) {
        Texture color = Textures.color(f, "color");
        double roughness = f.number("roughness");
        boolean several = f.flag("multipleScattering", true);
        Rgb radiance = radiance(f);
        boolean isConductor = f.has("eta") || f.has("k");
        Rgb eta = constant(f, "eta", isConductor);
        Rgb k = constant(f, "k", isConductor);
        if (color == null) {
            return null;
        }
        return f.make(() -> new Material.Glossy(
                color,
                roughness,
                isConductor ? Optional.of(new Material.Conductor(eta, k)) : Optional.empty(),
                several,
                radiance));
    }

    /** One of the two constants of a conductor. */
    private static Rgb constant(Fields f, String key, boolean isConductor) {
        if (isConductor && !f.has(key)) {
            f.problem(key, "missing; \"eta\" and \"k\" belong together");
        }
        return f.bands(key, Rgb.WHITE);
    }

    private static Material glass(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        double index = f.number("indexOfRefraction");
        double transparency = f.number("transparency", 1);
        int priority = f.integer("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        double roughness = f.number("roughness", 0);
        Rgb absorption = f.bands("absorption", Rgb.BLACK);
        boolean several = f.flag("multipleScattering", true);
        if (color == null) {
            return null;
        }
        return f.make(() ->
                new Material.Glass(color, index, transparency, priority, shadows, roughness, absorption, several));
    }

    private static boolean receivesShadows(Fields f) {
        return f.flag("receivesShadows", true);
    }

    private static Rgb radiance(Fields f) {
        return f.bands("radiance", Rgb.BLACK);
    }
}
