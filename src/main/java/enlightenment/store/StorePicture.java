package enlightenment.store;

import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FilmRoom;
import enlightenment.engine.KeptPlan;
import enlightenment.engine.RenderOutline;
import enlightenment.engine.Rendered;
import enlightenment.engine.WorkUnits;
import enlightenment.math.InvalidValueException;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The picture of a render that is in a store: of its last plan that is complete, or else of the last that anything is there of.
 *
 * @param result the picture and its report; what is missing is black
 * @param texts what its file is to say of itself
 * @param units how many units there have to be
 * @param missing how many are not there
 * @param notes what is to be told, a line each
 */
public record StorePicture(RenderResult result, Map<String, String> texts, int units, int missing, List<String> notes) {

    /**
     * Puts a picture together.
     *
     * @param scratch where it is if it is too large for the memory; empty if it is refused
     * @throws IOException if there is nothing to put together
     */
    public static StorePicture of(SampleStore store, RenderRow render, Optional<RenderRequest.ScratchFolder> scratch)
            throws IOException {
        PlanRow plan = plan(store, render);
        FilmAssembly film = assembly(outline(plan).orElseThrow(() -> unknown(store, render)), scratch);
        List<String> notes = new ArrayList<>();
        long[] wrong = new long[1];
        long damaged = store.results(render, plan, (unit, bytes) -> {
            Optional<String> problem = film.problemOfKept(unit, bytes);
            if (problem.isEmpty()) {
                film.put(unit, bytes);
            } else if (wrong[0]++ == 0) {
                notes.add("unit " + unit + " is not what it should be: " + problem.get());
            }
        });
        if (wrong[0] > 1) {
            notes.add(wrong[0] - 1 + " more units are not what they should be");
        }
        if (damaged > 0) {
            notes.add(damaged + " units are damaged");
        }
        Rendered rendered = film.result();
        film.film().release();
        RenderResult result = new RenderResult(
                rendered.image(), rendered.report(), rendered.complete(), rendered.shownPixels(), Map.of(), List.of());
        return new StorePicture(result, plan.texts(), film.units(), film.units() - film.done(), notes);
    }

    private static FilmAssembly assembly(RenderOutline outline, Optional<RenderRequest.ScratchFolder> scratch)
            throws StoreException {
        try {
            FilmRoom room = scratch.map(s -> new FilmRoom(Optional.of(s.folder()), s.memory()))
                    .orElse(FilmRoom.MEMORY);
            return new FilmAssembly(outline, room);
        } catch (InvalidValueException | ArithmeticException e) {
            if (e instanceof InvalidValueException size && size.key().equals("size")) {
                throw new StoreException(size.problem(), e);
            }
            throw new StoreException("the plan in the store cannot be used: " + e.getMessage(), e);
        }
    }

    /** The plan whose picture and samples are meant. */
    public static PlanRow plan(SampleStore store, RenderRow render) throws IOException {
        PlanRow some = null;
        List<PlanRow> plans = store.plans(render);
        for (int i = plans.size() - 1; i >= 0; i--) {
            OptionalInt units = units(plans.get(i));
            long there = units.isEmpty() ? 0 : store.facts(render, plans.get(i)).units();
            if (there > 0 && there >= units.getAsInt()) {
                return plans.get(i);
            }
            some = some == null && there > 0 ? plans.get(i) : some;
        }
        if (some == null) {
            boolean areKnown = plans.stream().allMatch(plan -> units(plan).isPresent());
            throw areKnown ? nothingYet(store, render) : unknown(store, render);
        }
        return some;
    }

    private static StoreException nothingYet(SampleStore store, RenderRow render) {
        return new StoreException(store.name() + ": nothing of the picture is in the store yet (render "
                + SampleStore.shortId(render) + ")");
    }

    private static StoreException unknown(SampleStore store, RenderRow render) {
        return new StoreException(store.name() + " has nothing of render " + SampleStore.shortId(render)
                + " that this version of the program can make a picture of (it was made by " + render.program() + ")");
    }

    /** The number of units of a plan; empty for a plan of another version of the program. */
    public static OptionalInt units(PlanRow plan) {
        return workUnits(plan).map(u -> OptionalInt.of(u.count())).orElse(OptionalInt.empty());
    }

    /** The units of a plan; empty for a plan of another version of the program. */
    static Optional<WorkUnits> workUnits(PlanRow plan) {
        try {
            return outline(plan).map(o -> WorkUnits.forMachines(o.settings(), o.plan()));
        } catch (InvalidValueException | ArithmeticException e) {
            return Optional.empty();
        }
    }

    private static Optional<RenderOutline> outline(PlanRow plan) {
        return KeptPlan.read(plan.data()).map(KeptPlan::outline);
    }
}
