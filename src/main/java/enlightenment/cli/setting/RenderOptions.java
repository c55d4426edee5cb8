package enlightenment.cli.setting;

import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.render.RenderRequest;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that change what a scene says about its rendering. */
public final class RenderOptions {
    @Option(
            names = "--method",
            paramLabel = "METHOD",
            converter = Methods.class,
            completionCandidates = Methods.class,
            description = "how samples are taken: ${COMPLETION-CANDIDATES}")
    private Method method;

    @Option(
            names = "--samples",
            paramLabel = "N",
            converter = Samples.class,
            description = "mean number of camera rays per pixel; instead of --antialias")
    private Double samples;

    @Option(
            names = "--error",
            paramLabel = "E",
            converter = ErrorBound.class,
            description = "largest root mean square error allowed, 0.0000001..1")
    private Double error;

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            converter = Seconds.class,
            description = "take as many samples as fit into about this time")
    private Double time;

    @Mixin
    private SettingsOptions settings = new SettingsOptions();

    public RenderOptions() {}

    /** The options of methods among these. */
    public MethodOptions methods() {
        return settings.methods();
    }

    /** Whether a time was given, with which the picture is not the same each time. */
    public boolean hasTime() {
        return time != null;
    }

    /** Warns if {@code --size} stretches the picture. */
    public void warnOfStretch(Scene scene, RenderSettings rendered, Terminal terminal) {
        settings.warnOfStretch(scene, rendered, terminal);
    }

    /**
     * The settings for a scene: what it asks for, changed by the options.
     *
     * @param input where the scene comes from
     */
    public RenderSettings settings(Scene scene, SceneInput input) {
        RenderSettings s = settings.settings(scene, input).withBudget(budget());
        return method == null ? s : s.withMethod(method);
    }

    /**
     * Chooses the method, if options and scene leave that to the program.
     *
     * @param input where the scene comes from
     * @throws java.util.concurrent.CancellationException if it is stopped before
     */
    public RenderRequest.MethodChoice choose(Scene scene, RenderSettings asked, SceneInput input, Terminal terminal) {
        try {
            return Renderer.choose(scene, asked, terminal.stop());
        } catch (InvalidValueException e) {
            throw blame(e, input);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
    }

    private RenderSettings.Budget budget() {
        RenderSettings.Budget budget = RenderSettings.Budget.NONE;
        budget = samples == null ? budget : budget.withSamples(samples);
        budget = error == null ? budget : budget.withError(error);
        return time == null ? budget : budget.withSeconds(time);
    }

    /** The exception for a value that the renderer refused: the option's fault where it was given, else the scene's. */
    public RuntimeException blame(InvalidValueException e, SceneInput input) {
        return switch (e.key()) {
            case "error" ->
                CliException.wrongUsage("--error " + e.problem() + "; more bits (--depth 16) or a .pfm file can");
            case "device" -> CliException.wrongUsage("--device " + e.problem());
            case "samples" -> CliException.wrongUsage("--samples " + e.problem());
            default -> settings.blame(e, input);
        };
    }

    public static final class Methods extends WordOption<Method> {
        Methods() {
            super(List.of());
        }

        @Override
        protected List<Method> all() {
            return Method.selectable();
        }

        /** Finds the method without listing all: a built-in method needs no search for services. */
        @Override
        protected Optional<Method> find(String word) {
            return Method.of(word);
        }

        @Override
        protected String word(Method method) {
            return method.word();
        }
    }

    static final class Samples extends DecimalNumber {
        Samples() {
            super(1, RenderSettings.Budget.MAX_SAMPLES);
        }
    }

    static final class ErrorBound extends DecimalNumber {
        /** Smaller errors are below the rounding of the picture's floats. */
        private static final double MIN = 1e-7;

        ErrorBound() {
            super(MIN, 1);
        }
    }

    static final class Seconds extends DecimalNumber {
        /** The resolution of the clock. */
        private static final double MIN = 1e-9;

        private static final double MAX = 1e9;

        Seconds() {
            super(MIN, MAX);
        }
    }
}
