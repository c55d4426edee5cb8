package enlightenment.plan;

import enlightenment.film.FilmTile;
import enlightenment.scene.Method;

/**
 * The traits of a method that planning needs before there is a scene.
 *
 * @param areBatches whether its units of work are batches of paths, whose light may fall anywhere in the picture, rather than tiles
 * @param dividesIntoPasses whether the samples of a tile can be taken in several passes
 * @param below the method that is used where there are too few samples for this one; itself if there never are
 * @param fewest the smallest number of samples per pixel that it can do with
 * @param mostBelow the largest number with three digits that is still too few
 * @param first the number of samples per pixel that a search for an error begins with where the method itself is used
 * @param blockSide side, in pixels, of the blocks of the whole picture that are rendered as one, so that no tile is to be cut through
 *     any: a multiple of {@link FilmTile#BLOCK_SIDE}, which is what it is where tiles may be cut anywhere
 */
public record MethodTraits(
        boolean areBatches,
        boolean dividesIntoPasses,
        Method below,
        double fewest,
        double mostBelow,
        double first,
        int blockSide) {
    /** The number of samples that a search for an error begins with where every number will do. */
    private static final double FIRST_SAMPLES = 2;

    /** A method that can do with one sample per pixel. */
    static MethodTraits ofAnySamples(Method method, boolean dividesIntoPasses) {
        return new MethodTraits(
                method.kind() == Method.Kind.SPLATS,
                dividesIntoPasses,
                method,
                1,
                0,
                FIRST_SAMPLES,
                FilmTile.BLOCK_SIDE);
    }
}
