package enlightenment.plan;

import enlightenment.check.Check;
import enlightenment.scene.Method;
import java.util.Objects;

/**
 * The decisions about a render before its first tile. With them, a tile is a pure function of scene, settings and place. The plan is a pure
 * function of scene and settings itself, except that a time budget reads the clock.
 *
 * @param method the method that makes the samples: that of the settings, or {@link Method#RAYTRACE} where {@link Method#CLUSTER} has too
 *     few of them to survey the picture first
 * @param level the effort, at least 0. For {@link Method#RAYTRACE} the mean number of samples per pixel, or 0 for antialias²; for
 *     {@link Method#CLUSTER} the effort, the inverse of the variance that is worth one more sample
 * @param samples the mean number of camera rays per pixel that this is expected to take; a budget of this many samples leads to
 *     the same plan
 * @param decidedBy which part of the budget was decisive: antialias, samples, error or time; nothing if planning was stopped
 * @param lightPaths least number of light paths splatted over the tiles, in the whole picture; 0 for none. (Methods of which all paths are
 *     such have {@code samples} per pixel of them.)
 */
public record RenderPlan(Method method, double level, double samples, String decidedBy, long lightPaths) {
    /** A million processors for a day. */
    private static final long MOST_LIGHT_PATHS = 1L << 52;

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
        Check.that(
                lightPaths >= 0 && lightPaths <= MOST_LIGHT_PATHS,
                "plan",
                "cannot have " + lightPaths + " light paths; at most " + MOST_LIGHT_PATHS);
    }

    /** A plan without light paths. */
    public RenderPlan(Method method, double level, double samples, String decidedBy) {
        this(method, level, samples, decidedBy, 0);
    }
}
