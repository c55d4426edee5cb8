package enlightenment.view;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.scene.RenderSettings;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/**
 * A cache of prepared scenes, shared by all passes, layers and pixel probes of one camera and size. It holds at most two sizes, so that picture
 * and layers do not evict each other. Thread-safe; two threads that need the same entry at once may both prepare it.
 */
final class ScenePreparation {
    private static final int MOST = 2;

    /** Prepared scenes of one generation, the most recently used last. */
    private final Map<Key, RenderRequest.MethodChoice> prepared = new LinkedHashMap<>(MOST, 1, true);

    /** A generation and a size in pixels. */
    private record Key(long generation, int width, int height) {}

    /**
     * A render request for a shot, with its scene prepared.
     *
     * @param settings the settings of the shot; size, samples, seed and crop are free
     * @throws enlightenment.scene.SceneException if the scene cannot be rendered
     * @throws java.util.concurrent.CancellationException if the preparation was cancelled
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

    /** The cached entry, or null; then older generations are evicted and room is made before the entry is prepared. */
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
