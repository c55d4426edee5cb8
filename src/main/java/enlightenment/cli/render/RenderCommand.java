package enlightenment.cli.render;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneArgument;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.FileNames;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.NumberOrNothing;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.AovFiles;
import enlightenment.cli.picture.AovSet;
import enlightenment.cli.picture.DenoisedOutput;
import enlightenment.cli.picture.LightNotes;
import enlightenment.cli.picture.PictureOutput;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.picture.ReportOutput;
import enlightenment.cli.picture.RequestedError;
import enlightenment.cli.picture.StoppedRender;
import enlightenment.cli.picture.UniformImageHint;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.progress.PreviewWriter;
import enlightenment.cli.progress.ProgressOption;
import enlightenment.cli.progress.Watch;
import enlightenment.cli.progress.WatchOptions;
import enlightenment.cli.setting.BudgetNotes;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.store.ArchiveList;
import enlightenment.cli.store.SampleOptions;
import enlightenment.cli.store.StoreOptions;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.net.parts.RenderParts;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.LongSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code enlightenment render}: makes a picture of a scene. */
@Command(name = "render", description = "Makes a picture of a scene.", sortOptions = false)
public final class RenderCommand extends Subcommand {
    @Mixin
    private SceneArgument argument = new SceneArgument();

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    @Mixin
    private PictureOutput output = new PictureOutput();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Mixin
    private FrameOption frame = new FrameOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    @Option(
            names = "--aov",
            paramLabel = "LIST",
            converter = AovSet.Converter.class,
            completionCandidates = AovSet.Words.class,
            description = "write further files beside the picture: some of ${COMPLETION-CANDIDATES}, with commas")
    private AovSet aov = AovSet.EMPTY;

    @Mixin
    private DenoisedOutput denoised = new DenoisedOutput();

    @Option(
            names = "--dump-clusters",
            paramLabel = "FILE",
            description = "write the ray clusters with their nine distributions to this .json or .csv file")
    private Path clusters;

    @Option(
            names = "--dump-chains",
            paramLabel = "FILE",
            description = "write what became of each Markov chain to this .json or .csv file")
    private Path chains;

    @Option(
            names = "--preview",
            arity = "0..1",
            paramLabel = "SECONDS",
            fallbackValue = PreviewPeriod.DEFAULT,
            converter = PreviewPeriod.class,
            preprocessor = PreviewPeriod.OrDefault.class,
            description = "while rendering, write the picture so far about this often (without SECONDS: every "
                    + PreviewPeriod.DEFAULT + ")")
    private Double preview;

    @Mixin
    private WatchOptions watching = new WatchOptions();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    @Option(
            names = "--part",
            paramLabel = "I/N",
            converter = PartNumber.Converter.class,
            description = "render only part I of N, into a .film file; 'merge' makes a picture of all N")
    private PartNumber part;

    @Mixin
    private DeviceOption device = new DeviceOption();

    @Mixin
    private KeepOptions keep = new KeepOptions();

    @Mixin
    private StoreOptions store = new StoreOptions();

    @Mixin
    private SampleOptions samples = new SampleOptions();

    private final LongSupplier clock;
    private AovFiles aovFiles;
    private SceneInput input;

    public RenderCommand(Terminal terminal) {
        this(terminal, System::nanoTime);
    }

    /** @param clock nanoseconds, for previews */
    RenderCommand(Terminal terminal, LongSupplier clock) {
        super(terminal);
        this.clock = clock;
    }

