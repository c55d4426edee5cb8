package enlightenment.method.metropolis;

/**
 * Statistics of one Markov chain.
 *
 * @param blockX first column of its block of pixels
 * @param blockY first row of the block
 * @param group the group of independent paths that it started from, 0..7
 * @param startX column of the pixel of its first state, in the whole picture
 * @param startY row of that pixel
 * @param endX column of the pixel of its last state
 * @param endY row of that pixel
 * @param startBrightness brightness of its first path
 * @param meanBrightness mean brightness of the group's independent paths
 * @param steps the number of proposals
 * @param accepted the number of accepted proposals
 * @param largeSteps the number of proposals that were large steps: independent paths
 * @param largeAccepted the number of accepted large steps
 */
public record ChainStatistics(
        int blockX,
        int blockY,
        int group,
        int startX,
        int startY,
        int endX,
        int endY,
        double startBrightness,
        double meanBrightness,
        long steps,
        long accepted,
        long largeSteps,
        long largeAccepted) {}
