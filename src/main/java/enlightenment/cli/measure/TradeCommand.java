package enlightenment.cli.measure;

import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneFingerprint;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.progress.ProgressOption;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.setting.SettingsOptions;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.measure.Trade;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.measure.trade.Sweep;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment trade}: measures what accuracy costs. */
@Command(
        name = "trade",
        description = "Measures the trade-off between time and accuracy of each method, and tells what to use.",
        sortOptions = false)
public final class TradeCommand extends Subcommand {
    /** The reference is made rather than read. */
    private static final Path AUTO = Path.of("auto");

    @Parameters(paramLabel = "SCENE", description = "the scene file")
    private Path sceneFile;

    private SceneInput input;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "DIR",
            description = "a folder for tables, charts, pictures and the page index.html")
    private Path folder;

    @Option(
            names = "--methods",
            paramLabel = "LIST",
            converter = MethodList.Converter.class,
            completionCandidates = RenderOptions.Methods.class,
            description = "methods to compare, with commas (default: all of our own that can render the scene)")
    private MethodList methods;

    @Option(
            names = "--budget",
            paramLabel = "SECONDS",
            converter = Seconds.class,
            description = "take about this long (default: 45 for each method, at least 90)")
    private Double budget;

    @Option(
            names = "--seeds",
            paramLabel = "N",
            converter = Seeds.class,
            description = "renders of each number of samples, 1..1000 (default: 3)")
    private int seeds = 3;

    @Option(
            names = "--reference",
            paramLabel = "FILE",
            description = "the picture to compare with: a .pfm or .png file, or auto (default) to make one")
    private Path reference = AUTO;

    @Option(
            names = "--sweep",
            paramLabel = "NAME=A..B",
            converter = SweepConverter.class,
            description = "also vary a setting: antialias=1..8, shadowSamples=1..256 or threads=1..N; may be repeated")
    private List<Sweep> sweeps = new ArrayList<>();

    @Option(names = "--resume", description = "go on with the measurements in the folder")
    private boolean resume;

    @Option(
            names = "--evaluate",
            description = "measure nothing: make advice, page and tables again from the measurements in the folder")
    private boolean evaluate;

    @Mixin
    private SettingsOptions options = new SettingsOptions();

    @Mixin
    private FrameOption frame = new FrameOption();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    // Known only to say what to use instead.
    @Option(names = "--method", hidden = true, converter = ChosenByTheTrade.class)
    private String method;

    @Option(names = "--samples", hidden = true, converter = ChosenByTheTrade.class)
    private String samples;

    @Option(names = "--error", hidden = true, converter = ChosenByTheTrade.class)
    private String error;

    @Option(names = "--time", hidden = true, converter = ChosenByTheTrade.class)
    private String time;

    public TradeCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.TRADE;
    }

    @Override
    protected int execute() throws IOException {
        checkOptions();
        input = new SceneInput(sceneFile, terminal);
        Scene scene = frame.read(input);
        TradeSettings settings = settings(scene);
        new CommandFiles()
                .reads(sceneFile, scene)
                .reads("the file of --reference", reference.equals(AUTO) ? null : reference)
                .writes("-o", folder, TradeOutput.names(settings))
                .check();
        List<String> given = new ArrayList<>(options.given());
        given.addAll(frame.given());
        TradeOutput output = new TradeOutput(terminal, folder, sceneFile, given, scene.name());
        if (evaluate) {
            evaluate(scene, settings, output);
        } else {
            measure(scene, settings, output);
        }
        return ExitCode.DONE;
    }

    private void checkOptions() {
        if (StandardStreams.isNamed(sceneFile)) {
            throw CliException.wrongUsage("a trade needs a scene file, not standard input: it can be resumed");
        }
        for (int i = 0; i < sweeps.size(); i++) {
            String name = sweeps.get(i).name();
            if (sweeps.subList(0, i).stream().anyMatch(s -> s.name().equals(name))) {
                throw CliException.wrongUsage("--sweep must name each setting once, not " + name + " twice");
            }
        }
    }

    private TradeSettings settings(Scene scene) throws IOException {
        if (scene.shading() instanceof Shading.Physical
                && sweeps.stream()
                        .anyMatch(s -> s.name().equals(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.key()))) {
            throw CliException.wrongUsage(
                    "--sweep shadowSamples has nothing to vary with physical shading, where a path takes"
                            + " one light sample at a time");
        }
        RenderSettings base = options.settings(scene, input);
        options.warnOfStretch(scene, base, terminal);
        List<Method> compared = (methods == null ? MethodList.oursFor(scene) : methods).methods();
        if (!compared.contains(base.method())) {
            base = base.withMethod(compared.get(0));
        }
        List<String> words = compared.stream().map(Method::word).toList();
        Optional<Image> given = reference.equals(AUTO) ? Optional.empty() : Optional.of(readReference(scene));
        String ofFrame = frame.number() == null ? "" : ", frame " + frame.number();
        String sceneKey = sceneFile.getFileName() + ", SHA-256 " + SceneFingerprint.of(scene) + ofFrame;
        try {
            double seconds = budget == null ? TradeSettings.budgetSeconds(words.size()) : budget;
            return new TradeSettings(scene.shading().model(), base, words, seconds, seeds, sweeps, given, sceneKey);
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--" + optionOf(e.key()) + " " + e.problem());
        }
    }

    private Image readReference(Scene scene) {
        try {
            return Trade.readReference(scene, reference);
        } catch (IOException e) {
            throw CliException.wrongUsage("--reference: " + FileFailure.described(e));
        }
    }

    /** A setting that cannot be varied that far is the fault of its sweep. */
    private static String optionOf(String key) {
        return List.of("methods", "budget", "seeds", "reference").contains(key) ? key : "sweep " + key;
    }

    private void evaluate(Scene scene, TradeSettings settings, TradeOutput output) throws IOException {
        try {
            tellAutomatic(scene, output.write(Trade.read(scene, settings, folder)));
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--evaluate: " + e.problem());
        }
    }

    private void measure(Scene scene, TradeSettings settings, TradeOutput output) throws IOException {
        Optional<TradeResult> result;
        try (TradeProgress display = TradeProgress.of(progress.kind(), terminal.err())) {
            result = Trade.run(scene, settings, folder, resume, display, terminal.stop());
        } catch (InvalidValueException e) {
            throw blame(e);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
        if (result.isEmpty()) {
            throw CliException.failed("stopped before there was anything to compare with; --resume goes on");
        }
        tellAutomatic(scene, output.write(result.get()));
        if (!result.get().conditions().complete()) {
            throw CliException.failed("stopped: " + folder + " holds what was measured; --resume goes on");
        }
    }

    private void tellAutomatic(Scene scene, TradeAnalysis result) {
        try {
            AutomaticChoice.sentence(scene, result, terminal.stop()).ifPresent(terminal::show);
        } catch (CancellationException e) {
            // What was measured is written.
        }
    }

    private RuntimeException blame(InvalidValueException e) {
        return switch (e.key()) {
            case "output" -> CliException.wrongUsage("-o: " + e.problem());
            case "resume" -> CliException.wrongUsage("--resume: " + e.problem());
            default -> options.blame(e, input);
        };
    }

    static final class Seconds extends DecimalNumber {
        private static final double MIN = 0.1;
        private static final double MAX = 1e7;

        Seconds() {
            super(MIN, MAX);
        }
    }

    static final class Seeds extends WholeNumber {
        Seeds() {
            super(1, TradeSettings.MAX_SEEDS);
        }
    }

    static final class SweepConverter implements ITypeConverter<Sweep> {
        @Override
        public Sweep convert(String text) {
            try {
                return Sweep.parse(text);
            } catch (IllegalArgumentException e) {
                throw new BadValue(e.getMessage());
            }
        }
    }

    /** Refuses an option for what the trade chooses itself. */
    static final class ChosenByTheTrade implements ITypeConverter<String> {
        @Override
        public String convert(String text) {
            throw new BadValue(
                    "must not be given here: the trade tries methods and budgets itself; see --methods and --budget");
        }
    }
}
