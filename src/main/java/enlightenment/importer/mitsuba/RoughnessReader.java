package enlightenment.importer.mitsuba;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import enlightenment.text.Plain;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reads the parameter alpha of rough models as our roughness: alpha is its square. */
final class RoughnessReader {
    private static final double USUAL_ALPHA = 0.1;

    private final SceneIndex scene;
    private final TextureReader textures;

    RoughnessReader(SceneIndex scene, TextureReader textures) {
        this.scene = scene;
        this.textures = textures;
    }

    /** The roughness of an alpha. */
    static double ofAlpha(double alpha) {
        return StrictMath.sqrt(StrictMath.min(StrictMath.max(alpha, 0), 1));
    }

    /** The roughness, which may depend on the place; 0 of a smooth model. */
    Texture.Amount amount(Properties p) {
        if (!isRough(p)) {
            return Texture.Amount.of(0);
        }
        Optional<XmlElement> alpha = p.find("alpha");
        if (isAnisotropic(p)) {
            return Texture.Amount.of(ofAlpha(mean(p)));
        }
        return alpha.map(this::amount).orElseGet(() -> Texture.Amount.of(ofAlpha(USUAL_ALPHA)));
    }

    private Texture.Amount amount(XmlElement alpha) {
        Texture texture = textures.texture(alpha, true);
        if (texture instanceof Texture.Solid s) {
            return Texture.Amount.of(ofAlpha(mean(s.color())));
        }
        if (texture instanceof Texture.Checker c) {
            List<Color> roots = c.colors().stream()
                    .map(x -> (Color) Rgb.gray(ofAlpha(mean(x))))
                    .toList();
            return Texture.Amount.of(new Texture.Checker(roots, c.scale()));
        }
        try {
            return Texture.Amount.of(scene.pictures().root((Texture.File) texture, true));
        } catch (IOException problem) {
            scene.note(alpha, "a texture of alpha is left out: " + problem.getMessage());
            return Texture.Amount.of(ofAlpha(USUAL_ALPHA));
        }
    }

    private static double mean(Color color) {
        Rgb c = color.linear();
        return (c.r() + c.g() + c.b()) / 3;
    }

    private boolean isRough(Properties p) {
        if (!p.element().type().startsWith("rough")) {
            return false;
        }
        String distribution = p.text("distribution", "beckmann").toLowerCase(Locale.ROOT);
        if (!distribution.equals("ggx")) {
            scene.note(p.element(), "the distribution " + Plain.quoted(distribution) + " becomes ggx of equal alpha");
        }
        p.ignore("sample_visible");
        return true;
    }

    private static boolean isAnisotropic(Properties p) {
        return p.has("alpha_u") || p.has("alpha_v");
    }

    /** One alpha for two. */
    private double mean(Properties p) {
        double u = textures.number(p, "alpha_u", USUAL_ALPHA);
        double v = textures.number(p, "alpha_v", USUAL_ALPHA);
        if (u != v) {
            scene.note(p.element(), "an anisotropic surface becomes one of alpha sqrt(alpha_u alpha_v)");
        }
        return StrictMath.sqrt(StrictMath.max(u * v, 0));
    }
}
