package enlightenment.view;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.scene.RenderSettings;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/**
 * The scene of a view, prepared for rendering once for all passes, layers and pixels of the same camera and size. Holds at most two sizes at a
 * time, so that picture and layers do not take it from each other. Safe for several threads: two that want the same at once may both make it.
 */
final class ScenePreparation {
    private static final int MOST = 2;

    /** Those of one shot, the one that was asked for last at the end. */
    private final Map<Key, RenderRequest.MethodChoice> prepared = new LinkedHashMap<>(MOST, 1, true);

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
        RenderRequest.MethodChoice known = known(wanted);
        if (known == null) {
            known = shot.film().prepare(shot.scene(), settings, cancelled);
            keep(wanted, known);
        }
        return RenderRequest.of(shot.scene(), settings)
                .withChoice(known.with(settings))
                .withProgress(RenderProgress.NONE)
                .withCancelled(cancelled);
    }

    /** What is prepared so; null if nothing is: then what is of no use any more is let go, and room is made, before it is. */
    private synchronized RenderRequest.MethodChoice known(Key wanted) {
        RenderRequest.MethodChoice known = prepared.get(wanted);
        if (known == null) {
            prepared.keySet().removeIf(key -> key.generation() < wanted.generation());
            makeRoom();
        }
        return known;
    }

    private synchronized void keep(Key made, RenderRequest.MethodChoice choice) {
        if (prepared.keySet().stream().anyMatch(key -> key.generation() > made.generation())) {
            return;
        }
        prepared.keySet().removeIf(key -> key.generation() < made.generation() || key.equals(made));
        makeRoom();
        prepared.put(made, choice);
    }

    private void makeRoom() {
        while (prepared.size() >= MOST) {
            prepared.remove(prepared.keySet().iterator().next());
        }
    }
}
