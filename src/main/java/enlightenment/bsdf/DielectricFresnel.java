package enlightenment.bsdf;

/**
 * Fresnel's equations at a smooth interface of two dielectrics (M. Born and E. Wolf, "Principles of Optics", 1999, section 1.5.2), in
 * forms that do not cancel: with c and c' the cosines of incidence and refraction, (ηc)² − c'² = η² − 1 exactly, so
 * r_s = (η² − 1)/(ηc + c')²; and r_p = −r_s·cos(θ + θ')/cos(θ − θ'). They are 0 where η is 1 and accurate near it.
 */
public final class DielectricFresnel {
    private DielectricFresnel() {}

    /**
     * The Fresnel reflectance F of unpolarised light, 0..1; 1 for total internal reflection.
     *
     * @param c the cosine of the angle of incidence, 0..1
     * @param eta the index on the side of incidence over that of the other side, positive
     */
    public static double reflectance(double c, double eta) {
        double s = perpendicular(c, eta);
        return s < 1 ? 0.5 * (s + s * parallelRatio(c, eta)) : 1;
    }

    /**
     * A lower bound, 0..1, of {@link #reflectance} over all relative indices of a range, and close to the minimum: for each polarisation
     * the minimum is at an end of the range, unless the range contains the index 1, or the one for which c is Brewster's angle.
     *
     * @param c the cosine of the angle of incidence, 0..1
     * @param first one end of the range of relative indices
     * @param last the other
     */
    public static double leastReflectance(double c, double first, double last) {
        if ((first - 1) * (last - 1) <= 0) {
            return 0;
        }
        double s = Math.min(perpendicular(c, first), perpendicular(c, last));
        double sine = Math.sqrt(Math.max((1 - c) * (1 + c), 0));
        boolean vanishes = (first * sine - c) * (last * sine - c) <= 0;
        double p = vanishes ? 0 : Math.min(parallel(c, first), parallel(c, last));
        return 0.5 * (s + p);
    }

    private static double parallel(double c, double eta) {
        double s = perpendicular(c, eta);
        return s < 1 ? s * parallelRatio(c, eta) : 1;
    }

    /**
     * The transmittance for unpolarised light, from the cosines of incidence and refraction, both positive: near total internal reflection
     * one cannot be computed accurately from the other. The same from both sides.
     */
    static double transmittance(double c, double through, double eta) {
        double perpendicular = 1 / Math.fma(eta, c, through);
        double parallel = 1 / Math.fma(eta, through, c);
        double s = c * perpendicular * (through * perpendicular);
        double p = c * parallel * (through * parallel);
        return 2 * eta * (s + p);
    }

    /**
     * The reflectance of unpolarised light at a thin slab with two parallel faces, all inter-reflections included: 2R/(1 + R) for each
     * polarisation, because parallel faces do not mix them.
     */
    static double paneReflectance(double c, double eta) {
        double s = perpendicular(c, eta);
        if (!(s < 1)) {
            return 1;
        }
        double p = s * parallelRatio(c, eta);
        return s / (1 + s) + p / (1 + p);
    }

    /** The squared cosine of the angle of refraction; negative for total internal reflection. */
    static double refracted2(double c, double eta) {
        double etaCos = eta * c;
        return Math.fma(etaCos, etaCos, (1 - eta) * (1 + eta));
    }

    /** The reflectance of light that is polarised perpendicularly to the plane of incidence, at most 1. */
    private static double perpendicular(double c, double eta) {
        if (eta == 1) {
            return 0;
        }
        double through2 = refracted2(c, eta);
        if (!(through2 >= 0)) {
            return 1;
        }
        double sum = Math.fma(eta, c, Math.sqrt(through2));
        double r = (eta - 1) * (eta + 1) / (sum * sum);
        return Math.min(r * r, 1);
    }

    /** The ratio of the reflectance of parallel polarisation to that of perpendicular polarisation, where light is refracted. */
    private static double parallelRatio(double c, double eta) {
        double cosines = c * Math.sqrt(refracted2(c, eta));
        double sines = eta * Math.max((1 - c) * (1 + c), 0);
        double sum = cosines + sines;
        double ratio = sum > 0 ? (cosines - sines) / sum : 1;
        return ratio * ratio;
    }
}
