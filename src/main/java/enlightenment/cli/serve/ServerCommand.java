package enlightenment.cli.serve;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneArgument;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.LightNotes;
import enlightenment.cli.picture.PictureOutput;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.picture.ReportOutput;
import enlightenment.cli.picture.RequestedError;
import enlightenment.cli.picture.StoppedRender;
import enlightenment.cli.picture.UniformImageHint;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.progress.ProgressOption;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.store.ArchiveList;
import enlightenment.cli.store.StoreOptions;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.store.StoredSamples;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code enlightenment server}: makes a picture of a scene with the help of workers. */
@Command(name = "server", description = "Makes a picture of a scene with the help of workers.", sortOptions = false)
public final class ServerCommand extends Subcommand {
    @Mixin
    private SceneArgument argument = new SceneArgument();

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    @Mixin
    private PictureOutput output = new PictureOutput();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private ServingOptions serving = new ServingOptions();

    @Mixin
    private DeviceOption device = new DeviceOption();

    @Mixin
    private ServerKeepOptions keep = new ServerKeepOptions();

    @Mixin
    private StoreOptions store = new StoreOptions();

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Mixin
    private FrameOption frame = new FrameOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    private SceneInput input;
    private RenderServer.AuditReport audits = RenderServer.AuditReport.NONE;

    public ServerCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.SERVER;
    }

    @Override
    protected int execute() throws IOException {
        output.check();
        view.check(output);
        store.check();
        ServerOptions.Builder builder = keep.addTo(serving.options(terminal)).device(device.word());
        output.scratch().ifPresent(builder::scratch);
        ServerOptions serverOptions = builder.build();
        input = argument.open(foreign, terminal);
        Scene scene = frame.read(input);
        RenderSettings settings = PictureOutput.withRounding(options.settings(scene, input), output.writtenDepth());
        output.check(settings);
        view.check(scene);
        options.warnOfStretch(scene, settings, terminal);
        CommandFiles files = new CommandFiles().reads(argument.file(), scene);
        serving.register(files);
        keep.register(files);
        store.register(files);
        files.writes("-o", output.file());
        report.register(files);
        files.check();
        RenderRequest.MethodChoice choice = choose(scene, settings);
        choice.reason().ifPresent(terminal::say);
        finish(serve(scene, choice.settings(), serverOptions), scene, choice);
        return ExitCode.DONE;
    }

    private RenderRequest.MethodChoice choose(Scene scene, RenderSettings settings) {
        try {
            return options.choose(scene, settings, input, terminal);
        } catch (CancellationException e) {
            throw output.nothingRendered();
        }
    }

    private RenderResult serve(Scene scene, RenderSettings settings, ServerOptions serverOptions) throws IOException {
        RenderProgress display = progress.display(terminal.err());
        try (ArchiveList archives = archives(scene, settings);
                RenderServer server = RenderServer.start(
                        scene, settings, serverOptions.withArchives(archives.all()), terminal.stop())) {
            serving.announce(server.port(), server.pin(), server.statusPort(), terminal);
            RenderResult result = server.await(display, terminal.stop());
            audits = server.audits();
            return result;
        } catch (CancellationException e) {
            throw output.nothingRendered();
        } catch (InvalidValueException e) {
            throw options.blame(e, input);
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage(e.getMessage());
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        } finally {
            ProgressOption.end(display);
        }
    }

    private ArchiveList archives(Scene scene, RenderSettings settings) throws IOException {
        ArchiveList archives = new ArchiveList(terminal);
        store.open(scene, settings, frame.number(), StoredSamples.NONE, terminal)
                .ifPresent(archives::add);
        return archives;
    }

    private void finish(RenderResult result, Scene scene, RenderRequest.MethodChoice choice) throws IOException {
        if (result.report().pixels() == 0) {
            throw output.nothingRendered();
        }
        double samples = result.report().sampling().plannedSamples();
        String line = SettingsLine.replayable(choice.settings(), samples, frame.number());
        Image shown = view.view(result.image(), terminal);
        output.write(shown, PictureText.of(scene, line), choice.settings(), terminal);
        progress.tellWritten(output.file(), terminal);
        report.write(result, choice.reason(), Optional.of(audits), output, terminal);
        if (!result.complete()) {
            throw StoppedRender.after(result, output, "");
        }
        if (!UniformImageHint.tell(scene, choice.settings(), result, terminal)) {
            output.tellBrightness(result, shown, terminal);
        }
        LightNotes.tell(result, terminal::say);
        LightNotes.require(result, shown);
        serving.tellAudits(audits, terminal);
        RequestedError.require(result);
        serving.requireAudits(audits);
    }
}
