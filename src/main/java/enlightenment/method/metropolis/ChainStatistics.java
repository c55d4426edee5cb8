package enlightenment.method.metropolis;

/**
 * What became of one Markov chain.
 *
 * @param blockX first column of the block of pixels that it lives in
 * @param blockY first row of the block
 * @param group the group of independent paths that it began with one of, 0..7
 * @param startX column of the pixel that it began in, in the whole picture
 * @param startY row of that pixel
 * @param endX column of the pixel that it ended in
 * @param endY row of that pixel
 * @param startBrightness how bright its first path was
 * @param meanBrightness how bright the group's independent paths were in the mean
 * @param steps how many steps were proposed
 * @param accepted how many of them were made
 * @param largeSteps how many of the proposals were new paths altogether
 * @param largeAccepted how many of these were accepted
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
