package enlightenment.measure;

import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Measures the trade of speed against accuracy of a scene. */
public final class Trade {
    private static final double BEFORE_SWEEPS = 0.7;

    private Trade() {}

    /**
     * Measures, and keeps every run in the folder as soon as it has ended: {@code trade.csv}. What was interrupted goes on with
     * {@code resume}.
     *
     * @param folder made if it is not there
     * @param resume whether to go on with what the folder holds, if it holds something
     * @param cancelled asked now and then from several threads; once true, the trade ends with what it has
     * @return what is known, or nothing where it was stopped before there was a reference
     * @throws enlightenment.math.InvalidValueException if the folder cannot be used: key "output", or "resume" where it
     *     holds a trade of something else
     */
    public static Optional<TradeResult> run(
            Scene scene,
            TradeSettings settings,
            Path folder,
            boolean resume,
            TradeListener listener,
            BooleanSupplier cancelled)
            throws IOException {
        TradeFolder files = TradeFolder.open(folder, settings, resume);
        Session session = new Session(scene, settings, files, listener, cancelled);
        List<EqualTime> pictures = new ArrayList<>();
        Map<String, String> machine = Machine.facts();
        double cold = 0;
        boolean complete = true;
        try {
            cold = WarmUp.run(session);
            session.reference(new ReferenceMaker(session).make());
            new Ladder(session).climb();
            Trial trial = new Trial(session);
            for (double target : TradeResult.TARGETS) {
                trial.run(target);
            }
            pictures.addAll(EqualTime.make(session));
            sweeps(session);
        } catch (Stopped e) {
            complete = false;
        }
        Circumstances circumstances = new Circumstances(machine, cold, session.elapsed(), complete);
        if (session.reference() == null) {
            return Optional.empty();
        }
        files.keep(session.reference(), circumstances);
        return Optional.of(
                TradeResult.of(settings, session.reference(), session.runs(r -> true), pictures, circumstances));
    }

    /**
     * Evaluates again what a folder holds, without measuring. Only the runs and the figures of the reference are needed; pictures
     * are part of the result as far as they were kept.
     *
     * @throws enlightenment.math.InvalidValueException key "evaluate", if the folder holds no trade or one of something else
     */
    public static TradeResult evaluate(TradeSettings settings, Path folder) throws IOException {
        TradeFolder files = TradeFolder.stored(folder, settings);
        TradeFolder.Kept kept = files.kept();
        List<TradeRun> runs = files.journal().runs();
        return TradeResult.of(
                settings,
                kept.reference(),
                runs,
                EqualTime.stored(
                        settings.methods(), runs, files, kept.reference().variance()),
                kept.circumstances());
    }

    /** The names of all files that {@link #run} may write into its folder, whatever it finds. */
    public static List<String> files(TradeSettings settings) {
        return TradeFolder.names(settings.methods());
    }

    private static void sweeps(Session session) throws IOException {
        List<Sweep> sweeps = session.settings.sweeps();
        for (int i = 0; i < sweeps.size(); i++) {
            double share = BEFORE_SWEEPS + (1 - BEFORE_SWEEPS) * (i + 1) / sweeps.size();
            SweepResult.run(session, sweeps.get(i), share);
        }
    }
}
