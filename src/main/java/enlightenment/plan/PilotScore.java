package enlightenment.plan;

import enlightenment.scene.Method;

/**
 * What a pilot shows of a method, for one camera sample per pixel.
 *
 * @param method the method
 * @param variance the relative variance: the mean over pixels and bands of the variance over m² + (0.05 M)², where m is the pixel's value and
 *     M the picture's mean
 * @param uncertain the standard error of the variance: what rare bright paths may add
 * @param missed what has to be added for light that another method finds and this one did not
 * @param cost nanoseconds
 */
record PilotScore(Method method, double variance, double uncertain, double missed, double cost) {
    /** How many standard errors of the variance count. */
    private static final double CAUTION = 1;

    /** The product of error and cost: the less of it, the sooner a picture is as exact as is asked. */
    double work() {
        return (variance + CAUTION * uncertain + missed) * cost;
    }
}
