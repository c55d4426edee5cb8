package enlightenment.transport.media;

import enlightenment.world.material.HomogeneousMedium;

/**
 * How far a path flies freely in a medium that scatters light, and what such a flight is worth.
 *
 * <p>Where a medium's extinction differs between bands a flight is drawn for one of them, and weighted against all by the balance heuristic
 * (A. Wilkie et al., "Hero wavelength spectral sampling", 2014; J. Novák et al., "Monte Carlo methods for volumetric light transport
 * simulation", 2018). The weights are those of the whole way since the last opaque surface: there bands have shares by what the path
 * carries, none of them less than {@link #LEAST_SHARE}, and from flight to flight they become what is left of these, as if each band had
 * walked by itself. So the product of all weights of a band stays below the inverse of its first share, however long the walk. Where
 * the extinction does not differ every flight has the weight 1, and every scattering that of the medium's albedo. A mutable work object,
 * one per thread.
 */
public final class FreeFlight {
    /** The least probability of a band when a walk begins. */
    private static final double LEAST_SHARE = 0.1;

    /** In a medium without end nothing comes back from here. */
    private static final double FAR = 0x1p100;

    private HomogeneousMedium medium;

    /** Whether no flight has been drawn for a band since the walk began. */
    private boolean isFirst;

    /** The probabilities of the bands for the next flight; of a walk that has begun. */
    private double shareR;

    private double shareG;
    private double shareB;

    /** How far the path flies unless something is in its way. */
    public double length;

    /** By band: what {@link #pass} or {@link #scatter} multiply what the path carries by. */
    public double weightR;

    public double weightG;
    public double weightB;

    /** Begins a walk: what was flown until now does not matter for the next flight's band. */
    public void begin() {
        isFirst = true;
    }

    /**
     * Draws the length of a flight.
     *
     * @param r how much the path carries of red, and so on
     * @param u uniform in 0..1: the length
     * @param v uniform in 0..1: the band
     */
    public void draw(HomogeneousMedium in, double r, double g, double b, double u, double v) {
        medium = in;
        double extinction = in.extinctionR;
        if (!in.isGrey) {
            if (isFirst) {
                share(Math.abs(r), Math.abs(g), Math.abs(b));
                isFirst = false;
            }
            extinction = v < shareR ? in.extinctionR : v < shareR + shareG ? in.extinctionG : in.extinctionB;
        }
        length = extinction > 0 ? -StrictMath.log1p(-u) / extinction : Double.POSITIVE_INFINITY;
    }

    /** Sets the shares by what the path carries. */
    private void share(double r, double g, double b) {
        double sum = r + g + b;
        double scale = sum > 0 ? (1 - 3 * LEAST_SHARE) / sum : 0;
        double least = sum > 0 ? LEAST_SHARE : 1.0 / 3;
        shareR = Math.fma(r, scale, least);
        shareG = Math.fma(g, scale, least);
        shareB = Math.fma(b, scale, least);
    }

    /** The probability density, per length, of flights that end so far away. */
    public double density(double flown) {
        HomogeneousMedium m = medium;
        if (m.isGrey) {
            return m.extinctionR * transmittance(m.extinctionR, flown);
        }
        return shareR * m.extinctionR * transmittance(m.extinctionR, flown)
                + shareG * m.extinctionG * transmittance(m.extinctionG, flown)
                + shareB * m.extinctionB * transmittance(m.extinctionB, flown);
    }

    /** Sets the weights of light that is scattered so far away, per length: of whatever comes there along the flight, for sure. */
    public void scatterAt(double flown) {
        weightR = medium.scatteringR * transmittance(medium.extinctionR, flown);
        weightG = medium.scatteringG * transmittance(medium.extinctionG, flown);
        weightB = medium.scatteringB * transmittance(medium.extinctionB, flown);
    }

    /** Whether the flight leaves everything behind. */
    public boolean isEndless() {
        return length > FAR;
    }

    /** Sets the weights of a flight without scattering: transmittances over their mean. */
    public void pass(double flown) {
        if (medium.isGrey) {
            set(flown == Double.POSITIVE_INFINITY && medium.extinctionR > 0 ? 0 : 1);
        } else {
            weigh(flown, 1, 1, 1, 1, 1, 1);
            carryOn();
        }
    }

    /**
     * Sets the weights of having come so far, no farther than {@link #length}, whatever follows: transmittances over their mean. The flight
     * goes on as before.
     */
    public void reach(double flown) {
        if (medium.isGrey) {
            set(1);
        } else {
            weigh(flown, 1, 1, 1, 1, 1, 1);
        }
    }

    /** The same of one that ends by scattering. */
    public void scatter() {
        HomogeneousMedium m = medium;
        if (m.isGrey) {
            weightR = m.scatteringR / m.extinctionR;
            weightG = m.scatteringG / m.extinctionG;
            weightB = m.scatteringB / m.extinctionB;
        } else {
            weigh(length, m.scatteringR, m.scatteringG, m.scatteringB, m.extinctionR, m.extinctionG, m.extinctionB);
            carryOn();
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

    /** The shares change as what the path carries does. */
    private void carryOn() {
        double red = shareR * weightR;
        double green = shareG * weightG;
        double blue = shareB * weightB;
        double sum = red + green + blue;
        if (sum > 0) {
            shareR = red / sum;
            shareG = green / sum;
            shareB = blue / sum;
        }
    }

    private static double transmittance(double extinction, double flown) {
        return extinction > 0 ? StrictMath.exp(-extinction * flown) : 1;
    }
}
