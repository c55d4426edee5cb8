package enlightenment.importer.pbrt;

import enlightenment.importer.support.ImportNotes;
import enlightenment.material.Texture;

/** The roughness of microscopic facets: pbrt's parameters as one number of ours, the root of the parameter alpha of the distribution GGX. */
final class Roughness {
    /** Below this alpha pbrt takes surfaces for smooth. */
    private static final double SMOOTH = 1e-3;

    private final Textures textures;
    private final ImportNotes notes;

    Roughness(Textures textures, ImportNotes notes) {
        this.textures = textures;
        this.notes = notes;
    }

    /**
     * One that may depend on the place.
     *
     * @param prefix of the parameters' names, such as {@code "conductor."}
     * @param uv where the map of texture coordinates is left
     */
    Texture.Amount amount(Parameters p, String prefix, UvChoice uv) {
        String u = source(p, prefix, "u");
        String v = source(p, prefix, "v");
        if (!p.isTexture(u) || !p.isTexture(v) || !p.string(u, "").equals(p.string(v, ""))) {
            return Texture.Amount.of(of(p, prefix));
        }
        ResolvedTexture t = textures.number(p, u, 0);
        if (t.isSolid()) {
            return Texture.Amount.of(of(p, prefix));
        }
        boolean isRemapped = p.isTrue("remaproughness", true);
        String what = "roughness of " + (isRemapped ? "sqrt alpha" : "alpha");
        return new Texture.Amount.Textured(
                uv.number(t, what, x -> ofAlpha(alpha(x, isRemapped))), Texture.Amount.Channel.RED, 1);
    }

    /** The parameter that has the roughness along a direction. */
    private static String source(Parameters p, String prefix, String direction) {
        String own = prefix + direction + "roughness";
        return p.has(own) ? own : prefix + "roughness";
    }

    /** @param prefix of the parameters' names, such as {@code "conductor."} */
    double of(Parameters p, String prefix) {
        double both = number(p, prefix + "roughness", 0);
        boolean isRemapped = p.isTrue("remaproughness", true);
        double u = alpha(number(p, prefix + "uroughness", both), isRemapped);
        double v = alpha(number(p, prefix + "vroughness", both), isRemapped);
        if (u != v) {
            notes.add(
                    p.place().shown(),
                    "a surface that is rougher in one direction becomes one of the mean roughness, sqrt(alpha_u alpha_v)");
        }
        return ofAlpha(StrictMath.sqrt(u * v));
    }

    private static double ofAlpha(double alpha) {
        return alpha < SMOOTH ? 0 : StrictMath.sqrt(alpha);
    }

    private double number(Parameters p, String name, double usual) {
        return textures.mean(textures.number(p, name, usual), p.place(), "the roughness");
    }

    private static double alpha(double roughness, boolean isRemapped) {
        double r = Math.min(Math.max(roughness, 0), 1);
        return isRemapped ? StrictMath.sqrt(r) : r;
    }
}
