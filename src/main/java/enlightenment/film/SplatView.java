package enlightenment.film;

/** The sums of a film of splats as they stand, to be read by one thread, row by row. */
@FunctionalInterface
interface SplatView {
    /** The units of component c of a pixel, by its place in the whole picture, that the paths of a group brought. */
    long sum(int column, int row, int c, int group);
}
