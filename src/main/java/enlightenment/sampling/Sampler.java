package enlightenment.sampling;

/**
 * Where a path's random numbers come from. Every number has an address: the place on the film, or what it is for at which bounce.
 * Asked twice for the same address, a sampler gives the same number; in which order, and whether others are asked for, changes
 * nothing. All numbers lie in [0, 1), and over all samples each is uniform and independent of the others.
 *
 * <p>Whoever makes paths sets the sampler to the next one; whoever follows a path only asks. One per thread.
 */
public interface Sampler {
    /** What a number is for. */
    enum Purpose {
        /** The direction in which a path goes on. */
        DIRECTION,
        /** Which of several lobes, lights or ways to go on is chosen. */
        CHOICE,
        /** Whether a path goes on at all. */
        ROULETTE,
        /** The point of the one light that is sampled. */
        LIGHT,
        /** The point of a light's image in a mirror. */
        MIRROR,
        /** Where on which light, and in which direction, a path from a light begins. */
        EMISSION,
        /** {@link #DIRECTION} of a path from a light. */
        LIGHT_DIRECTION,
        /** {@link #CHOICE} of a path from a light. */
        LIGHT_CHOICE,
        /** {@link #ROULETTE} of a path from a light. */
        LIGHT_ROULETTE,
        /** How far a path goes in a medium that scatters light; counted by such ways, not by bounces. */
        FLIGHT,
        /** The wavelength of a path, the first of a pair; at bounce 0. */
        WAVELENGTH,
        /** {@link #FLIGHT} of a path from a light. */
        LIGHT_FLIGHT,
        /** Which vertices of two paths are connected, where there are too many. */
        CONNECTION,
        /** Which lamp a flight in a medium gathers light of, and at which of its points; counted as {@link #FLIGHT}. */
        FLIGHT_LAMP,
        /** {@link #LIGHT} of that lamp. */
        FLIGHT_LIGHT,
        /** Where on the lens a path from the eye begins; at bounce 0. */
        LENS,
        /** Where on the lens, or at which of two eyes, a vertex of a path from a light is connected to the eye. */
        LIGHT_LENS,
        /** Which moment a path sees while the shutter is open; at bounce 0. */
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
     * Turns to the points of a light, until it is turned to others: {@code count} points of the unit square, which are well
     * distributed together with those of the pixel's other samples that take as many.
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
