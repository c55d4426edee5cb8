package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reads and writes materials: named ones, and those in place of a name. */
final class Materials {
    private static final String GLASS_IS_DARK = "belongs to opaque materials: glass does not glow";
    private static final String MEDIA_ARE_DARK = "belongs to opaque materials: media do not glow";

    static final Family<Material> FAMILY = new Family<Material>(
                    "material", "a material", null, Map.of(), Materials::read, Materials::write)
            .with(
                    "matte",
                    Material.Matte.class,
                    "color | roughness radiance radianceMap radianceSide ultraviolet receivesShadows")
            .with(
                    "mirror",
                    Material.Mirror.class,
                    "color | radiance radianceMap radianceSide ultraviolet receivesShadows")
            .with(
                    "glossy",
                    Glossy.class,
                    "roughness | color metal eta k multipleScattering radiance radianceMap radianceSide ultraviolet",
                    Map.of("receivesShadows", "belongs to classic shading, which has no glossy surfaces"))
            .with(
                    "coated",
                    Coated.class,
                    "color | roughness indexOfRefraction nonlinear radiance radianceMap radianceSide ultraviolet",
                    Map.of("receivesShadows", "belongs to classic shading, which has no coated surfaces"))
            .with(
                    "principled",
                    Principled.class,
                    PrincipledMaterials.KEYS,
                    Map.of("receivesShadows", "belongs to classic shading, which has no principled surfaces"))
            .with(
                    "glass",
                    Glass.class,
                    "color indexOfRefraction | transparency priority roughness absorption multipleScattering dispersion"
                            + " smoothRefraction opaque receivesShadows",
                    Map.of(
                            "radiance",
                            GLASS_IS_DARK,
                            "radianceMap",
                            GLASS_IS_DARK,
                            "radianceSide",
                            GLASS_IS_DARK,
                            "ultraviolet",
                            GLASS_IS_DARK))
            .with(
                    "scattering",
                    Material.Scattering.class,
                    "| color meanFreePath scatteringCoefficient absorptionCoefficient anisotropy indexOfRefraction roughness"
                            + " priority",
                    Map.of(
                            "radiance",
                            MEDIA_ARE_DARK,
                            "radianceMap",
                            MEDIA_ARE_DARK,
                            "radianceSide",
                            MEDIA_ARE_DARK,
                            "ultraviolet",
                            MEDIA_ARE_DARK,
                            "absorption",
                            "is called \"absorptionCoefficient\" here, and stands with \"scatteringCoefficient\"",
                            "receivesShadows",
                            "belongs to classic shading, which has no media that scatter light"))
            .with(
                    "fluorescent",
                    Material.Fluorescent.class,
                    "color absorption emission yield | radiance radianceMap radianceSide ultraviolet",
                    Map.of("receivesShadows", "belongs to classic shading, which has no fluorescent surfaces"));

    static {
        String why = "belongs to classic shading, which has no materials made of others";
        FAMILY.with("mix", Composite.Mix.class, "materials weight |", Map.of("receivesShadows", why))
                .with("mask", Composite.Mask.class, "of map |", Map.of("receivesShadows", why))
                .with("normalMap", Composite.NormalMap.class, "of map |", Map.of("receivesShadows", why))
                .with("bump", Composite.Bump.class, "of map height |", Map.of("receivesShadows", why));
    }

    private Materials() {}

