package enlightenment.render;

import enlightenment.check.Check;
import enlightenment.scene.Method;
import java.util.Objects;

/**
 * What is decided about a render before its first tile: with it, a tile is a pure function of scene, settings and place.
 *
 * @param method what makes the samples: {@code raytrace} or {@code cluster}
 * @param level how much is spent, in the measure of the method
 * @param samples the mean number of camera rays per pixel that this is expected to take
 * @param decidedBy which part of the budget was decisive: antialias, samples, error or time
 */
public record TilePlan(Method method, double level, double samples, String decidedBy) {
    public TilePlan {
        Objects.requireNonNull(method, "method");
        Check.that(level >= 0 && level < Double.POSITIVE_INFINITY, "plan", "must not be negative, but is " + level);
        Check.that(samples >= 0 && samples < Double.POSITIVE_INFINITY, "plan", "cannot be of " + samples + " samples");
    }

    static TilePlan of(RenderPlan plan) {
        return new TilePlan(plan.method(), plan.level(), plan.samples(), plan.decidedBy());
    }

    RenderPlan plan() {
        return new RenderPlan(method, level, samples, decidedBy);
    }
}
