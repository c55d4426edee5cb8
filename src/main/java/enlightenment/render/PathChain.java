package enlightenment.render;

import enlightenment.method.metropolis.ChainStatistics;

/**
 * A Markov chain of method {@code metropolis}: a path that found light, and the paths near it that it led to, one after the other, all
 * of which begin in one block of the picture.
 *
 * @param blockX first column of the block of pixels
 * @param blockY first row of the block
 * @param group the group of independent paths that it began with one of, 0..7: groups do not depend on each other
 * @param startX column of the pixel that it began in
 * @param startY row of that pixel
 * @param endX column of the pixel that it ended in
 * @param endY row of that pixel
 * @param startBrightness how bright its first path was: luminance and a third of the mean of the bands, of light or of what a screen
 *     takes, as the scene's shading has it
 * @param meanBrightness how bright the group's independent paths were in the mean: the first is in proportion more probable, the
 *     brighter it is
 * @param steps how many steps were proposed
 * @param accepted how many of them were made
 * @param largeSteps how many of the proposals were new paths altogether
 * @param largeAccepted how many of these were accepted
 */
public record PathChain(
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
        long largeAccepted) {

    static PathChain of(ChainStatistics c) {
        return new PathChain(
                c.blockX(),
                c.blockY(),
                c.group(),
                c.startX(),
                c.startY(),
                c.endX(),
                c.endY(),
                c.startBrightness(),
                c.meanBrightness(),
                c.steps(),
                c.accepted(),
                c.largeSteps(),
                c.largeAccepted());
    }
}
