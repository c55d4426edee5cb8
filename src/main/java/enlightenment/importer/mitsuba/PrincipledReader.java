package enlightenment.importer.mitsuba;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads Mitsuba's principled model: as our own, as plain metal, or as glass where most of its light is transmitted. */
final class PrincipledReader {
    private static final List<String> LEFT_OUT = List.of("anisotropic", "flatness", "spec_tint", "diff_trans");

    private final SceneIndex scene;
    private final TextureReader textures;

    PrincipledReader(SceneIndex scene, TextureReader textures) {
        this.scene = scene;
        this.textures = textures;
    }

    Material material(Properties p) {
        Texture color = textures.reflectance(p, "base_color", 0.5);
        double transmission = share(textures.number(p, "spec_trans", 0));
        p.ignore("main_specular_sampling_rate", "clearcoat_sampling_rate", "diffuse_reflectance_sampling_rate");
        Texture.Amount metallic = amount(p, "metallic", 0);
        if (metallic.equals(Texture.Amount.of(1))) {
            return metal(p, color);
        }
        LEFT_OUT.forEach(name -> leaveOut(p, name));
        double index = index(p);
        return transmission > 0 ? glass(p, color, transmission, metallic, index) : opaque(p, color, metallic, index);
    }

    /**
     * A surface that is metal all over: GGX with Schlick's term of the base colour, without light between facets, whatever the parameters of the dielectric
     * part are. That is {@code glossy}, unless there is a clear coat. Measured with Mitsuba 3.9: values are equal but for the masking, which is not
     * height-correlated there, as that of {@code roughconductor}.
     */
    private Material metal(Properties p, Texture color) {
        leaveOut(p, "anisotropic");
        LEFT_OUT.forEach(p::ignore);
        p.ignore("eta", "specular", "sheen", "sheen_tint");
        if (share(textures.number(p, "clearcoat", 0)) > 0) {
            return opaque(p, color, Texture.Amount.of(1), Coated.USUAL_INDEX);
        }
        p.ignore("clearcoat_gloss");
        return new Glossy(
                color,
                amount(p, "roughness", 0.5),
                Optional.empty(),
                false,
                Rgb.BLACK,
                0,
                Material.EmissionPattern.EVEN);
    }

    private void leaveOut(Properties p, String name) {
        Optional<XmlElement> e = p.find(name);
        boolean isZero = e.isPresent() && e.get().tag().equals("float") && p.number(name, 0) == 0;
        if (e.isPresent() && !isZero) {
            scene.note(p.element(), p.element().described() + ": " + name + " is left out");
        }
    }

    /** {@code eta}, or that of which {@code specular} is the reflectance at normal incidence divided by 0.08. */
    private double index(Properties p) {
        double specular = share(textures.number(p, "specular", 0.5));
        double index = p.number("eta", 2 / (1 - StrictMath.sqrt(0.08 * specular)) - 1);
        if (index >= 1 && index <= Coated.LARGEST_INDEX) {
            return index;
        }
        scene.note(p.element(), "an index of refraction of " + index + " becomes the nearest possible one");
        return StrictMath.min(StrictMath.max(index, 1), Coated.LARGEST_INDEX);
    }