    private static Material read(String type, Fields f) {
        return switch (type) {
            case "matte" -> matte(f);
            case "mirror" -> mirror(f);
            case "glossy" -> glossy(f);
            case "coated" -> coated(f);
            case "principled" -> PrincipledMaterials.read(f);
            case "glass" -> glass(f);
            case "scattering" -> scattering(f);
            case "fluorescent" -> fluorescent(f);
            case "mix", "mask", "normalMap", "bump" -> DetailedMaterials.read(type, f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Material value, JsonObjectBuilder p) {
        if (value instanceof Material.Matte m) {
            p.texture("color", m.color())
                    .numberUnless(0, "roughness", m.roughness())
                    .bandsUnless(Rgb.BLACK, "radiance", m.radiance())
                    .textureIfPresent("radianceMap", m.radianceMap())
                    .wordUnless(
                            Material.EmissionPattern.Side.BOTH,
                            "radianceSide",
                            m.pattern().side())
                    .numberUnless(0, "ultraviolet", m.ultraviolet())
                    .flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Material.Mirror m) {
            p.texture("color", m.color())
                    .bandsUnless(Rgb.BLACK, "radiance", m.radiance())
                    .textureIfPresent("radianceMap", m.radianceMap())
                    .wordUnless(
                            Material.EmissionPattern.Side.BOTH,
                            "radianceSide",
                            m.pattern().side())
                    .numberUnless(0, "ultraviolet", m.ultraviolet())
                    .flagUnless(true, "receivesShadows", m.receivesShadows());
        } else if (value instanceof Glossy g) {
            p.texture("color", g.color()).amount("roughness", g.roughness());
            g.conductor().ifPresent(c -> conductor(c, p));
            p.flagUnless(true, "multipleScattering", g.multipleScattering())
                    .bandsUnless(Rgb.BLACK, "radiance", g.radiance())
                    .textureIfPresent("radianceMap", g.radianceMap())
                    .wordUnless(
                            Material.EmissionPattern.Side.BOTH,
                            "radianceSide",
                            g.pattern().side())
                    .numberUnless(0, "ultraviolet", g.ultraviolet());
        } else if (value instanceof Coated c) {
            p.texture("color", c.color())
                    .amountUnless(0, "roughness", c.roughness())
                    .numberUnless(Coated.USUAL_INDEX, "indexOfRefraction", c.indexOfRefraction())
                    .flagUnless(false, "nonlinear", c.nonlinear())
                    .bandsUnless(Rgb.BLACK, "radiance", c.radiance())
                    .textureIfPresent("radianceMap", c.radianceMap())
                    .wordUnless(
                            Material.EmissionPattern.Side.BOTH,
                            "radianceSide",
                            c.pattern().side())
                    .numberUnless(0, "ultraviolet", c.ultraviolet());
        } else if (value instanceof Glass g) {
            p.texture("color", g.color())
                    .number("indexOfRefraction", g.indexOfRefraction())
                    .numberUnless(1, "transparency", g.transparency())
                    .wholeUnless(0, "priority", g.priority())
                    .amountUnless(0, "roughness", g.roughness())
                    .bandsUnless(Rgb.BLACK, "absorption", g.absorption())
                    .flagUnless(true, "multipleScattering", g.multipleScattering());
            g.dispersion().ifPresent(abbe -> p.number("dispersion", abbe));
            p.flagUnless(false, "smoothRefraction", g.smoothRefraction());
            g.opaque().ifPresent(base -> p.put("opaque", DetailedMaterials.json(base, p.child("opaque"))));
            p.flagUnless(true, "receivesShadows", g.receivesShadows());
        } else if (value instanceof Material.Scattering s) {
            Media.write(s.medium(), p)
                    .numberUnless(1, "indexOfRefraction", s.indexOfRefraction())
                    .numberUnless(0, "roughness", s.roughness())
                    .wholeUnless(0, "priority", s.priority());
        } else if (value instanceof Material.Fluorescent d) {
            p.texture("color", d.color())
                    .wavelengths("absorption", d.absorption())
                    .wavelengths("emission", d.emission())
                    .number("yield", d.yield())
                    .bandsUnless(Rgb.BLACK, "radiance", d.radiance())
                    .textureIfPresent("radianceMap", d.radianceMap())
                    .wordUnless(
                            Material.EmissionPattern.Side.BOTH,
                            "radianceSide",
                            d.pattern().side())
                    .numberUnless(0, "ultraviolet", d.ultraviolet());
        } else if (value instanceof Principled m) {
            PrincipledMaterials.write(m, p);
        } else {
            DetailedMaterials.write(value, p);
        }
    }

    /** Reads the part {@code materials} into the library. */
    static void readNamed(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, "materials by their names");
        for (int i = 0; o != null && i < o.size(); i++) {
            values.library().materials.put(o.key(i), inline(o.value(i), place.child(o.key(i)), values));
        }
    }

    /** The material of a name or of an object; null after a problem of the reference or of the material. */
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
            boolean isPart = place.toString().startsWith("/materials/");
            String instead = isPart
                    ? " before this one: what a material is made of must stand above it"
                    : named.isEmpty()
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
        Material.EmissionPattern pattern = pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        return color == null
                ? null
                : f.make(() -> new Material.Matte(color, shadows, roughness, radiance, ultraviolet, pattern));
    }

    private static Material mirror(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        Rgb radiance = radiance(f);
        Material.EmissionPattern pattern = pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        return color == null ? null : f.make(() -> new Material.Mirror(color, shadows, radiance, ultraviolet, pattern));
    }

    private static Material glossy(Fields f) {
        boolean hasConstants = f.has("eta") || f.has("k");
        if (!f.has("color") && !f.has("metal") && !hasConstants) {
            f.problem("color", "missing; a glossy material needs it, or a \"metal\"");
        }
        Texture color = f.has("color") ? Textures.color(f, "color") : Texture.of(DisplayRgb.WHITE);
        Texture.Amount roughness = Amounts.read(f, "roughness");
        boolean several = f.flag("multipleScattering", true);
        Rgb radiance = radiance(f);
        Material.EmissionPattern pattern = pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        Rgb eta = constant(f, "eta", hasConstants);
        Rgb k = constant(f, "k", hasConstants);
        Optional<Glossy.Conductor> metal = metal(f, hasConstants);
        if (color == null || roughness == null) {
            return null;
        }
        return f.make(() -> new Glossy(
                color,
                roughness,
                hasConstants ? Optional.of(new Glossy.Conductor(eta, k)) : metal,
                several,
                radiance,
                ultraviolet,
                pattern));
    }

