package enlightenment.cli;

import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.net.RenderParts;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment render}: makes a picture of a scene. */
@Command(name = "render", description = "Makes a picture of a scene.", sortOptions = false)
final class RenderCommand extends Subcommand {
    @Parameters(paramLabel = "SCENE", description = "the scene file")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats")
    private Path output;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "show what was done")
    private boolean stats;

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress;

    @Option(
            names = "--part",
            paramLabel = "I/N",
            description = "only part I of N, into a .film file; 'merge' makes a picture of all N")
    private String part;

    RenderCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        checkOptions();
        Scene scene = read();
        RenderSettings settings = options.settings(scene, sceneFile.toString());
        Target.check(output);
        if (part != null) {
            return renderPart(scene, settings);
        }
        if (report != null) {
            Target.check(report);
        }
        RenderResult result = render(scene, settings);
        if (result.report().pixels() == 0) {
            terminal.say("stopped before anything was rendered; " + output + " was not written");
            return CliException.FAILED;
        }
        ImageFiles.write(result.image(), output, pngOptions(scene, settings));
        if (report != null) {
            Target.write(report, ReportJson.of(result));
        }
        if (stats) {
            terminal.out().print(StatsTable.of(result.report()));
        }
        if (!result.complete()) {
            RenderSettings.Crop region = settings.region();
            long percent = 100 * result.report().pixels() / ((long) region.width() * region.height());
            terminal.say("stopped: " + output + " holds " + percent + " % of the picture");
            return CliException.FAILED;
        }
        return CliException.DONE;
    }

    private int renderPart(Scene scene, RenderSettings settings) throws IOException {
        int[] p = OptionValues.part("--part", part);
        RenderProgress display = ProgressDisplay.of(progress == null ? "auto" : progress, terminal.err());
        boolean complete;
        try {
            complete = RenderParts.render(
                    scene,
                    settings,
                    p[0],
                    p[1],
                    PictureOptions.text(scene, options.canonical(settings)),
                    output,
                    display,
                    terminal.stop());
        } catch (InvalidValueException e) {
            throw options.blame(e, sceneFile.toString());
        } catch (SceneException e) {
            throw Failures.inFile(sceneFile.toString(), e);
        } finally {
            ProgressDisplay.end(display);
        }
        if (!complete) {
            terminal.say("stopped: " + output + " holds only some of part " + part);
            return CliException.FAILED;
        }
        return CliException.DONE;
    }

    private void checkPart() {
        OptionValues.part("--part", part);
        if (!Target.extension(output).equals(".film")) {
            throw CliException.wrongUsage(
                    "with --part, -o must name a file that ends in .film, not \"" + output + "\"");
        }
        if (depth != null || report != null || stats) {
            throw CliException.wrongUsage("--depth, --report and --stats belong to 'merge', not to a --part");
        }
        if (options.hasTime()) {
            throw CliException.wrongUsage(
                    "--time must not be given with --part, whose parts would differ: give --samples");
        }
    }

    private void checkOptions() throws IOException {
        if (part != null) {
            checkPart();
        } else {
            PictureOptions.check(output, depth);
        }
        if (progress != null) {
            OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        }
        if (report != null && (Target.same(report, output) || Target.same(report, sceneFile))) {
            throw CliException.wrongUsage("--report must name a file of its own, not \"" + report + "\"");
        }
        if (Target.same(output, sceneFile)) {
            throw CliException.wrongUsage("-o must not name the scene itself, \"" + output + "\"");
        }
        options.check();
    }

    private Scene read() {
        return options.frame().isPresent()
                ? SceneReader.read(sceneFile, options.frame().get())
                : SceneReader.read(sceneFile);
    }

    private RenderResult render(Scene scene, RenderSettings settings) {
        RenderProgress display = ProgressDisplay.of(progress == null ? "auto" : progress, terminal.err());
        try {
            return Renderer.render(scene, settings, display, terminal.stop());
        } catch (InvalidValueException e) {
            throw options.blame(e, sceneFile.toString());
        } catch (SceneException e) {
            throw Failures.inFile(sceneFile.toString(), e);
        } finally {
            ProgressDisplay.end(display);
        }
    }

    /** What the file says of itself: nothing that differs from run to run. */
    private PngOptions pngOptions(Scene scene, RenderSettings settings) {
        return new PngOptions("16".equals(depth) ? 16 : 8, PictureOptions.text(scene, options.canonical(settings)));
    }
}
