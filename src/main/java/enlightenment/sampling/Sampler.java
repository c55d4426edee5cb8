package enlightenment.sampling;

/**
 * The source of a path's random numbers. Every number has an address: the film position, or a purpose at a bounce. For the same address a
 * sampler always returns the same number; neither the order of calls nor other calls change it. All numbers lie in [0, 1), and over all
 * samples each is uniform and independent of the others.
 *
 * <p>The code that starts paths sets the sampler to the next sample; code that traces them only reads numbers. One per thread.
 */
public interface Sampler {
    /** The purpose of a number. */
    enum Purpose {
        /** Direction sampling of the path's next segment. */
        DIRECTION,
        /** Selects one of several lobes, lights or other alternatives. */
        CHOICE,
        /** Russian roulette. */
        ROULETTE,
        /** The point on the single sampled light. */
        LIGHT,
        /** The point of a light's image in a mirror. */
        MIRROR,
        /** The light, point and direction at which a light path begins. */
        EMISSION,
        /** {@link #DIRECTION} of a path from a light. */
        LIGHT_DIRECTION,
        /** {@link #CHOICE} of a path from a light. */
        LIGHT_CHOICE,
        /** {@link #ROULETTE} of a path from a light. */
        LIGHT_ROULETTE,
        /** The length of a free flight in a medium; the address counts flights in place of bounces. */
        FLIGHT,
        /** The wavelength of a path, the first of a pair; at bounce 0. */
        WAVELENGTH,
        /** {@link #FLIGHT} of a path from a light. */
        LIGHT_FLIGHT,
        /** The vertices of two subpaths to connect, where there are too many. */
        CONNECTION,
        /**
         * The lamp, and the point of a flight in a medium, for equiangular sampling; the address counts flights, as for {@link #FLIGHT}.
         */
        FLIGHT_LAMP,
        /** The point on that lamp. */
        FLIGHT_LIGHT,
        /** The point of the lens at which a path from the eye begins; at bounce 0. */
        LENS,
        /** The point of the lens, or one of two eyes, to which a vertex of a light path is connected. */
        LIGHT_LENS,
        /** The moment that a path sees while the shutter is open; at bounce 0. */
        TIME
    }

    /** Horizontal position within the pixel, or whatever part of the film is sampled: 0 is its left side. */
    double filmX();

    /** Vertical position: 0 is its upper side. */
    double filmY();

    /** A single number, which need not be stratified over the samples of a pixel. */
    double unit(int bounce, Purpose purpose);

    /** A point of the unit square; the samples of a pixel are stratified if the sampler can do that. */
    void pair(int bounce, Purpose purpose, double[] out);

    /**
     * Sets the points of a light that {@link #lightX} and {@link #lightY} return until the next call: {@code count} points of the unit
     * square, which are well distributed together with those of the pixel's other samples with the same count.
     *
     * @param light the light's index
     * @param bounce the number of surfaces before on the path
     */
    void lightPoints(int light, int bounce, int count);

    /** First coordinate of point k, below the count of {@link #lightPoints}. */
    double lightX(int k);

    /** Second coordinate of point k. */
    double lightY(int k);
}
