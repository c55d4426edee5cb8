package enlightenment.cli.setting;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.scene.RenderSettings;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Reports how a budget is used. Messages have the number of samples that a time amounts to, so that the picture can be made again, what
 * cannot be met, and why a picture is rendered once more. Passes all calls on to the display.
 */
public final class BudgetNotes implements RenderProgress {
    private final RenderProgress display;
    private final RenderSettings.Budget budget;
    private final Terminal terminal;
    private final String about;
    private final Consumer<String> notes;

    public BudgetNotes(RenderProgress display, RenderSettings.Budget budget, Terminal terminal) {
        this(display, budget, terminal, "", terminal::say);
    }

    /**
     * Notes about one of several pictures.
     *
     * @param about the prefix of messages, which names the picture
     * @param notes receives what cannot be met
     */
    public BudgetNotes(
            RenderProgress display,
            RenderSettings.Budget budget,
            Terminal terminal,
            String about,
            Consumer<String> notes) {
        this.about = about;
        this.notes = notes;
        this.display = display;
        this.budget = budget;
        this.terminal = terminal;
    }

    @Override
    public void planned(double samples, String decidedBy) {
        if (decidedBy.equals("time")) {
            terminal.err()
                    .println(about + "time "
                            + DecimalNumber.plain(budget.seconds().orElse(0)) + " s: --samples "
                            + DecimalNumber.plain(samples) + " makes the same picture");
        }
        display.planned(samples, decidedBy);
    }

    @Override
    public void note(String text) {
        notes.accept(text);
        display.note(text);
    }

    @Override
    public void coarse(Supplier<Image> soFar) {
        display.coarse(soFar);
    }

    @Override
    public void progress(long done, long total, Supplier<Image> soFar) {
        display.progress(done, total, soFar);
    }
}
