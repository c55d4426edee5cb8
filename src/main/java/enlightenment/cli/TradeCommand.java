package enlightenment.cli;

import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.math.InvalidValueException;
import enlightenment.measure.Sweep;
import enlightenment.measure.Trade;
import enlightenment.measure.TradeResult;
import enlightenment.measure.TradeSettings;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment trade}: measures what accuracy costs. */
@Command(
        name = "trade",
        description = "Measures what accuracy costs in time, for each method, and tells what to use.",
        sortOptions = false)
final class TradeCommand extends Subcommand {
    private static final String DEFAULT_BUDGET = "90";
    private static final double LEAST_BUDGET = 0.1;
    private static final double MOST_BUDGET = 1e7;

    @Parameters(paramLabel = "SCENE", description = "the scene file")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "DIR",
            description = "a folder for tables, charts, pictures and the page index.html")
    private Path folder;

    @Option(names = "--methods", paramLabel = "LIST", description = "what to compare (default: raytrace,cluster)")
    private String methods = String.join(",", Renderer.METHODS);

    @Option(names = "--budget", paramLabel = "SECONDS", description = "take about this long (default: 90)")
    private String budget = DEFAULT_BUDGET;

    @Option(names = "--seeds", paramLabel = "N", description = "renders of each budget, 1..1000 (default: 3)")
    private String seeds = "3";

    @Option(
            names = "--reference",
            paramLabel = "FILE",
            description = "what to take for the truth: a .pfm or .png file, or auto (default)")
    private String reference = "auto";

    @Option(
            names = "--sweep",
            paramLabel = "NAME=A..B",
            description =
                    "turn a switch as well: antialias=1..8, shadowSamples=1..256 or threads=1..N; may be repeated")
    private List<String> sweeps = new ArrayList<>();

    @Option(names = "--resume", description = "go on with what the folder holds")
    private boolean resume;

    @Option(
            names = "--evaluate",
            description = "measure nothing: advice, page and tables again from what the folder holds")
    private boolean evaluate;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress = "auto";

    TradeCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        options.refuseBudgets("the trade tries methods and budgets itself; see --methods and --budget");
        options.check();
        OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        if (Standard.is(sceneFile)) {
            throw CliException.wrongUsage("a trade needs a scene file, not standard input: it can be resumed");
        }
        if (evaluate && resume) {
            throw CliException.wrongUsage("--evaluate measures nothing: it does not go with --resume");
        }
        List<String> chosen = methods();
        double seconds = OptionValues.number("--budget", budget, LEAST_BUDGET, MOST_BUDGET);
        int count = OptionValues.integer("--seeds", seeds, 1, TradeSettings.MAX_SEEDS);
        List<Sweep> switches = sweeps();
        Scene scene = options.frame().isPresent()
                ? SceneReader.read(sceneFile, options.frame().get())
                : SceneReader.read(sceneFile);
        RenderSettings base = options.settings(scene, sceneFile.toString());
        options.tellOfStretch(scene, base, terminal);
        if (!chosen.contains(base.method())) {
            base = base.withMethod(chosen.get(0));
        }
        Optional<Image> truth = reference.equals("auto") ? Optional.empty() : Optional.of(read(Path.of(reference)));
        TradeSettings settings;
        try {
            settings = new TradeSettings(base, chosen, seconds, count, switches, truth, sceneKey(scene));
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--" + optionOf(e.key()) + " " + e.problem());
        }
        new OutputFiles()
                .reads(sceneFile, scene)
                .reads("the file of --reference", reference.equals("auto") ? null : Path.of(reference))
                .writes("-o", folder, TradeOutput.names(settings))
                .check();
        TradeOutput output = new TradeOutput(terminal, folder, sceneFile, options.given(), scene.name());
        return evaluate ? evaluate(settings, output) : measure(scene, settings, output);
    }

    private int evaluate(TradeSettings settings, TradeOutput output) throws IOException {
        try {
            output.write(Trade.evaluate(settings, folder));
        } catch (InvalidValueException e) {
            throw CliException.wrongUsage("--evaluate: " + e.problem());
        }
        return CliException.DONE;
    }

    private int measure(Scene scene, TradeSettings settings, TradeOutput output) throws IOException {
        Optional<TradeResult> result;
        try (TradeProgress display = TradeProgress.of(progress, terminal.err())) {
            result = Trade.run(scene, settings, folder, resume, display, terminal.stop());
        } catch (InvalidValueException e) {
            if (e.key().equals("output")) {
                throw CliException.wrongUsage("-o: " + e.problem());
            }
            if (e.key().equals("resume")) {
                throw CliException.wrongUsage("--resume: " + e.problem());
            }
            throw options.blame(e, sceneFile.toString());
        } catch (SceneException e) {
            throw Failures.inFile(sceneFile.toString(), e);
        }
        if (result.isEmpty()) {
            terminal.say("stopped before there was anything to compare with; --resume goes on");
            return CliException.FAILED;
        }
        output.write(result.get());
        if (!result.get().circumstances().complete()) {
            terminal.say("stopped: " + folder + " holds what was measured; --resume goes on");
            return CliException.FAILED;
        }
        return CliException.DONE;
    }

    private List<String> methods() {
        List<String> chosen = List.of(methods.split(",", -1));
        for (String method : chosen) {
            if (!Renderer.METHODS.contains(method)) {
                throw CliException.wrongUsage("--methods must be some of " + String.join(",", Renderer.METHODS)
                        + ", not \"" + methods + "\"");
            }
        }
        Set<String> once = new HashSet<>(chosen);
        if (once.size() < chosen.size()) {
            throw CliException.wrongUsage("--methods must name each method once, not \"" + methods + "\"");
        }
        return chosen;
    }

    private List<Sweep> sweeps() {
        List<Sweep> all = new ArrayList<>();
        for (String text : sweeps) {
            Sweep sweep;
            try {
                sweep = Sweep.parse(text);
            } catch (IllegalArgumentException e) {
                throw CliException.wrongUsage("--sweep " + e.getMessage());
            }
            if (all.stream().anyMatch(s -> s.name().equals(sweep.name()))) {
                throw CliException.wrongUsage("--sweep must name each switch once, not " + sweep.name() + " twice");
            }
            all.add(sweep);
        }
        return all;
    }

    /** A switch that cannot be turned so far is the fault of its sweep. */
    private String optionOf(String key) {
        return key.equals("methods") || key.equals("budget") || key.equals("seeds") || key.equals("reference")
                ? key
                : "sweep " + key;
    }

    private static Image read(Path file) {
        try {
            return ImageFiles.read(file);
        } catch (IOException e) {
            throw CliException.wrongUsage("--reference: " + Failures.describe(e));
        }
    }

    /** Tells this scene from all others, with what its image files hold, and this frame of it. */
    private String sceneKey(Scene scene) throws IOException {
        String json;
        try {
            json = SceneWriter.toJson(scene.withoutAnimation(), TradeCommand::hashOf);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        String frame = options.frame().map(f -> ", frame " + f).orElse("");
        return sceneFile.getFileName() + ", SHA-256 " + ContentHash.of(json.getBytes(StandardCharsets.UTF_8)) + frame;
    }

    private static String hashOf(Path image) {
        try {
            return ContentHash.of(Files.readAllBytes(image)).toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
