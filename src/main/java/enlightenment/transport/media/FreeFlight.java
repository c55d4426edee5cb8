package enlightenment.transport.media;

import enlightenment.numeric.Exponential;
import enlightenment.world.material.HomogeneousMedium;

/**
 * Samples the free-flight distance of a path in a medium, and the throughput weights of the flight.
 *
 * <p>Where extinction differs between bands, a distance is sampled for one of them, and weighted against all by the balance heuristic (A.
 * Wilkie et al., "Hero wavelength spectral sampling", 2014; J. Novák et al., "Monte Carlo methods for volumetric light transport
 * simulation", 2018). The probabilities of the bands belong to the whole walk since the last opaque surface: they begin in proportion to
 * the throughput, none of them less than {@link #LEAST_SHARE}, and are multiplied by each flight's weights, as if each band had walked by
 * itself. So the product of all weights of a band stays below the inverse of its first probability, however long the walk. Where extinction
 * does not differ, every flight has weight 1, and every scattering event that of the albedo. A mutable work object, one per thread.
 */
public final class FreeFlight {
    /** The least probability of a band when a walk begins. */
    private static final double LEAST_SHARE = 0.1;

    /** A flight in an unbounded medium that is longer than this, in the frame, never returns. */
    private static final double FAR = 0x1p100;

    private HomogeneousMedium medium;

    /** Whether no band has been sampled since the walk began. */
    private boolean isFirst;

    /** The probability of each band for the next flight of a walk that has begun. */
    private double shareR;

    private double shareG;
    private double shareB;

    /** The sampled free-flight distance, in the frame; a surface may come before it. */
    public double length;

    /** The throughput weight of the last {@link #pass}, {@link #scatter}, {@link #reach} or {@link #scatterAt}, by band. */
    public double weightR;

    public double weightG;
    public double weightB;

    /** Begins a walk, whose first band is sampled by the throughput alone. */
    public void begin() {
        isFirst = true;
    }

    /**
     * Samples the free-flight distance.
     *
     * @param r throughput of red; g and b that of green and blue
     * @param u uniform in 0..1: the distance
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

    /** Sets the probabilities of the bands in proportion to the throughput. */
    private void share(double r, double g, double b) {
        double sum = r + g + b;
        double scale = sum > 0 ? (1 - 3 * LEAST_SHARE) / sum : 0;
        double least = sum > 0 ? LEAST_SHARE : 1.0 / 3;
        shareR = Math.fma(r, scale, least);
        shareG = Math.fma(g, scale, least);
        shareB = Math.fma(b, scale, least);
    }

    /** The density, per length of the frame, of flights that end by scattering at this distance. */
    public double density(double flown) {
        HomogeneousMedium m = medium;
        if (m.isGrey) {
            return m.extinctionR * transmittance(m.extinctionR, flown);
        }
        return shareR * m.extinctionR * transmittance(m.extinctionR, flown)
                + shareG * m.extinctionG * transmittance(m.extinctionG, flown)
                + shareB * m.extinctionB * transmittance(m.extinctionB, flown);
    }

    /**
     * Sets the weights of scattering at this distance, per length, without the density of flights: scattering coefficient times
     * transmittance.
     */
    public void scatterAt(double flown) {
        weightR = medium.scatteringR * transmittance(medium.extinctionR, flown);
        weightG = medium.scatteringG * transmittance(medium.extinctionG, flown);
        weightB = medium.scatteringB * transmittance(medium.extinctionB, flown);
    }

    /** Whether the flight leaves the scene unless a surface comes before. */
    public boolean isEndless() {
        return length > FAR;
    }

    /** Sets the weights of a flight of this length without scattering: transmittances over their mean. The walk goes on. */
    public void pass(double flown) {
        if (medium.isGrey) {
            set(flown == Double.POSITIVE_INFINITY && medium.extinctionR > 0 ? 0 : 1);
        } else {
            weigh(flown, 1, 1, 1, 1, 1, 1);
            carryOn();
        }
    }

    /**
     * Sets the weights of reaching this distance, at most {@link #length}, whatever follows: transmittances over their mean. Unlike
     * {@link #pass} it leaves the flight as it is.
     */
    public void reach(double flown) {
        if (medium.isGrey) {
            set(1);
        } else {
            weigh(flown, 1, 1, 1, 1, 1, 1);
        }
    }

    /**
     * Sets the weights of a flight that ends by scattering at {@link #length}: scattering coefficient times transmittance, over the mean of
     * extinction times transmittance. The walk goes on.
     */
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

    /** Sets the weights to numbers by band times transmittances, over the mean of other numbers times transmittances. */
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

    /** Multiplies the probabilities of the bands by the weights. */
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
        return extinction > 0 ? Exponential.exp(-extinction * flown) : 1;
    }
}
