package enlightenment.importer.pbrt;

import enlightenment.importer.support.ImportNotes;

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

    /** @param prefix of the parameters' names, such as {@code "conductor."} */
    double of(Parameters p, String prefix) {
        double both = number(p, prefix + "roughness", 0);
        double u = alpha(p, number(p, prefix + "uroughness", both));
        double v = alpha(p, number(p, prefix + "vroughness", both));
        if (u != v) {
            notes.add(
                    p.place().shown(),
                    "a surface that is rougher in one direction becomes one of the mean roughness, sqrt(alpha_u alpha_v)");
        }
        double alpha = StrictMath.sqrt(u * v);
        return alpha < SMOOTH ? 0 : StrictMath.sqrt(alpha);
    }

    private double number(Parameters p, String name, double usual) {
        return textures.mean(textures.number(p, name, usual), p.place(), "the roughness");
    }

    private static double alpha(Parameters p, double roughness) {
        double r = Math.min(Math.max(roughness, 0), 1);
        return p.isTrue("remaproughness", true) ? StrictMath.sqrt(r) : r;
    }
}
