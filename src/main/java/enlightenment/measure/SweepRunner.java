package enlightenment.measure;

import enlightenment.measure.trade.Sweep;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.util.List;

/** Renders the values of the sweeps one after the other, as long as the budget lasts. */
final class SweepRunner {
    /** The share of the budget after which sweeps begin; they divide the rest evenly. */
    private static final double BEGIN = 0.7;

    /** These many values of each sweep are rendered whatever they take: fewer compare nothing. */
    private static final int MIN_VALUES = 2;

    private final Session session;

    SweepRunner(Session session) {
        this.session = session;
    }

    void run() throws IOException {
        List<Sweep> sweeps = session.settings.sweeps();
        for (int i = 0; i < sweeps.size(); i++) {
            run(sweeps.get(i), BEGIN + (1 - BEGIN) * (i + 1) / sweeps.size());
        }
    }

    private void run(Sweep sweep, double share) throws IOException {
        RenderSettings base = session.settings.base();
        double last = 0;
        for (int i = 0; i < sweep.values().size(); i++) {
            int value = sweep.values().get(i);
            session.say(sweep.name() + " " + value);
            for (int k = 0; k < session.settings.seeds(); k++) {
                if ((i >= MIN_VALUES || k > 0) && !session.fits(last, share)) {
                    return;
                }
                long seed = base.seed() + 1 + k;
                boolean done = session.has(
                        r -> r.kind().equals(sweep.kind()) && sweep.valueOf(r) == value && r.seed() == seed);
                if (!done) {
                    TimedRenderer.Timed render =
                            session.renderer.render(sweep.at(base, value).withSeed(seed));
                    last = render.wall();
                    session.record(sweep.kind(), List.of(render));
                }
            }
        }
    }
}
