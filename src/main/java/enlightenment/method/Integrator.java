package enlightenment.method;

import java.util.function.BooleanSupplier;

/**
 * Estimates the integrals that are the pixels; one per thread. A {@link TileIntegrator} takes pixels and estimates the light that reaches
 * them; a {@link SplatIntegrator} traces paths and adds them to the pixels that they reach.
 */
public sealed interface Integrator permits TileIntegrator, SplatIntegrator {
    /**
     * Sets the condition of cancellation: once it holds, which is then for good, the work soon ends by a
     * {@link java.util.concurrent.CancellationException}.
     */
    void stopWhen(BooleanSupplier cancelled);
}
