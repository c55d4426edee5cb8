package enlightenment.shading;

import enlightenment.compiled.HomogeneousMedium;

/**
 * How far a path flies freely in a medium that scatters light, and what such a flight is worth.
 *
 * <p>Where a medium's extinction differs between bands a flight is drawn for one of them, chosen by what the path carries, and weighted
 * against all by the balance heuristic (A. Wilkie et al., "Hero wavelength spectral sampling", 2014; J. Novák et al., "Monte Carlo methods
 * for volumetric light transport simulation", 2018): no weight exceeds the inverse of {@link #LEAST_SHARE}. Where it does not, every
 * flight has the weight 1, and every scattering that of the medium's albedo. A mutable work object, one per thread.
 */
final class FreeFlight {
    /** The least probability of a band. */
    private static final double LEAST_SHARE = 0.1;

    /** In a medium without end nothing comes back from here. */
    private static final double FAR = 0x1p100;

    private HomogeneousMedium medium;

    /** The probabilities of the bands, unless the medium is grey. */
    private double shareR;

    private double shareG;
    private double shareB;

    /** How far the path flies unless something is in its way. */
    double length;

    /** By band: what {@link #pass} or {@link #scatter} multiply what the path carries by. */
    double weightR;

    double weightG;
    double weightB;

    /**
     * Draws the length of a flight.
     *
     * @param r how much the path carries of red, and so on
     * @param u uniform in 0..1: the length
     * @param v uniform in 0..1: the band
     */
    void draw(HomogeneousMedium in, double r, double g, double b, double u, double v) {
        medium = in;
        double extinction = in.extinctionR;
        if (!in.isGrey) {
            double sum = Math.abs(r) + Math.abs(g) + Math.abs(b);
            double scale = sum > 0 ? (1 - 3 * LEAST_SHARE) / sum : 0;
            shareR = Math.fma(Math.abs(r), scale, LEAST_SHARE);
            shareG = Math.fma(Math.abs(g), scale, LEAST_SHARE);
            shareB = Math.fma(Math.abs(b), scale, LEAST_SHARE);
            extinction = v < shareR ? in.extinctionR : v < shareR + shareG ? in.extinctionG : in.extinctionB;
        }
        length = extinction > 0 ? -StrictMath.log1p(-u) / extinction : Double.POSITIVE_INFINITY;
    }

    /** Whether the flight leaves everything behind. */
    boolean isEndless() {
        return length > FAR;
    }

    /** Sets the weights of a flight without scattering: transmittances over their mean. */
    void pass(double flown) {
        if (medium.isGrey) {
            set(flown == Double.POSITIVE_INFINITY && medium.extinctionR > 0 ? 0 : 1);
        } else {
            weigh(flown, 1, 1, 1, 1, 1, 1);
        }
    }

    /** The same of one that ends by scattering. */
    void scatter() {
        HomogeneousMedium m = medium;
        if (m.isGrey) {
            weightR = m.scatteringR / m.extinctionR;
            weightG = m.scatteringG / m.extinctionG;
            weightB = m.scatteringB / m.extinctionB;
        } else {
            weigh(length, m.scatteringR, m.scatteringG, m.scatteringB, m.extinctionR, m.extinctionG, m.extinctionB);
        }
    }

    private void set(double weight) {
        weightR = weight;
        weightG = weight;
        weightB = weight;
    }

    /** Numbers by band times transmittances, over the mean of other numbers times transmittances. */
    private void weigh(double flown, double r, double g, double b, double overR, double overG, double overB) {
        double red = transmittance(medium.extinctionR, flown);
        double green = transmittance(medium.extinctionG, flown);
        double blue = transmittance(medium.extinctionB, flown);
        double density = shareR * red * overR + shareG * green * overG + shareB * blue * overB;
        double scale = density > 0 ? 1 / density : 0;
        weightR = r * red * scale;
        weightG = g * green * scale;
        weightB = b * blue * scale;
    }

    private static double transmittance(double extinction, double flown) {
        return extinction > 0 ? StrictMath.exp(-extinction * flown) : 1;
    }
}
