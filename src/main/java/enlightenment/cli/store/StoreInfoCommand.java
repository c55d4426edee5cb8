package enlightenment.cli.store;

import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.store.PlanRow;
import enlightenment.store.RenderRow;
import enlightenment.store.SampleStore;
import enlightenment.store.StorePicture;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code enlightenment store-info}: tells what a store holds. */
@Command(
        name = "store-info",
        description = "Tells which renders a store holds, and how much of them.",
        sortOptions = false)
public final class StoreInfoCommand extends Subcommand {
    private static final double MEGA = 1e6;
    private static final double PERCENT = 100;

    @Mixin
    private StoreArgument argument = new StoreArgument();

    public StoreInfoCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        try (SampleStore store = argument.open()) {
            List<RenderRow> renders = argument.hasId() ? List.of(argument.choose(store)) : store.renders();
            if (renders.isEmpty()) {
                terminal.show(store.name() + " holds no render yet");
            }
            for (RenderRow render : renders) {
                tell(store, render);
            }
        }
        return ExitCode.DONE;
    }

    private void tell(SampleStore store, RenderRow render) throws IOException {
        terminal.show((argument.hasId() ? render.id() : SampleStore.shortId(render)) + "  " + render.created() + "  "
                + render.width() + " x " + render.height() + "  " + render.name());
        terminal.show("  " + render.settings() + "; Enlightenment " + render.program());
        for (PlanRow plan : store.plans(render)) {
            tell(store, render, plan);
        }
    }

    private void tell(SampleStore store, RenderRow render, PlanRow plan) throws IOException {
        SampleStore.Facts facts = store.facts(render, plan);
        OptionalInt units = StorePicture.units(plan);
        String share = units.isEmpty()
                ? facts.units() + " units of a plan that this version does not understand"
                : facts.units() >= units.getAsInt()
                        ? "complete, " + units.getAsInt() + " units"
                        : facts.units() + " of " + units.getAsInt() + " units"
                                + String.format(Locale.ROOT, " (%.1f %%)", facts.units() * PERCENT / units.getAsInt());
        terminal.show("  pass " + plan.pass() + ": " + share + ", " + facts.samples() + " camera rays, "
                + mega(facts.bytes()));
        if (facts.blocks() > 0) {
            terminal.show(
                    "    samples: " + facts.kept() + " in " + facts.blocks() + " blocks, " + mega(facts.blockBytes()));
        }
        for (SampleStore.Worker worker : store.workers(render, plan)) {
            terminal.show(
                    "    " + worker.name() + ": " + worker.units() + " units, " + worker.samples() + " camera rays");
        }
    }

    private static String mega(long bytes) {
        return String.format(Locale.ROOT, "%.1f MB", bytes / MEGA);
    }
}
