package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.image.Image;
import enlightenment.picture.Rounding;
import enlightenment.scene.RenderSettings;
import java.util.Map;
import java.util.OptionalDouble;

/** Renders a planned picture, and again with more samples as long as it is not as exact as was asked. */
final class RenderRounds {
    private static final double NANO = 1e-9;

    private final RenderRequest request;
    private final RenderSettings settings;
    private final CompiledScene scene;
    private final Planner planner;
    private final Preview preview;
    private final AuxiliaryPass pass;
    private final Phases phases;
    private final long start;

    /**
     * @param preview what is shown where nothing is finished yet, or null
     * @param pass what is told of pixels beside their colours, as far as it needs rays of its own
     * @param start when the render began, of {@link System#nanoTime}
     */
    RenderRounds(
            RenderRequest request,
            CompiledScene scene,
            Planner planner,
            Preview preview,
            AuxiliaryPass pass,
            Phases phases,
            long start) {
        this.request = request;
        settings = request.settings();
        this.scene = scene;
        this.planner = planner;
        this.preview = preview;
        this.pass = pass;
        this.phases = phases;
        this.start = start;
    }

    /** The last picture that became whole; if not even the first did, what there is of it. */
    RenderResult run(RenderPlan first) {
        Rounds rounds = new Rounds(settings.budget());
        RenderResult best = null;
        RenderPlan plan = first;
        for (int round = 1; ; round++) {
            long before = System.nanoTime();
            RenderResult result = render(plan, round);
            if (!result.complete()) {
                return best == null ? result : best;
            }
            best = result;
            long now = System.nanoTime();
            OptionalDouble next = rounds.next(result.report(), (now - before) * NANO, (now - start) * NANO);
            if (next.isEmpty() || request.cancelled().getAsBoolean()) {
                return best;
            }
            request.progress().note(Rounds.note(result.report(), next.getAsDouble()));
            phases.again();
            plan = phases.run(
                    "plan", () -> planner.withSamples(next.getAsDouble(), rounds.decidedBy(next.getAsDouble())));
            request.progress().planned(plan.samples(), plan.decidedBy());
        }
    }

    private RenderResult render(RenderPlan plan, int round) {
        TileRender render = new TileRender(scene, settings, plan, request.progress(), request.cancelled(), preview);
        if (request.clusters()) {
            render.gatherClusters();
        }
        phases.run("render", render::run);
        Image image = phases.run("finish", render::image);
        Map<Auxiliary, Image> auxiliary = pass.images();
        for (Auxiliary kind : request.auxiliary()) {
            if (!kind.needsRays()) {
                auxiliary.put(kind, new PixelStatistics(render.film()).of(kind));
            }
        }
        RenderReport report = render.report(request.scene().name(), phases.list())
                .with(Rounding.of(image, settings.budget().depth()), round);
        return new RenderResult(image, report, render.isComplete(), render.shownPixels(), auxiliary, render.clusters());
    }
}
