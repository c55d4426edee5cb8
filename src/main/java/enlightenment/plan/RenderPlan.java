package enlightenment.plan;

import enlightenment.check.Check;
import enlightenment.scene.Method;
import java.util.Objects;

/**
 * What is decided about a render before its first tile: with it, a tile is a pure function of scene, settings and place. It is
 * a pure function of scene and settings itself, except that a time budget looks at the clock.
 *
 * @param method what makes the samples: that of the settings, or {@link Method#RAYTRACE} where {@link Method#CLUSTER} has too few
 *     of them to survey the picture first
 * @param level how much is spent, at least 0. For {@link Method#RAYTRACE} the mean number of samples per pixel, or 0 for
 *     antialias²; for {@link Method#CLUSTER} the effort, the inverse of the variance that is worth one more sample
 * @param samples the mean number of camera rays per pixel that this is expected to take; a budget of this many samples leads to
 *     the same plan
 * @param decidedBy which part of the budget was decisive: antialias, samples, error or time
 */
public record RenderPlan(Method method, double level, double samples, String decidedBy) {
    /**
     * Checks the ranges.
     *
     * @throws enlightenment.math.InvalidValueException if a number is negative or infinite
     */
    public RenderPlan {
        Objects.requireNonNull(method, "method");
        Objects.requireNonNull(decidedBy, "decidedBy");
        Check.that(level >= 0 && level < Double.POSITIVE_INFINITY, "plan", "must not be negative, but is " + level);
        Check.that(samples >= 0 && samples < Double.POSITIVE_INFINITY, "plan", "cannot be of " + samples + " samples");
    }
}