    /** The optical constants of a named metal; empty without a name, and after a problem. */
    private static Optional<Glossy.Conductor> metal(Fields f, boolean hasConstants) {
        if (!f.has("metal")) {
            return Optional.empty();
        }
        if (hasConstants) {
            f.problem("metal", "must stand without \"eta\" and \"k\", which are the constants of another metal");
        }
        return Optional.ofNullable(f.word("metal", Glossy.Metal.words(), null))
                .flatMap(Glossy.Metal::of)
                .map(Glossy.Metal::conductor);
    }

    private static void conductor(Glossy.Conductor c, JsonObjectBuilder p) {
        Optional<Glossy.Metal> metal = Glossy.Metal.of(c);
        if (metal.isPresent()) {
            p.text("metal", metal.get().word());
        } else {
            p.bands("eta", c.eta()).bands("k", c.k());
        }
    }

    /** One of the optical constants η and k of a conductor; white if it is missing. */
    private static Rgb constant(Fields f, String key, boolean isConductor) {
        if (isConductor && !f.has(key)) {
            f.problem(key, "missing; \"eta\" and \"k\" belong together");
        }
        return f.bands(key, Rgb.WHITE);
    }

    private static Material coated(Fields f) {
        Texture color = Textures.color(f, "color");
        Texture.Amount roughness = Amounts.read(f, "roughness", 0);
        double index = f.number("indexOfRefraction", Coated.USUAL_INDEX);
        boolean nonlinear = f.flag("nonlinear", false);
        Rgb radiance = radiance(f);
        Material.EmissionPattern pattern = pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        return color == null || roughness == null
                ? null
                : f.make(() -> new Coated(color, roughness, index, nonlinear, radiance, ultraviolet, pattern));
    }

    private static Material glass(Fields f) {
        Texture color = Textures.color(f, "color");
        boolean shadows = receivesShadows(f);
        double index = f.number("indexOfRefraction");
        double transparency = f.number("transparency", 1);
        int priority = f.integer("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        Texture.Amount roughness = Amounts.read(f, "roughness", 0);
        Rgb absorption = f.bands("absorption", Rgb.BLACK);
        boolean several = f.flag("multipleScattering", true);
        OptionalDouble abbe = f.has("dispersion") ? OptionalDouble.of(f.number("dispersion")) : OptionalDouble.empty();
        boolean smoothly = f.flag("smoothRefraction", false);
        Material opaque = f.has("opaque") ? use(f.get("opaque"), f.at("opaque"), f.values()) : null;
        if (color == null || roughness == null || f.has("opaque") && opaque == null) {
            return null;
        }
        return f.make(() -> new Glass(
                color,
                index,
                transparency,
                priority,
                shadows,
                roughness,
                absorption,
                several,
                abbe,
                smoothly,
                Optional.ofNullable(opaque)));
    }

    private static Material scattering(Fields f) {
        Medium medium = Media.read(f);
        double index = f.number("indexOfRefraction", 1);
        double roughness = f.number("roughness", 0);
        int priority = f.integer("priority", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        return medium == null ? null : f.make(() -> new Material.Scattering(medium, index, roughness, priority));
    }

    private static Material fluorescent(Fields f) {
        Texture color = Textures.color(f, "color");
        Material.WavelengthBand absorption = f.wavelengths("absorption");
        Material.WavelengthBand emission = f.wavelengths("emission");
        double yield = f.number("yield");
        Rgb radiance = radiance(f);
        Material.EmissionPattern pattern = pattern(f);
        double ultraviolet = f.number("ultraviolet", 0);
        if (color == null) {
            return null;
        }
        return f.make(
                () -> new Material.Fluorescent(color, absorption, emission, yield, radiance, ultraviolet, pattern));
    }

    private static boolean receivesShadows(Fields f) {
        return f.flag("receivesShadows", true);
    }

    static Rgb radiance(Fields f) {
        return f.bands("radiance", Rgb.BLACK);
    }

    /** The emission pattern: radiance map and side; even emission on both sides after a problem. */
    static Material.EmissionPattern pattern(Fields f) {
        Optional<Texture> map =
                f.has("radianceMap") ? Optional.ofNullable(Textures.color(f, "radianceMap")) : Optional.empty();
        return new Material.EmissionPattern(map, f.word("radianceSide", Material.EmissionPattern.Side.BOTH));
    }
}
