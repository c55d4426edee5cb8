package enlightenment.render;

import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.FilmPlace;
import enlightenment.engine.Preview;
import enlightenment.engine.Reports;
import enlightenment.image.Image;
import enlightenment.picture.Rounding;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;

/** Renders a planned picture, and again with more samples as long as it is not as exact as was asked. */
final class RenderRounds {
    private final RenderRequest request;
    private final RenderSettings settings;
    private final CompiledScene scene;
    private final Planner planner;
    private final Preview preview;
    private final AuxiliaryPass pass;
    private final PathPartPass parts;
    private final Phases phases;
    private final Stopwatch time;

    /** The archives of results, or null. */
    private final Archives archives;

    private final FilmPlace place;

    private final PreparedDevice device;

    /**
     * One render of the picture.
     *
     * @param guides the auxiliary images, requested or not
     */
    private record Round(PictureRender render, RenderResult result, Map<RenderResult.Auxiliary, Image> guides) {}

    /**
     * @param preview what is shown where nothing is finished yet, or null
     * @param pass makes the auxiliary images that need rays of their own
     * @param parts makes the auxiliary images that are of the beginnings of paths
     * @param time since the render began
     * @param archives where the results of units are kept, or null
     * @param place where finished pixels are
     * @param device takes part
     */
    RenderRounds(
            RenderRequest request,
            CompiledScene scene,
            Planner planner,
            Preview preview,
            AuxiliaryPass pass,
            PathPartPass parts,
            Phases phases,
            Stopwatch time,
            Archives archives,
            FilmPlace place,
            PreparedDevice device) {
        this.device = device;
        this.request = request;
        settings = request.settings();
        this.scene = scene;
        this.planner = planner;
        this.preview = preview;
        this.pass = pass;
        this.parts = parts;
        this.phases = phases;
        this.time = time;
        this.archives = archives;
        this.place = place;
    }

    /** The result of a render that was stopped before it was planned. */
    RenderResult nothing() {
        return render(planner.none(), 1).result();
    }

    /** The last picture that became whole; if not even the first did, what there is of it. */
    RenderResult run(RenderPlan first) {
        Rounds rounds = new Rounds(settings.budget());
        RenderResult best = null;
        RenderPlan plan = first;
        for (int round = 1; ; round++) {
            double before = time.seconds();
            Round done = render(plan, round);
            RenderResult result = done.result();
            if (!result.complete()) {
                return best == null ? result : stopped(best);
            }
            if (best != null) {
                best.image().release();
            }
            best = result;
            double now = time.seconds();
            OptionalDouble next = rounds.next(result.report(), now - before, now);
            RenderPlan kept = archives == null
                    ? null
                    : archives.planFor(settings, round + 1).orElse(null);
            if (next.isEmpty() && kept == null) {
                rounds.reasonForStopping().ifPresent(request.progress()::note);
                return request.denoised() ? denoised(done) : best;
            }
            if (request.cancelled().getAsBoolean()) {
                return stopped(best);
            }
            double n = kept == null ? next.getAsDouble() : kept.samples();
            request.progress().note(rounds.note(result.report(), n));
            phases.again();
            try {
                plan = kept != null ? kept : phases.run("plan", () -> planner.withSamples(n, rounds.decidedBy(n)));
            } catch (CancellationException e) {
                return stopped(best);
            }
            request.progress().planned(plan.samples(), plan.decidedBy());
        }
    }

    private RenderResult stopped(RenderResult best) {
        request.progress().note(Rounds.stopped(best.report()));
        if (request.denoised()) {
            request.progress().note("grain is removed of the last picture only: there is no picture without");
        }
        return best;
    }

    /** The result with a picture without grain, unless that is cancelled. */
    private RenderResult denoised(Round last) {
        RenderResult result = last.result();
        Optional<Image> denoised = phases.run(
                "denoise", () -> Denoising.of(result.image(), last.render().film(), last.guides(), request));
        return result.withDenoised(denoised, result.report().withPhases(Reports.phases(phases)));
    }

    private LocalRender local(RenderPlan plan) {
        LocalRender render = new LocalRender(
                request.scene().name(),
                scene,
                settings,
                plan,
                request.progress(),
                request.cancelled(),
                preview,
                place,
                device);
        if (request.clusters()) {
            render.gatherClusters();
        }
        if (request.chains()) {
            render.gatherChains();
        }
        return render;
    }

    private Round render(RenderPlan plan, int round) {
        PictureRender render = archives == null
                ? local(plan)
                : new KeptRender(request, scene, plan, archives, round, preview, place, device);
        if (parts.isNeeded()) {
            // Before the picture: what is left of that if the render is stopped has its parts.
            phases.run("auxiliary", () -> parts.run(plan, request.cancelled()));
        }
        phases.run("render", render::run);
        Image image = phases.run("finish", render::image);
        Map<RenderResult.Auxiliary, Image> auxiliary = pass.images();
        for (RenderResult.Auxiliary kind : request.auxiliary()) {
            if (!kind.needsRays() && !kind.needsPaths()) {
                auxiliary.put(kind, new PixelStatistics(render.film(), settings.region()).of(kind));
            }
        }
        parts.addTo(image, auxiliary);
        Map<RenderResult.Auxiliary, Image> guides = Map.copyOf(auxiliary);
        auxiliary.keySet().retainAll(request.auxiliary());
        double rounding = Rounding.of(image, settings.budget().depth());
        RenderReport report = render.report(phases, rounding, round);
        render.film().release();
        RenderResult result = new RenderResult(
                image,
                report,
                render.film().isComplete(),
                render.shownPixels(),
                auxiliary,
                render.clusters(),
                render.chains(),
                Optional.empty());
        return new Round(render, result, guides);
    }
}
