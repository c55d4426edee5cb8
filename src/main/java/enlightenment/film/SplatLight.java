package enlightenment.film;

/** The light of a film of splats as it stands, to be read by one thread, row by row. */
final class SplatLight {
    /** The factor of the upper half of a sum. */
    private static final double HIGH = 1L << Integer.SIZE;

    private final SplatView sums;
    private final SplatScale scale;
    private final long picturePixels;
    private final long[] groupPaths;
    private final long paths;

    /**
     * @param picturePixels number of pixels of the whole picture
     * @param groupPaths the number of paths of each group
     */
    SplatLight(SplatView sums, SplatScale scale, long picturePixels, long[] groupPaths) {
        this.sums = sums;
        this.scale = scale;
        this.picturePixels = picturePixels;
        this.groupPaths = groupPaths.clone();
        long all = 0;
        for (long n : groupPaths) {
            all += n;
        }
        paths = all;
    }

    /** The number of paths of all groups. */
    long paths() {
        return paths;
    }

    /** The number of paths of a group. */
    long paths(int group) {
        return groupPaths[group];
    }

    /** Component c of a pixel, by its place in the whole picture, in full precision; 0 without paths. */
    double all(int column, int row, int c) {
        long high = 0;
        long low = 0;
        for (int group = 0; group < groupPaths.length; group++) {
            long sum = sums.sum(column, row, c, group);
            high += sum >> 32;
            low += sum & 0xffffffffL;
        }
        return paths == 0 ? 0 : inPicture(high * HIGH + low, paths);
    }

    /** As {@link #all}, by the paths of one of the groups alone; 0 if it has none. */
    double of(int group, int column, int row, int c) {
        long n = groupPaths[group];
        return n == 0 ? 0 : inPicture(sums.sum(column, row, c, group), n);
    }

    /** The value of a pixel by the units of some paths. */
    private double inPicture(double units, long n) {
        // Most pixels of most pictures were not reached.
        return units == 0 ? 0 : scale.value(units * picturePixels / n);
    }
}