    /**
     * A surface of Mitsuba's sum of lobes: a coat, which is ours but for the masking; metal, which lacks the light between facets; and a matte base, which
     * is Burley's (2012, section 5.3): nowhere Lambert's, and not dimmed by the coat. Measured with Mitsuba 3.9: within 2 % of Lambert's up to 50° from the
     * normal, at 70° from 12 % darker to 40 % brighter.
     */
    private Material opaque(Properties p, Texture color, Texture.Amount metallic, double index) {
        Texture.Amount roughness = amount(p, "roughness", 0.5);
        double clearcoat = share(textures.number(p, "clearcoat", 0));
        double gloss = share(textures.number(p, "clearcoat_gloss", 0));
        List<String> differences = new ArrayList<>();
        if (!metallic.equals(Texture.Amount.of(1)) && !isBlack(color)) {
            differences.add("another matte base");
        }
        if (!metallic.equals(Texture.Amount.of(0))) {
            differences.add("light between facets");
        }
        if (clearcoat > 0) {
            differences.add("a clear coat that takes light from what is below");
        }
        Principled.Sheen sheen = sheen(p);
        if (sheen.share() > 0) {
            differences.add("sheen that takes light from what is below");
        }
        if (!differences.isEmpty()) {
            scene.note(p.element(), p.element().described() + " has " + String.join(", and ", differences));
        }
        if (metallic.equals(Texture.Amount.of(0)) && index == 1 && clearcoat == 0 && sheen.share() == 0) {
            return Material.Matte.of(color);
        }
        // The clear coat's alpha is 0.1 without gloss and 0.001 with all of it.
        double alpha = 0.1 + (0.001 - 0.1) * gloss;
        return new Principled(
                color,
                metallic,
                roughness,
                index,
                1,
                new Principled.Clearcoat(
                        clearcoat, Texture.Amount.of(clearcoat > 0 ? RoughnessReader.ofAlpha(alpha) : 0)),
                sheen,
                Rgb.BLACK,
                0);
    }

    private static boolean isBlack(Texture color) {
        return color instanceof Texture.Solid s && s.color().linear().max() == 0;
    }

    /** What the sheen reflects is missing below it, and the largest component of its colour is 1: unlike Mitsuba's, it adds no light. */
    private Principled.Sheen sheen(Properties p) {
        double share = share(textures.number(p, "sheen", 0));
        double tint = share(textures.number(p, "sheen_tint", 0));
        return share == 0 ? Principled.Sheen.NONE : new Principled.Sheen(share, tint);
    }

    /** Each crossing of the surface filters by the root of the base colour. */
    private Material glass(Properties p, Texture color, double transmission, Texture.Amount metallic, double index) {
        double metal = metallic instanceof Texture.Amount.Constant constant ? constant.value() : 0;
        if (metallic instanceof Texture.Amount.Textured) {
            scene.note(p.element(), "the metal of a surface that transmits light is left out");
        }
        Texture.Amount roughness = amount(p, "roughness", 0.5);
        Glass clear = new Glass(root(p, color), index, transmission * (1 - metal), 0, true)
                .withRoughness(roughness)
                .withMultipleScattering(false);
        if (clear.transparency() < 1) {
            scene.note(
                    p.element(), p.element().described() + " has an opaque share that light inside of it meets, too");
            double rest = Math.min(metal / (1 - clear.transparency()), 1);
            return clear.withOpaque(opaque(p, color, Texture.Amount.of(rest), index));
        }
        if (p.has("clearcoat")) {
            leaveOut(p, "clearcoat");
        }
        p.ignore("clearcoat_gloss", "sheen_tint");
        leaveOut(p, "sheen");
        return clear;
    }

    private Texture root(Properties p, Texture color) {
        if (color instanceof Texture.Solid s) {
            return Texture.of(root(s.color()));
        }
        if (color instanceof Texture.Checker c) {
            return new Texture.Checker(
                    c.colors().stream().map(PrincipledReader::root).toList(), c.scale());
        }
        try {
            return scene.pictures().root((Texture.File) color, false);
        } catch (IOException problem) {
            scene.note(p.element(), "a texture is left out: " + problem.getMessage());
            return Texture.of(Rgb.WHITE);
        }
    }

    private static Color root(Color color) {
        Rgb c = color.linear();
        return new Rgb(StrictMath.sqrt(c.r()), StrictMath.sqrt(c.g()), StrictMath.sqrt(c.b()));
    }

    private Texture.Amount amount(Properties p, String name, double otherwise) {
        Optional<XmlElement> e = p.find(name);
        if (e.isEmpty()) {
            return Texture.Amount.of(otherwise);
        }
        Texture texture = textures.texture(e.get(), true);
        return texture instanceof Texture.Solid s
                ? Texture.Amount.of(share((s.color().linear().r()
                                + s.color().linear().g()
                                + s.color().linear().b())
                        / 3))
                : Texture.Amount.of(texture);
    }

    private static double share(double v) {
        return StrictMath.min(StrictMath.max(v, 0), 1);
    }
}
