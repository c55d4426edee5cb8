package enlightenment.cli.film;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameCheck;
import enlightenment.cli.input.FrameChoice;
import enlightenment.cli.input.SceneArgument;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.progress.ProgressOption;
import enlightenment.cli.progress.Watch;
import enlightenment.cli.progress.WatchOptions;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.file.FilePlace;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.Film;
import enlightenment.render.RenderProgress;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code enlightenment animate}: makes pictures of an animation's frames, and a film of them. */
@Command(
        name = "animate",
        description = "Makes pictures of the frames of an animation, and a film of them.",
        sortOptions = false)
public final class AnimateCommand extends Subcommand {
    @Mixin
    private SceneArgument argument = new SceneArgument();

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    @Mixin
    private FrameOutput output = new FrameOutput();

    @Option(
            names = "--frames",
            paramLabel = "A-B",
            converter = FrameRange.Converter.class,
            description = "only these frames, counted from 0")
    private FrameRange frames;

    @Mixin
    private VideoOption video = new VideoOption();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Mixin
    private DeviceOption device = new DeviceOption();

    @Mixin
    private FilmReport report = new FilmReport();

    @Mixin
    private WatchOptions watching = new WatchOptions();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    @Mixin
    private FilmServing serving = new FilmServing();

    private SceneInput input;

    public AnimateCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    public List<OptionRule> rules() {
        return OptionRules.ANIMATE;
    }

    @Override
    protected int execute() throws IOException {
        input = argument.open(foreign, terminal);
        Scene scene = input.read(Optional.empty());
        Animation animation = scene.animation()
                .orElseThrow(() -> CliException.wrongUsage(
                        input.name() + " has no \"animation\": 'render' makes its only picture"));
        FrameRange range =
                frames == null ? new FrameRange(0, animation.frames() - 1) : frames.within(animation.frames());
        view.check(scene);
        output.aov().check(scene);
        options.warnOfStretch(scene, options.settings(scene, input), terminal);
        List<Path> files = range.frames().mapToObj(output.pattern()::file).toList();
        check(scene, range, files);
        video.check(animation.framesPerSecond(), output.pattern(), range, terminal);
        ServerOptions server = serving.options(device, output.scratch(), terminal);
        checkFrames(animation, range);
        FrameSettings settings = new FrameSettings(options, output, input);
        FrameDigest digests = new FrameDigest(output, view);
        Film film = Film.of(animation, frame -> input.read(Optional.of(frame)));
        FrameFiles plan = FrameFiles.of(output, range, frame -> {
            Scene at = film.scene(frame);
            return digests.of(at, settings.of(at));
        });
        tellKept(plan, range);
        makeFolder();
        FrameWriter writer = new FrameWriter(output, view, digests, report, terminal);
        FrameMaker maker = server == null
                ? new FrameRenderer(film, settings, output, device, writer, watching, terminal)
                : new ServedFrames(film, settings, writer, serving, server, terminal);
        RenderSettings asWritten = options.settings(scene, input);
        String title = scene.name().isEmpty() ? input.name() : scene.name();
        return watching.watch(title, asWritten, view, true, terminal, w -> {
            int faulty = make(maker, writer.notes(), plan, range, w);
            finish(files, range, faulty, maker.audits().orElse(RenderServer.AuditReport.NONE));
        });
    }

    private void finish(List<Path> files, FrameRange range, int faulty, RenderServer.AuditReport audits)
            throws IOException {
        writeVideo(files, range);
        serving.options().tellAudits(audits, terminal);
        if (faulty > 0) {
            throw CliException.failed(faulty + (faulty == 1 ? " frame is" : " frames are") + " not as asked");
        }
        serving.options().requireAudits(audits);
    }

    private void check(Scene scene, FrameRange range, List<Path> frames) throws IOException {
        CommandFiles files = new CommandFiles()
                .reads(argument.file(), scene)
                .reads("the program of --ffmpeg", video.program())
                .writesNumbered("-o", frames);
        register(files, "--video", video.file());
        register(files, "--report", report.file());
        serving.register(files);
        if (!output.aov().kinds().isEmpty()) {
            files.writesNumbered(
                    "--aov",
                    range.frames()
                            .boxed()
                            .flatMap(frame -> output.beside(frame).files().stream())
                            .toList());
        }
        files.check();
    }

    private void register(CommandFiles files, String option, Path file) throws IOException {
        if (isInNewFolder(file)) {
            files.makes(option, file);
        } else {
            files.writes(option, file);
        }
    }

    /** Whether a file is to lie in the folder of the frames, which will be made. */
    private boolean isInNewFolder(Path file) throws IOException {
        Path folder = output.pattern().folder();
        return file != null
                && file.getParent() != null
                && !Files.exists(folder)
                && FilePlace.same(file.getParent(), folder);
    }

    /** As many as can be looked at in some seconds. */
    private void checkFrames(Animation animation, FrameRange range) throws IOException {
        FrameCheck check = new FrameCheck(input, animation);
        for (int frame : FrameChoice.of(animation, input.size()).frames()) {
            if (frame >= range.first() && frame <= range.last()) {
                check.check(frame);
            }
        }
    }

    private void tellKept(FrameFiles plan, FrameRange range) {
        if (!plan.kept().isEmpty()) {
            terminal.say(plan.kept().size() + " of " + range.count() + " frames are there already");
        }
    }

    private void makeFolder() {
        try {
            Files.createDirectories(output.pattern().folder());
        } catch (IOException e) {
            throw CliException.failed(
                    "-o: the folder " + output.pattern().folderName() + " cannot be made: " + FileFailure.described(e));
        }
    }

    /** @return how many frames are not as asked */
    private int make(FrameMaker maker, FilmNotes notes, FrameFiles plan, FrameRange range, Watch watch)
            throws IOException {
        RenderProgress display = progress.display(terminal.err());
        Set<Integer> written = new HashSet<>();
        Set<Integer> faulty = new HashSet<>();
        watch.frames(plan.missing());
        report.begin(range.count(), plan.kept().size());
        boolean areAllThere;
        try {
            areAllThere = maker.make(plan.missing(), watch.over(display), (frame, isFaulty) -> {
                watch.written(frame);
                written.add(frame);
                faulty.remove(frame);
                if (isFaulty) {
                    faulty.add(frame);
                }
            });
        } finally {
            ProgressOption.end(display);
            notes.finish(written.size());
        }
        report.write(maker.audits(), terminal);
        if (!areAllThere) {
            throw stopped(plan.kept().size() + written.size(), range, "");
        }
        return faulty.size();
    }

    private CliException stopped(int done, FrameRange range, String more) {
        return CliException.failed("stopped: " + done + " of " + range.count() + " frames are in "
                + output.pattern().folderName() + more + "; the same command goes on from there");
    }

    private void writeVideo(List<Path> files, FrameRange range) throws IOException {
        try {
            video.write(files, terminal);
        } catch (CancellationException e) {
            throw stopped(range.count(), range, ", " + video.file() + " was not written");
        }
    }
}
