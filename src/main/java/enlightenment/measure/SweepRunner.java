package enlightenment.measure;

import enlightenment.measure.trade.Sweep;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.util.List;

/** Renders the values of the sweeps one after the other, within the budget. */
final class SweepRunner {
    /** The share of the budget after which sweeps begin; they divide the rest evenly. */
    private static final double BEGIN = 0.7;

    /** Number of values of each sweep that are rendered whatever their time: fewer allow no comparison. */
    private static final int MIN_VALUES = 2;

    private final Session session;

    /** Seconds of the last render, the least expected time of the next one. */
    private double last;

    SweepRunner(Session session) {
        this.session = session;
    }

    void run() throws IOException {
        List<Sweep> sweeps = session.settings.sweeps();
        for (int i = 0; i < sweeps.size(); i++) {
            last = 0;
            run(sweeps.get(i), BEGIN + (1 - BEGIN) * (i + 1) / sweeps.size());
        }
    }

    private void run(Sweep sweep, double share) throws IOException {
        for (int i = 0; i < sweep.values().size(); i++) {
            int value = sweep.values().get(i);
            session.say(sweep.name() + " " + value);
            boolean all = run(sweep, value, share, i < MIN_VALUES ? 1 : 0);
            if (!all && i + 1 >= MIN_VALUES) {
                return;
            }
        }
    }

    /** Renders one value with each seed, the first few whatever their time; returns whether there was time for all. */
    private boolean run(Sweep sweep, int value, double share, int minSeeds) throws IOException {
        RenderSettings base = session.settings.base();
        for (int k = 0; k < session.settings.seeds(); k++) {
            if (k >= minSeeds && !session.fits(last, share)) {
                return false;
            }
            long seed = base.seed() + 1 + k;
            boolean done =
                    session.has(r -> r.kind().equals(sweep.kind()) && sweep.valueOf(r) == value && r.seed() == seed);
            if (!done) {
                TimedRenderer.Timed render =
                        session.renderer.render(sweep.at(base, value).withSeed(seed));
                last = render.wall();
                session.record(sweep.kind(), List.of(render));
            }
        }
        return true;
    }
}
