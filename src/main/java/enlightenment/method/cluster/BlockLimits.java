package enlightenment.method.cluster;

/**
 * Limits of the camera rays per pixel of a block, relative to the number asked for, whatever its first paths showed. The effort is fitted
 * to some blocks that were tried; what these did not show, or showed by chance, could otherwise cost any multiple of what is asked. At most
 * √P times the mean in a block, of P tried, a kind of block that none or one of them showed changes the sum by about 1/√P; and a picture of
 * a single block gets just what is asked.
 */
public final class BlockLimits {
    /** No limits, for a method that only surveys. */
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
     * @param tried the number of these blocks that were tried
     */
    static BlockLimits of(double samples, int tried) {
        int blocks = Math.max(tried, 1);
        return new BlockLimits(samples, samples / blocks, samples * Math.sqrt(blocks));
    }

    /**
     * The limits where all blocks that show something were tried, and they are few: none gets less than 1/√P of the mean either. Objects
     * smaller than a pixel are missed at random, and samples spent where nothing was seen are what finds them.
     *
     * @param samples the mean number of camera rays per pixel in blocks that show more than background
     * @param all the number of these blocks
     */
    public static BlockLimits ofFew(double samples, int all) {
        double root = Math.sqrt(all);
        return new BlockLimits(samples, samples / root, samples * root);
    }

    /** The mean number of camera rays per pixel in blocks that show more than background; 0 if it is not known. */
    public double mean() {
        return mean;
    }

    /** The number of camera rays per pixel for a block that needs this many, within the limits. */
    public double limited(double samples) {
        return Math.min(Math.max(samples, least), most);
    }
}
