package enlightenment.render;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;

/** A render on a thread of an executor, as {@link Renderer#submit} states. */
final class SubmittedRender {
    private SubmittedRender() {}

    /** Hands the render to the executor; returns its future, which ends it. */
    static CompletableFuture<RenderResult> begin(RenderRequest request, Executor executor) {
        CompletableFuture<RenderResult> future = new CompletableFuture<>();
        BooleanSupplier asked = request.cancelled();
        RenderRequest stoppable = request.withCancelled(() -> future.isDone() || asked.getAsBoolean());
        executor.execute(() -> {
            if (future.isDone()) {
                return;
            }
            try {
                future.complete(Renderer.render(stoppable));
            } catch (Throwable t) {
                // Errors, too: those who wait for the future must hear of them.
                future.completeExceptionally(t);
            }
        });
        return future;
    }
}
