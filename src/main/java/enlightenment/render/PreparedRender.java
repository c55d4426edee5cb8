package enlightenment.render;

import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.FilmPlace;
import enlightenment.engine.Preview;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** A render whose scene is compiled: what pixels show beside their colours, the plan, then the picture. */
final class PreparedRender {
    private final RenderRequest request;
    private final RenderSettings settings;
    private final CompiledScene scene;
    private final FilmChoice film;
    private final Phases phases;
    private final Stopwatch time;
    private final PreparedDevice device;
    private final BooleanSupplier cancelled;

    /** @param device takes part */
    PreparedRender(
            RenderRequest request,
            CompiledScene scene,
            FilmChoice film,
            Phases phases,
            Stopwatch time,
            PreparedDevice device,
            BooleanSupplier cancelled) {
        this.request = request;
        settings = request.settings();
        this.scene = scene;
        this.film = film;
        this.phases = phases;
        this.time = time;
        this.device = device;
        this.cancelled = cancelled;
    }

    RenderResult run() {
        Preview preview = preview();
        if (preview != null && !preview.isKept()) {
            showCoarsely(preview);
        }
        AuxiliaryPass pass = new AuxiliaryPass(scene, settings, request.neededAuxiliary());
        if (request.neededAuxiliary().stream().anyMatch(RenderResult.Auxiliary::needsRays)) {
            phases.run("auxiliary", () -> pass.run(cancelled));
        }
        PathPartPass parts = new PathPartPass(scene, settings, request.neededAuxiliary());
        Planner planner = new Planner(scene, settings, cancelled);
        Archives archives =
                request.archives().isEmpty() ? null : new Archives(request.archives(), request.progress()::note);
        Optional<RenderPlan> kept = archives == null ? Optional.empty() : archives.planFor(settings, 1);
        RenderRequest stoppable = request.withCancelled(cancelled);
        RenderPlan plan;
        try {
            plan = phases.run("plan", () -> kept.map(planner::known)
                    .orElseGet(() -> planner.plan(time, (preview == null ? 0 : preview.share()) + parts.share())));
        } catch (CancellationException e) {
            return new RenderRounds(
                            stoppable,
                            scene,
                            planner,
                            null,
                            pass,
                            parts,
                            phases,
                            time,
                            null,
                            film.place(planner.none()),
                            PreparedDevice.NONE)
                    .nothing();
        }
        FilmPlace place = film.place(plan);
        planner.notes().forEach(request.progress()::note);
        notePlan(plan, kept.isPresent());
        if (preview != null) {
            phases.run("preview", () -> refine(preview, planner, plan));
        }
        return new RenderRounds(stoppable, scene, planner, preview, pass, parts, phases, time, archives, place, device)
                .run(plan);
    }

    /** Shows the whole picture before all that takes long: planning, too. */
    private void showCoarsely(Preview preview) {
        phases.run("preview", () -> preview.begin(cancelled));
        if (!cancelled.getAsBoolean()) {
            request.progress().coarse(preview::image);
        }
    }

    private void notePlan(RenderPlan plan, boolean isKept) {
        if (isKept && settings.budget().seconds().isPresent()) {
            request.progress()
                    .note("the plan that is kept is gone on with: " + Rounds.number(plan.samples())
                            + " samples per pixel, whatever time is left");
        }
        request.progress().planned(plan.samples(), plan.decidedBy());
    }

    /** The picture to show where the film is not finished; null for none. */
    private Preview preview() {
        if (settings.method().kind() != Method.Kind.TILES) {
            // Paths that may end anywhere show something of the whole picture from the first on.
            return null;
        }
        if (request.progressive()) {
            return new Preview(Preview.Kind.FINE, scene, settings);
        }
        return request.watched() && film.hasRoom(scene) ? new Preview(Preview.Kind.COARSE, scene, settings) : null;
    }

    private void refine(Preview preview, Planner planner, RenderPlan plan) {
        RenderSettings.Crop region = settings.region();
        long total = (long) region.width() * region.height();
        if (preview.isKept()) {
            preview.begin(cancelled);
        }
        preview.refine(planner, plan, () -> request.progress().progress(0, total, preview::image), cancelled);
    }
}
