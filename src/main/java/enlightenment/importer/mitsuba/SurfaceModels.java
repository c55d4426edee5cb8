package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import java.util.Optional;

/** The surface models of Mitsuba as materials. */
final class SurfaceModels {
    /** Reflects all light at every angle, to 4e-11, as Mitsuba's conductor {@code none} does. */
    private static final Glossy.Conductor PERFECT = new Glossy.Conductor(Rgb.gray(1.0 / 1024), Rgb.gray(1 << 14));

    private final SceneIndex scene;
    private final TextureReader textures;
    private final RoughnessReader roughnesses;

    SurfaceModels(SceneIndex scene, TextureReader textures) {
        this.scene = scene;
        this.textures = textures;
        roughnesses = new RoughnessReader(scene, textures);
    }

    /** The material of a bsdf that holds no other; one of an unknown model is diffuse grey, with a note. */
    Material material(Properties p) {
        return switch (p.element().type()) {
            case "diffuse", "lambertian" -> Material.Matte.of(textures.reflectance(p, "reflectance", 0.5));
            case "roughdiffuse" -> roughDiffuse(p);
            case "dielectric", "thindielectric", "roughdielectric" -> dielectric(p);
            case "conductor", "roughconductor" -> conductor(p);
            case "plastic" -> plastic(p);
            case "roughplastic" -> {
                note(p, "roughplastic keeps the light that its roughness loses in Mitsuba, and is brighter");
                yield plastic(p);
            }
            case "principled", "principledthin" -> new PrincipledReader(scene, textures).material(p);
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

    private Material dielectric(Properties p) {
        double index = IndexOfRefraction.relative(p, "bk7");
        Texture.Amount roughness = roughnesses.amount(p);
        noteIfNotWhite(p, "specular_reflectance");
        Texture through = textures.reflectance(p, "specular_transmittance", 1);
        return Glass.of(through, index).withRoughness(roughness).withMultipleScattering(false);
    }

    private void noteIfNotWhite(Properties p, String name) {
        Optional<XmlElement> e = p.find(name);
        if (e.isPresent() && !textures.texture(e.get(), false).equals(Texture.of(Rgb.WHITE))) {
            note(p, p.element().described() + ": " + name + " becomes 1");
        }
    }

    private Material conductor(Properties p) {
        Texture.Amount roughness = roughnesses.amount(p);
        Texture color = textures.reflectance(p, "specular_reflectance", 1);
        String name = p.text("material", scene.isOld() ? "Cu" : "none");
        Optional<XmlElement> eta = p.find("eta");
        Glossy.Conductor conductor;
        if (eta.isPresent() || p.has("k")) {
            Rgb n = textures.color(p, "eta", 0);
            double outside = p.number("ext_eta", 1);
            conductor = n.max() == 0 && !p.has("k")
                    ? PERFECT
                    : new Glossy.Conductor(divided(n, outside), divided(textures.color(p, "k", 1), outside));
        } else if (name.equalsIgnoreCase("none")) {
            if (roughness.equals(Texture.Amount.of(0))) {
                return Material.Mirror.of(color);
            }
            conductor = PERFECT;
        } else {
            conductor = Glossy.Metal.of(name)
                    .orElseGet(() -> {
                        note(p, "the metal " + Plain.quoted(name) + " becomes chromium");
                        return Glossy.Metal.CHROMIUM;
                    })
                    .conductor();
        }
        return new Glossy(color, roughness, Optional.of(conductor), false, Rgb.BLACK, 0);
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
        Texture.Amount roughness = roughnesses.amount(p);
        Texture color = textures.reflectance(p, "diffuse_reflectance", 0.5);
        noteIfNotWhite(p, "specular_reflectance");
        if (index < 1 || index > Coated.LARGEST_INDEX) {
            note(p, "a coat of index of refraction " + index + " is left out");
            return Material.Matte.of(color);
        }
        return new Coated(color, roughness, index, p.flag("nonlinear", false), Rgb.BLACK, 0);
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
        return new Coated(
                textures.reflectance(p, "diffuse_reflectance", 0.5),
                RoughnessReader.ofAlpha(alpha),
                1.5,
                false,
                Rgb.BLACK,
                0);
    }

    private Material unknown(Properties p) {
        note(p, p.element().described() + " is not known; its surface becomes diffuse grey");
        p.element().children().forEach(c -> p.ignore(c.name()));
        return Material.Matte.of(Texture.of(Rgb.gray(0.5)));
    }
}
