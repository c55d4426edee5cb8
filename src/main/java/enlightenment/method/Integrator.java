package enlightenment.method;

import java.util.function.BooleanSupplier;

/**
 * A way to estimate the integrals that are the pixels; one per thread. There are two kinds: a {@link TileIntegrator} takes pixels
 * and finds the light that reaches them, a {@link SplatIntegrator} takes paths and finds the pixels that they reach.
 */
public sealed interface Integrator permits TileIntegrator, SplatIntegrator {
    /**
     * Lets this end in the middle of its work, by a {@link java.util.concurrent.CancellationException}, soon after this has become
     * true; it stays true then.
     */
    void stopWhen(BooleanSupplier cancelled);
}
