package enlightenment.view;

import enlightenment.render.MethodChoice;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.scene.RenderSettings;
import java.util.function.BooleanSupplier;

/**
 * The scene of a view, prepared for rendering once for all passes and pixels of the same camera and size. Holds one at a time. Safe for several
 * threads.
 */
final class ScenePreparation {
    private Key key;
    private MethodChoice prepared;

    /** What is prepared: a shot's scene at a size. */
    private record Key(long generation, int width, int height) {}

    /**
     * The request for a render of a shot, with the scene prepared.
     *
     * @param settings of the shot; size, samples, seed and crop are free
     * @throws enlightenment.scene.SceneException if the scene cannot be rendered
     * @throws java.util.concurrent.CancellationException if it was cancelled before that was known
     */
    RenderRequest request(Shot shot, RenderSettings settings, BooleanSupplier cancelled) {
        Key wanted = new Key(shot.generation(), settings.width(), settings.height());
        MethodChoice known = known(wanted);
        if (known == null) {
            known = shot.film().prepare(shot.scene(), settings, cancelled);
            keep(wanted, known);
        }
        return RenderRequest.of(shot.scene(), settings)
                .withChoice(known.with(settings))
                .withProgress(RenderProgress.NONE)
                .withCancelled(cancelled);
    }

    /** What is prepared so; null if nothing is. What is of no use any more is let go before the next is made. */
    private synchronized MethodChoice known(Key wanted) {
        if (!wanted.equals(key)) {
            key = null;
            prepared = null;
        }
        return prepared;
    }

    private synchronized void keep(Key made, MethodChoice choice) {
        key = made;
        prepared = choice;
    }
}
