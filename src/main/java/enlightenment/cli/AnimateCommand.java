package enlightenment.cli;

import enlightenment.render.Film;
import enlightenment.render.RenderProgress;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code enlightenment animate}: makes pictures of an animation's frames, and a film of them. */
@Command(
        name = "animate",
        description = "Makes pictures of the frames of an animation, and a film of them.",
        sortOptions = false)
final class AnimateCommand extends Subcommand {
    @Mixin
    private SceneArgument argument = new SceneArgument();

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
    private WatchOptions watching = new WatchOptions();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    private SceneInput input;

    AnimateCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    int execute() throws IOException {
        input = argument.open(terminal);
        Scene scene = input.read(Optional.empty());
        Animation animation = scene.animation()
                .orElseThrow(() -> CliException.wrongUsage(
                        input.name() + " has no \"animation\": 'render' makes its only picture"));
        FrameRange range =
                frames == null ? new FrameRange(0, animation.frames() - 1) : frames.within(animation.frames());
        view.check(scene);
        RenderSettings settings = options.settings(scene, input.name());
        options.warnOfStretch(scene, settings, terminal);
        List<Path> files = range.frames().mapToObj(output.pattern()::file).toList();
        new CommandFiles()
                .reads(argument.file(), scene)
                .reads("the program of --ffmpeg", video.program())
                .writes("--video", video.file())
                .writesNumbered("-o", files)
                .check();
        video.check(animation.framesPerSecond(), output.pattern(), range, terminal);
        checkFrames(animation, range);
        FrameDigest digests = new FrameDigest(output, view);
        Film film = Film.of(animation, frame -> input.read(Optional.of(frame)));
        FrameFiles plan = FrameFiles.of(output, range, frame -> {
            Scene at = film.scene(frame);
            return digests.of(at, settingsOf(at));
        });
        tellKept(plan, range);
        makeFolder();
        FrameRenderer renderer = new FrameRenderer(film, output, view, options, digests, input, terminal);
        String title = scene.name().isEmpty() ? input.name() : scene.name();
        return watching.watch(title, settings, view, true, terminal, w -> renderAll(renderer, plan, files, range, w));
    }

    private void renderAll(FrameRenderer renderer, FrameFiles plan, List<Path> files, FrameRange range, Watch watch)
            throws IOException {
        int faulty = render(renderer, plan, range, watch);
        writeVideo(files, range);
        if (faulty > 0) {
            throw CliException.failed(faulty + (faulty == 1 ? " frame is" : " frames are") + " not as asked");
        }
    }

    /** As many as can be looked at in some seconds. */
    private void checkFrames(Animation animation, FrameRange range) throws IOException {
        for (int frame : FrameChoice.of(animation, input.size()).frames()) {
            if (frame >= range.first() && frame <= range.last()) {
                FrameCheck.check(input, frame);
            }
        }
    }

    /** The settings for a frame, which may have a size of its own. */
    private RenderSettings settingsOf(Scene scene) {
        return FrameRenderer.settings(options, output, scene, input);
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
                    "-o: the folder " + output.pattern().folderName() + " cannot be made: " + FileFailures.describe(e));
        }
    }

    /** @return how many frames are not as asked */
    private int render(FrameRenderer renderer, FrameFiles plan, FrameRange range, Watch watch) throws IOException {
        RenderProgress display = progress.display(terminal.err());
        FilmProgress told = new FilmProgress(watch.over(display), plan.missing().size());
        int done = plan.kept().size();
        int faulty = 0;
        try {
            for (int frame : plan.missing()) {
                watch.frame(frame);
                FrameRenderer.Outcome outcome = renderer.render(frame, told);
                if (outcome == FrameRenderer.Outcome.STOPPED) {
                    throw stopped(done, range, "");
                }
                faulty += outcome == FrameRenderer.Outcome.FAULTY ? 1 : 0;
                told.frameFinished();
                done++;
            }
        } finally {
            ProgressOption.end(display);
        }
        return faulty;
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
