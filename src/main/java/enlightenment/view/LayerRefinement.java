package enlightenment.view;

import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.view.frame.PassPlan;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Renders the layers that pages have requested: at a quarter of the resolution, then whole. Runs on a thread of its own, so that layers need not
 * wait for the passes of the picture.
 */
final class LayerRefinement implements Runnable {
    /** Side in pixels of the block that one sample stands for, pass by pass. */
    private static final int[] SHRINKS = {4, 1};

    /** Samples per pixel: the albedo is a mean over edges and textures within a pixel. */
    private static final int SAMPLES = 4;

    private final ViewSession session;
    private final ScenePreparation preparation;
    private final SceneSource source;
    private final int threads;

    /**
     * @param preparation prepares the scene
     * @param source finds the lines of problems
     * @param threads number of threads of a render
     */
    LayerRefinement(ViewSession session, ScenePreparation preparation, SceneSource source, int threads) {
        this.session = session;
        this.preparation = preparation;
        this.source = source;
        this.threads = threads;
    }

    /** A request for layers of a shot. */
    record Wish(Shot shot, Set<RenderResult.Auxiliary> kinds) {}

    @Override
    public void run() {
        try {
            for (Wish wish = session.awaitWish(); wish != null; wish = session.awaitWish()) {
                refineSafely(wish);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Withdraws all requests after a failure, so that one is retried only if a page asks again. */
    private void refineSafely(Wish wish) throws InterruptedException {
        List<String> problems = RefinementProblems.of(() -> refine(wish), source);
        if (!problems.isEmpty()) {
            session.clearWishes();
            session.failed(wish.shot().generation(), problems);
        }
    }

    private void refine(Wish wish) {
        Shot shot = wish.shot();
        for (int shrink : SHRINKS) {
            RenderSettings settings = shot.settings(new PassPlan(shrink, 0, SAMPLES, 0), threads);
            RenderRequest request = preparation
                    .request(shot, settings, () -> !session.isCurrent(shot.generation()))
                    .withAuxiliary(wish.kinds());
            Map<RenderResult.Auxiliary, Layers.Numbers> found = new EnumMap<>(RenderResult.Auxiliary.class);
            Renderer.auxiliary(request)
                    .forEach((kind, image) ->
                            found.put(kind, new Layers.Numbers(shot.generation(), shot.scene(), shrink, image)));
            session.publish(shot.generation(), found);
        }
    }
}
