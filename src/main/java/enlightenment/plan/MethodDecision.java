package enlightenment.plan;

import enlightenment.scene.Method;
import java.util.Objects;

/**
 * The method that is chosen for a render.
 *
 * @param method one that renders
 * @param reason method and why, as a sentence without a full stop
 */
public record MethodDecision(Method method, String reason) {
    public MethodDecision {
        Objects.requireNonNull(method, "method");
        Objects.requireNonNull(reason, "reason");
    }

    /** @param because the end of the sentence */
    static MethodDecision of(Method method, String because) {
        return new MethodDecision(
                method, "method " + method.word() + ", chosen by " + Method.AUTO.word() + ": " + because);
    }
}
