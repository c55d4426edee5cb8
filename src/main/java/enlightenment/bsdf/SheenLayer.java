package enlightenment.bsdf;

/**
 * The sheen of fibres that stand on a surface: a lobe at grazing directions, S = s C (1 − cosθ_d)⁵ with the share s, the colour C and the
 * angle θ_d between a direction and the half vector (B. Burley, "Physically based shading at Disney", 2012), and its transmittance to the
 * surface below, q(μ) = 1 − s E(μ) with the directional albedo E of the white lobe of share 1. Immutable.
 *
 * <p>The tint interpolates the colour from white to that of the surface; its largest component is 1, so that no band of q is less than
 * this.
 */
final class SheenLayer {
    /** The density of uniform directions on the hemisphere. */
    static final double DENSITY = 1 / (2 * Math.PI);

    private final double share;
    private final double tint;
    private final SheenAlbedo albedo;

    /**
     * Makes a layer.
     *
     * @param share s, 0..1; 0: there is none
     * @param tint the weight of the surface's colour in that of the lobe, 0..1
     */
    SheenLayer(double share, double tint, SheenAlbedo albedo) {
        this.share = share;
        this.tint = tint;
        this.albedo = albedo;
    }

    boolean isAbsent() {
        return share == 0;
    }

    /** The transmittance at a cosine, 0..1. */
    double through(double cosine) {
        return share == 0 ? 1 : 1 - share * albedo.at(cosine);
    }

    /** The white lobe's value, for the directions of s. */
    double lobe(Scattering s) {
        if (share == 0) {
            return 0;
        }
        // cos θ_d is half of the length of o + i.
        double x = s.ox + s.ix;
        double y = s.oy + s.iy;
        double z = s.oz + s.iz;
        double rest = Math.max(1 - 0.5 * Math.sqrt(x * x + y * y + z * z), 0);
        double rest2 = rest * rest;
        return share * rest2 * rest2 * rest;
    }

    /** A component of the lobe's colour. */
    double color(Scattering s, double component) {
        double most = Math.max(Math.max(s.red, s.green), s.blue);
        return most > 0 ? Math.fma(tint, component / most - 1, 1) : 1;
    }
}
