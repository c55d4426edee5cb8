package enlightenment.measure;

import enlightenment.image.Image;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.trade.Advice;
import enlightenment.measure.trade.TradeListener;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Measures the trade-off of speed against accuracy for a scene, and advises on settings for an error.
 *
 * <p>All methods are thread-safe. Measurements need an otherwise idle machine.
 */
public final class Trade {
    private Trade() {}

    /**
     * Runs a measurement. Every run is written to the folder's {@code trade.csv} as soon as it has ended, so that an interrupted measurement can be
     * resumed; the reference and the pictures at equal time are written there as well ({@link #files}).
     *
     * @param folder the folder of the measurement; made if it does not exist
     * @param resume whether to resume a measurement that the folder holds; without one, a new one begins
     * @param listener receives the progress
     * @param cancelled polled often, by several threads; once it returns true, the measurement ends with the runs so far
     * @return the result; empty if it was cancelled before there was a reference
     * @throws enlightenment.math.InvalidValueException if the folder cannot be used: key "output", or "resume" where it holds a
     *     measurement with other settings or of another scene
     * @throws enlightenment.scene.SceneException if the scene cannot be rendered
     * @throws IOException if the folder cannot be read or written
     */
    public static Optional<TradeResult> run(
            Scene scene,
            TradeSettings settings,
            Path folder,
            boolean resume,
            TradeListener listener,
            BooleanSupplier cancelled)
            throws IOException {
        // Checked before a folder is made.
        settings.methods().forEach(word -> Method.requireSupport(Method.named(word), scene));
        TradeFolder files = TradeFolder.open(folder, settings, resume);
        List<Renderer.Sight> methods = methods(scene, settings);
        Session session = new Session(scene, settings, methods, files, listener, cancelled);
        Map<String, String> machine = Bench.machine();
        double cold = 0;
        boolean complete = true;
        try {
            cold = WarmUp.run(session);
            session.reference(new ReferenceMaker(session).make());
            new BudgetSeries(session).run();
            Validation validation = new Validation(session);
            for (double target : TradeResult.TARGETS) {
                validation.run(target);
            }
            new EqualTimeRenders(session).run();
            new SweepRunner(session).run();
        } catch (CancelledException e) {
            complete = false;
        }
        if (session.reference() == null) {
            return Optional.empty();
        }
        TradeResult.Conditions conditions = new TradeResult.Conditions(machine, cold, session.elapsed(), complete);
        files.keep(session.reference(), conditions);
        return Optional.of(new TradeResult(
                settings, session.reference(), session.runs(r -> true), conditions, blindSpots(methods)));
    }

    /**
     * Reads the result that a folder holds, without measuring. The runs and the figures of the reference are enough; its picture is
     * part of the result if it was kept.
     *
     * @param scene the scene that was rendered, which has the display curve of pictures of light
     * @param settings the settings of the measurement; budget, number of seeds and sweeps may differ
     * @throws enlightenment.math.InvalidValueException key "evaluate", if the folder holds no finished measurement, or one with other
     *     settings or of another scene
     * @throws IOException if a file cannot be read or is damaged
     */
    public static TradeResult read(Scene scene, TradeSettings settings, Path folder) throws IOException {
        TradeFolder files = TradeFolder.stored(folder, settings);
        MeasurementFile.Content kept = files.kept(scene);
        return new TradeResult(
                settings,
                kept.reference(),
                files.journal().runs(),
                kept.conditions(),
                blindSpots(methods(scene, settings)));
    }

    /** Limitations and least samples of the methods of a measurement, in their order. */
    private static List<Renderer.Sight> methods(Scene scene, TradeSettings settings) {
        List<Renderer.Sight> all = Renderer.inspect(scene, settings.base()).methods();
        List<Renderer.Sight> named = new ArrayList<>();
        for (String word : settings.methods()) {
            named.add(all.stream()
                    .filter(s -> s.method().word().equals(word))
                    .findFirst()
                    // An extension, of which only the name is known.
                    .orElseGet(() -> new Renderer.Sight(Method.named(word), Optional.empty(), 1)));
        }
        return named;
    }

    /** Light that methods do not sample, in words, by the words of the methods. */
    private static Map<String, String> blindSpots(List<Renderer.Sight> methods) {
        Map<String, String> spots = new LinkedHashMap<>();
        for (Renderer.Sight sight : methods) {
            sight.blindSpot().ifPresent(spot -> spots.put(sight.method().word(), spot));
        }
        return spots;
    }

    /**
     * Reads a picture to compare a scene with. A float map is interpreted by the scene's shading: as linear light, or as display colours.
     *
     * @throws IOException if the file cannot be read
     */
    public static Image readReference(Scene scene, Path file) throws IOException {
        return StoredPicture.read(scene, file);
    }

    /**
     * The advice for an error.
     *
     * @param error the root mean square error to reach, in display units; greater than 0. {@link TradeResult#TARGETS} were tried
     */
    public static Advice advice(TradeResult result, double error) {
        return Verdict.of(TradeAnalysis.of(result), error).advice(result.settings());
    }

    /** The names of all files that {@link #run} may write into its folder. */
    public static List<String> files(TradeSettings settings) {
        return TradeFolder.names(settings.methods());
    }
}
