package enlightenment.method;

import enlightenment.film.SplatBatch;

/**
 * Follows numbered paths that may reach any pixel, as those of light from its source to the eye. All random numbers of a path are
 * pure functions of the seed and the path's number; so it does not matter who follows which paths, in which order, and in batches of
 * which size.
 */
public non-sealed interface SplatIntegrator extends Integrator {
    /**
     * What a path adds to the picture, in the mean over all paths, as deterministically known before the first: the sum of its
     * contributions ({@link SplatBatch#add}), mean of the three components. This is the mean of the picture's pixels. Chooses the
     * unit in which contributions are summed ({@link enlightenment.film.SplatScale}); a factor of a thousand off does no harm. A
     * function of scene and settings; not negative, finite; 0 where nothing shines.
     */
    double expectedContribution();

    /**
     * Follows paths and adds what they contribute.
     *
     * @param firstPath the number of the first, from 0
     * @param paths how many there are, with consecutive numbers
     * @param out begun for these paths ({@link SplatBatch#begin})
     * @throws java.util.concurrent.CancellationException as {@link #stopWhen} tells; the batch is then of no use
     */
    void trace(long firstPath, int paths, SplatBatch out);
}
