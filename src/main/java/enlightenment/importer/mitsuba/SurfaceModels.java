package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.material.Conductor;
import enlightenment.material.Material;
import enlightenment.material.Metal;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import java.util.Locale;
import java.util.Optional;

/** The surface models of Mitsuba as materials. */
final class SurfaceModels {
    /** Reflects all light at every angle, to 4e-11, as Mitsuba's conductor {@code none} does. */
    private static final Conductor PERFECT = new Conductor(Rgb.gray(1.0 / 1024), Rgb.gray(1 << 14));

    private final SceneIndex scene;
    private final TextureReader textures;

    SurfaceModels(SceneIndex scene, TextureReader textures) {
        this.scene = scene;
        this.textures = textures;
    }

    /** The material of a bsdf that holds no other; one of an unknown model is diffuse grey, with a note. */
    Material material(Properties p) {
        return switch (p.element().type()) {
            case "diffuse", "lambertian" -> Material.Matte.of(textures.reflectance(p, "reflectance", 0.5));
            case "roughdiffuse" -> roughDiffuse(p);
            case "dielectric", "thindielectric", "roughdielectric" -> dielectric(p);
            case "conductor", "roughconductor" -> conductor(p);
            case "plastic", "roughplastic" -> plastic(p);
            case "principled", "principledthin" -> principled(p);
            case "phong" -> phong(p);
            case "ward" -> ward(p);
            default -> unknown(p);
        };
    }

    private void note(Properties p, String message) {
        scene.note(p.element(), message);
    }

    private Material roughDiffuse(Properties p) {
        double alpha = textures.number(p, "alpha", 0.2);
        p.ignore("use_fast_approx");
        note(p, "roughdiffuse becomes matte by another model");
        return Material.Matte.of(textures.reflectance(p, "reflectance", 0.5))
                .withRoughness(StrictMath.min(StrictMath.sqrt(2) * StrictMath.max(alpha, 0), 1));
    }

    /** α of a rough model; 0 of a smooth one. */
    private double alpha(Properties p) {
        if (!p.element().type().startsWith("rough")) {
            return 0;
        }
        String distribution = p.text("distribution", "beckmann").toLowerCase(Locale.ROOT);
        if (!distribution.equals("ggx")) {
            note(p, "the distribution " + Plain.quoted(distribution) + " becomes ggx of equal alpha");
        }
        p.ignore("sample_visible");
        double alpha = textures.number(p, "alpha", 0.1);
        if (p.has("alpha_u") || p.has("alpha_v")) {
            double u = textures.number(p, "alpha_u", 0.1);
            double v = textures.number(p, "alpha_v", 0.1);
            if (u != v) {
                note(p, "an anisotropic surface becomes one of alpha sqrt(alpha_u alpha_v)");
            }
            alpha = StrictMath.sqrt(StrictMath.max(u * v, 0));
        }
        return alpha;
    }

    /** Our roughness: α is its square. */
    private static double roughness(double alpha) {
        return StrictMath.sqrt(StrictMath.min(StrictMath.max(alpha, 0), 1));
    }

    private Material dielectric(Properties p) {
        double index = IndexOfRefraction.relative(p, "bk7");
        double roughness = roughness(alpha(p));
        noteIfNotWhite(p, "specular_reflectance");
        Texture through = textures.reflectance(p, "specular_transmittance", 1);
        return new Material.Glass(through, index, 1, 0, true, roughness, Rgb.BLACK, false);
    }

    private void noteIfNotWhite(Properties p, String name) {
        Optional<XmlElement> e = p.find(name);
        if (e.isPresent() && !textures.texture(e.get(), false).equals(Texture.of(Rgb.WHITE))) {
            note(p, p.element().described() + ": " + name + " becomes 1");
        }
    }

