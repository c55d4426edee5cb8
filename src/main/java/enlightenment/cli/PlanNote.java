package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import java.io.PrintStream;
import java.util.function.Supplier;

/** Says which number of samples a time has become, so that the picture can be made again; tells on all that it hears. */
final class PlanNote implements RenderProgress {
    private final RenderProgress display;
    private final double seconds;
    private final PrintStream err;

    PlanNote(RenderProgress display, double seconds, PrintStream err) {
        this.display = display;
        this.seconds = seconds;
        this.err = err;
    }

    @Override
    public void planned(double samples, String decidedBy) {
        if (decidedBy.equals("time")) {
            err.println("time " + RenderOptions.number(seconds) + " s: --samples " + RenderOptions.number(samples)
                    + " makes the same picture");
        }
        display.planned(samples, decidedBy);
    }

    @Override
    public void progress(long done, long total, Supplier<Image> soFar) {
        display.progress(done, total, soFar);
    }
}
