package enlightenment.method.cluster;

/**
 * How far the camera rays of a block may be from what is asked for, whatever its first paths showed. The effort comes from some blocks
 * that were tried; what those did not show, or showed by a chance that does not repeat, would otherwise be answered by any multiple of
 * what is asked. With at most √P times the mean in a block, of P that were tried, a kind of block that none or one of them showed changes
 * the sum by about 1/√P; and a picture that is a single block gets just what is asked.
 */
public final class BlockLimits {
    /** No limits: of a method that only looks. */
    public static final BlockLimits NONE = new BlockLimits(0, 0, Double.POSITIVE_INFINITY);

    private final double mean;
    private final double least;
    private final double most;

    private BlockLimits(double mean, double least, double most) {
        this.mean = mean;
        this.least = least;
        this.most = most;
    }

    /**
     * @param samples the mean number of camera rays per pixel in blocks that show more than background
     * @param tried how many of them were tried
     */
    static BlockLimits of(double samples, int tried) {
        int blocks = Math.max(tried, 1);
        return new BlockLimits(samples, samples / blocks, samples * Math.sqrt(blocks));
    }

    /**
     * The same where all blocks that show something were tried, and they are few: none gets less than 1/√P either. Things smaller than a
     * pixel are missed by chance, and what is spent where nothing was seen is what finds them.
     *
     * @param samples the mean number of camera rays per pixel in blocks that show more than background
     * @param all how many of them there are
     */
    public static BlockLimits ofFew(double samples, int all) {
        double root = Math.sqrt(all);
        return new BlockLimits(samples, samples / root, samples * root);
    }

    /** The mean number of camera rays per pixel in blocks that show more than background; 0 if it is not known. */
    public double mean() {
        return mean;
    }

    /** What is spent on a block that needs this much. */
    public double limited(double samples) {
        return Math.min(Math.max(samples, least), most);
    }
}