    private Material conductor(Properties p) {
        double roughness = roughness(alpha(p));
        Texture color = textures.reflectance(p, "specular_reflectance", 1);
        String name = p.text("material", scene.isOld() ? "Cu" : "none");
        Optional<XmlElement> eta = p.find("eta");
        Conductor conductor;
        if (eta.isPresent() || p.has("k")) {
            Rgb n = textures.color(p, "eta", 0);
            double outside = p.number("ext_eta", 1);
            conductor = n.max() == 0 && !p.has("k")
                    ? PERFECT
                    : new Conductor(divided(n, outside), divided(textures.color(p, "k", 1), outside));
        } else if (name.equalsIgnoreCase("none")) {
            if (roughness == 0) {
                return Material.Mirror.of(color);
            }
            conductor = PERFECT;
        } else {
            conductor = Metal.of(name)
                    .orElseGet(() -> {
                        note(p, "the metal " + Plain.quoted(name) + " becomes chromium");
                        return Metal.CHROMIUM;
                    })
                    .conductor();
        }
        return new Material.Glossy(color, roughness, Optional.of(conductor), false, Rgb.BLACK);
    }

    /** η must be above 0. */
    private static Rgb divided(Rgb c, double by) {
        double least = 0x1p-30;
        return new Rgb(
                StrictMath.max(c.r() / by, least),
                StrictMath.max(c.g() / by, least),
                StrictMath.max(c.b() / by, least));
    }

    private Material plastic(Properties p) {
        double index = IndexOfRefraction.relative(p, "polypropylene");
        double roughness = roughness(alpha(p));
        Texture color = textures.reflectance(p, "diffuse_reflectance", 0.5);
        noteIfNotWhite(p, "specular_reflectance");
        if (index < 1 || index > Material.Coated.LARGEST_INDEX) {
            note(p, "a coat of index of refraction " + index + " is left out");
            return Material.Matte.of(color);
        }
        return new Material.Coated(color, roughness, index, p.flag("nonlinear", false), Rgb.BLACK, 0);
    }

    private Material principled(Properties p) {
        Texture color = textures.reflectance(p, "base_color", 0.5);
        double roughness = StrictMath.min(StrictMath.max(textures.number(p, "roughness", 0.5), 0), 1);
        double metallic = textures.number(p, "metallic", 0);
        double transmission = textures.number(p, "spec_trans", 0);
        double specular = p.number("specular", 0.5);
        double index =
                p.number("eta", 2 / (1 - StrictMath.sqrt(0.08 * StrictMath.min(StrictMath.max(specular, 0), 1))) - 1);
        note(p, p.element().type() + " becomes the nearest of glossy, glass and coated");
        p.ignore("anisotropic", "sheen", "sheen_tint", "flatness", "spec_tint", "clearcoat", "clearcoat_gloss");
        p.ignore("main_specular_sampling_rate", "clearcoat_sampling_rate", "diffuse_reflectance_sampling_rate");
        if (metallic >= 0.5) {
            return new Material.Glossy(color, roughness, Optional.empty(), false, Rgb.BLACK);
        }
        if (transmission >= 0.5 && index > 1) {
            return new Material.Glass(color, index, 1, 0, true, roughness, Rgb.BLACK, false);
        }
        return index < 1 || index > Material.Coated.LARGEST_INDEX
                ? Material.Matte.of(color)
                : new Material.Coated(color, roughness, index, false, Rgb.BLACK, 0);
    }

    /** Blinn's exponent n has the width of the distribution of α² = 2 / (n + 2) (Walter et al. 2007). */
    private Material phong(Properties p) {
        double exponent = StrictMath.max(textures.number(p, "exponent", 30), 0);
        return highlight(p, StrictMath.sqrt(2 / (exponent + 2)));
    }

    private Material ward(Properties p) {
        p.ignore("variant");
        double u = textures.number(p, "alpha_u", 0.1);
        double v = textures.number(p, "alpha_v", 0.1);
        return highlight(p, StrictMath.sqrt(StrictMath.max(u * v, 0)));
    }

    private Material highlight(Properties p, double alpha) {
        note(p, p.element().type() + " becomes a coat of index 1.5 over matte");
        p.ignore("specular_reflectance", "specular_sampling_weight");
        return new Material.Coated(
                textures.reflectance(p, "diffuse_reflectance", 0.5), roughness(alpha), 1.5, false, Rgb.BLACK, 0);
    }

    private Material unknown(Properties p) {
        note(p, p.element().described() + " is not known; its surface becomes diffuse grey");
        p.element().children().forEach(c -> p.ignore(c.name()));
        return Material.Matte.of(Texture.of(Rgb.gray(0.5)));
    }
}