    @Override
    public Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.RENDER;
    }

    @Override
    protected int execute() throws IOException {
        checkOptions();
        aovFiles = new AovFiles(hasFurtherFiles() ? aov : AovSet.EMPTY, output.file());
        input = argument.open(foreign, terminal);
        Scene scene = frame.read(input);
        RenderSettings settings = PictureOutput.withRounding(
                options.settings(scene, input), part == null ? output.writtenDepth() : output.depthOfWhole());
        view.check(scene);
        aov.check(scene);
        options.warnOfStretch(scene, settings, terminal);
        CommandFiles files = new CommandFiles().reads(argument.file(), scene).writes("-o", output.file());
        report.register(files);
        files.writes("--dump-clusters", clusters);
        files.writes("--dump-chains", chains);
        aovFiles.register(files);
        denoised.register(files);
        keep.register(files);
        store.register(files);
        files.check();
        denoised.check(scene, settings);
        try {
            return make(scene, options.choose(scene, settings, input, terminal));
        } catch (CancellationException e) {
            throw output.nothingRendered();
        }
    }

    private int make(Scene scene, RenderRequest.MethodChoice choice) throws IOException {
        RenderSettings settings = choice.settings();
        samples.check(settings);
        if (clusters != null) {
            ClusterFile.check(clusters, settings);
        }
        if (chains != null) {
            ChainFile.check(chains, settings);
        }
        if (part == null) {
            output.check(settings);
            String title = scene.name().isEmpty() ? input.name() : scene.name();
            boolean keeps = !output.isStandardOutput();
            return watching.watch(title, settings, view, keeps, terminal, w -> renderPicture(scene, choice, w));
        }
        choice.reason().ifPresent(terminal::say);
        renderPart(scene, settings);
        return ExitCode.DONE;
    }

    /** Checks options by their values; {@link OptionRules} checks only which are given. */
    private void checkOptions() {
        if (part == null) {
            output.check();
            view.check(output);
        } else if (!FileNames.extension(output.file()).equals(".film")) {
            throw CliException.wrongUsage(
                    "with --part, -o must name a file that ends in .film, not \"" + output.file() + "\"");
        }
        store.check();
        boolean hasFurther = hasFurtherFiles();
        if (output.isStandardOutput() && (hasFurther || preview != null)) {
            throw CliException.wrongUsage((hasFurther ? "--aov writes files beside" : "--preview replaces")
                    + " the picture: -o must name a file, not standard output");
        }
        Path file = output.file();
        if (preview != null && CommandFiles.isDevice(file)) {
            throw CliException.wrongUsage("--preview needs a file that can be replaced, unlike \"" + file + "\"");
        }
    }

    /** Whether there will be files beside the picture: in some formats further numbers are part of it. */
    private boolean hasFurtherFiles() {
        return !aov.kinds().isEmpty() && !output.holdsLayers();
    }

    private void renderPart(Scene scene, RenderSettings settings) throws IOException {
        RenderProgress display = progress.display(terminal.err());
        boolean complete;
        try {
            RenderRequest request = device.addTo(RenderRequest.of(scene, settings))
                    .withProgress(new BudgetNotes(display, settings.budget(), terminal))
                    .withCancelled(terminal.stop());
            complete = RenderParts.render(
                    request,
                    part.index(),
                    part.count(),
                    samples -> PictureText.of(scene, SettingsLine.replayable(settings, samples, frame.number())),
                    output.file());
        } catch (CancellationException e) {
            throw output.nothingRendered();
        } catch (InvalidValueException e) {
            throw options.blame(e, input);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        } finally {
            ProgressOption.end(display);
        }
        progress.tellWritten(output.file(), terminal);
        if (!complete) {
            throw CliException.failed("stopped: " + output.file() + " holds only some of part " + part);
        }
    }

    private void renderPicture(Scene scene, RenderRequest.MethodChoice choice, Watch watch) throws IOException {
        RenderSettings settings = choice.settings();
        RenderResult result;
        try (ArchiveList archives = new ArchiveList(terminal)) {
            keep.open(scene, settings, terminal).ifPresent(archives::add);
            store.open(scene, settings, frame.number(), samples.wanted(), terminal)
                    .ifPresent(archives::add);
            result = render(scene, choice, watch, archives.all());
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
        if (result.shownPixels() == 0) {
            throw output.nothingRendered();
        }
        double samples = result.report().sampling().plannedSamples();
        String line = SettingsLine.replayable(settings, samples, frame.number());
        Map<String, String> texts = PictureText.of(scene, line);
        Image shown = view.view(result.image(), terminal);
        watch.rendered(shown, result);
        output.write(shown, texts, settings, output.holdsLayers() ? result.auxiliary() : Map.of(), terminal);
        progress.tellWritten(output.file(), terminal);
        aovFiles.write(result.auxiliary(), shown, output.pngOptions(texts));
        denoised.write(result, shown, output, texts, settings);
        report.write(result, choice.reason(), Optional.empty(), output, terminal);
        if (clusters != null) {
            ClusterFile.write(clusters, result, terminal);
        }
        if (chains != null) {
            ChainFile.write(chains, result, terminal);
        }
        if (!result.complete()) {
            boolean hasPreview = result.shownPixels() > result.report().pixels();
            throw StoppedRender.after(result, output, hasPreview ? ", and a preview of the rest" : "", keep.hint());
        }
        if (!UniformImageHint.tell(scene, settings, result, terminal)) {
            output.tellBrightness(result, shown, terminal);
        }
        LightNotes.tell(result, terminal::say);
        LightNotes.require(result, shown);
        RequestedError.require(result);
    }

    private RenderResult render(
            Scene scene, RenderRequest.MethodChoice choice, Watch watch, List<RenderResult.Archive> archives) {
        RenderSettings settings = choice.settings();
        RenderProgress display = progress.display(terminal.err());
        RenderProgress told = new BudgetNotes(display, settings.budget(), terminal);
        PreviewWriter writer = preview == null ? null : previewWriter(scene, settings, told);
        RenderRequest request = device.addTo(RenderRequest.of(scene, settings))
                .withChoice(choice)
                .withProgress(watch.over(writer == null ? told : writer))
                .withCancelled(terminal.stop())
                .withAuxiliary(aov.kinds())
                .withDenoised(denoised.isGiven())
                .withClusters(clusters != null)
                .withChains(chains != null)
                .withArchives(archives)
                .withProgressive(writer != null)
                .withWatched(watching.isGiven());
        Optional<RenderRequest.ScratchFolder> scratch =
                watching.needsWholePicture() ? Optional.empty() : output.scratch();
        try {
            return Renderer.render(scratch.map(request::withScratch).orElse(request));
        } catch (CancellationException e) {
            throw output.nothingRendered();
        } catch (InvalidValueException e) {
            throw options.blame(e, input);
        } finally {
            if (writer != null) {
                writer.finish();
            }
            ProgressOption.end(display);
        }
    }

    private PreviewWriter previewWriter(Scene scene, RenderSettings settings, RenderProgress display) {
        Map<String, String> texts = PictureText.of(scene, SettingsLine.of(settings, frame.number()));
        texts.put("Comment", "preview");
        return new PreviewWriter(
                display, preview, image -> output.write(view.view(image), texts, settings, terminal), terminal, clock);
    }

    static final class PreviewPeriod extends DecimalNumber {
        /** Seconds: a picture is looked at about so often, and writing it takes far less. */
        static final String DEFAULT = "5";

        private static final double MIN = 0.01;
        private static final double MAX = 1e9;

        /** Takes the next argument only if it is a number: the scene's name is none. */
        static final class OrDefault extends NumberOrNothing {
            OrDefault() {
                super(DEFAULT);
            }
        }

        PreviewPeriod() {
            super(MIN, MAX);
        }
    }
}
