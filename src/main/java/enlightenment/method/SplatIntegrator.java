package enlightenment.method;

import enlightenment.film.SplatBatch;

/**
 * Traces numbered paths that may reach any pixel, such as light paths. All random numbers of a path are pure functions of the seed and the
 * path's number, so that threads, order and sizes of batches do not change the result.
 */
public non-sealed interface SplatIntegrator extends Integrator {
    /**
     * The expected contribution of a path to the picture, known deterministically before the first path: the mean over all paths of the sum
     * of a path's splats ({@link SplatBatch#add}), averaged over three components; it is the mean of the picture's pixels. Sets the unit in
     * which splats are summed ({@link enlightenment.film.SplatScale}), where an error by a factor of a thousand does no harm. A function of
     * scene and settings; finite, not negative; 0 where the scene has no light.
     */
    double expectedContribution();

    /**
     * Traces paths and adds their splats.
     *
     * @param firstPath the number of the first, from 0
     * @param paths the number of paths, with consecutive numbers
     * @param out begun for these paths ({@link SplatBatch#begin})
     * @throws java.util.concurrent.CancellationException once the condition of {@link #stopWhen} holds; the batch is then of no use
     */
    void trace(long firstPath, int paths, SplatBatch out);
}
