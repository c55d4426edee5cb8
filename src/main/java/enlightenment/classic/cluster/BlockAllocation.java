package enlightenment.classic.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.method.cluster.BlockLimits;
import enlightenment.method.cluster.EffortSearch;

/** The allocation of a block, with an effort for which its camera rays stay within limits, if there are any. */
final class BlockAllocation {
    /** A look takes at most one sample for this many of the block's own. */
    private static final int WORTH_A_LOOK = 16;

    /** Binary logarithm of the largest number of samples per pixel of a look: they are no part of the picture. */
    private static final int MOST_APART = 2;

    private final double samples;
    private final double share;
    private final BlockLimits limits;
    private final Allocation unlimited;
    private Allocation ofBlock;

    /**
     * @param effort inverse of the variance that is worth one more sample, where no limit is reached
     * @param samples camera rays per pixel of the picture
     * @param share of the pixels that are in blocks which may show more than background
     * @param limits of the camera rays of those
     */
    BlockAllocation(double effort, double samples, double share, BlockLimits limits) {
        this.samples = samples;
        this.share = share;
        this.limits = limits;
        unlimited = new Allocation(effort, samples, share);
        ofBlock = unlimited;
    }

    /** Whether there are limits. */
    boolean isLimited() {
        return limits != BlockLimits.NONE;
    }

    /**
     * Binary logarithm of the number of samples of each pixel that a block is looked at with where they are no part of the picture: a small
     * share of what the block takes. Negative if that is none.
     */
    int apart() {
        return Math.max(Math.min(Math.getExponent(limits.mean() / WORTH_A_LOOK), MOST_APART), -1);
    }

    /** A mean of the block's samples per pixel, inside the range for which {@link #apart} returns this. */
    static double samplesFor(int apart) {
        return Math.scalb(1.0, apart) * (WORTH_A_LOOK + WORTH_A_LOOK / 2);
    }

    /** Turns to a block that no limits hold for. */
    void withoutLimits() {
        ofBlock = unlimited;
    }

    /**
     * Turns to a block that shows more than background.
     *
     * @param rays that were taken to find what it needs
     */
    void limit(SampleDemand needs, Block block, int rays) {
        ofBlock = unlimited;
        if (!isLimited()) {
            return;
        }
        double wanted = perPixel(unlimited, needs, block, rays);
        double limited = limits.limited(wanted);
        if (limited != wanted) {
            double effort =
                    EffortSearch.nearest(e -> perPixel(new Allocation(e, samples, share), needs, block, rays), limited);
            ofBlock = new Allocation(effort, samples, share);
        }
    }

    /** That of the block it was turned to. */
    Allocation ofBlock() {
        return ofBlock;
    }

    /** Camera rays of a whole block, within the limits; a whole number if there are none. */
    double spent(SampleDemand needs, Block block, int rays) {
        return isLimited()
                ? block.pixels() * limits.limited(perPixel(unlimited, needs, block, rays))
                : taken(unlimited, needs, block) + rays;
    }

    private static double perPixel(Allocation allocation, SampleDemand needs, Block block, int rays) {
        return (double) (taken(allocation, needs, block) + rays) / block.pixels();
    }

    private static long taken(Allocation allocation, SampleDemand needs, Block block) {
        long sum = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                int k = FilmTile.BLOCK_SIDE * j + i;
                double dither = Dither.at(block.x() + i, block.y() + j);
                sum += 1L << allocation.samples(needs.film[k], needs.edge[k], needs.light[k], dither);
            }
        }
        return sum;
    }
}
