package enlightenment.cli;

import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderParts;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderReport;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.LongSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment render}: makes a picture of a scene. */
@Command(name = "render", description = "Makes a picture of a scene.", sortOptions = false)
final class RenderCommand extends Subcommand {
    private static final double LEAST_PREVIEW = 0.01;
    private static final double MOST_PREVIEW = 1e9;

    @Parameters(paramLabel = "SCENE", description = "the scene file; - for standard input")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats; - for standard output")
    private Path output;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            description = "with -o -: png (default) or pfm, to standard output")
    private String format;

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "show what was done")
    private boolean stats;

    @Option(
            names = "--aov",
            paramLabel = "LIST",
            description = "further files beside the picture: error,samples,depth,normal,object or some of them")
    private String aov;

    @Option(
            names = "--dump-clusters",
            paramLabel = "FILE",
            description = "write the ray clusters with their nine distributions to this .json or .csv file")
    private Path clusters;

    @Option(
            names = "--preview",
            paramLabel = "SECONDS",
            description = "write what there is of the picture about this often while it is rendered")
    private String preview;

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress;

    @Option(
            names = "--part",
            paramLabel = "I/N",
            description = "only part I of N, into a .film file; 'merge' makes a picture of all N")
    private String part;

    private final LongSupplier clock;
    private AovFiles companions;
    private SceneInput input;

    RenderCommand(Terminal terminal) {
        this(terminal, System::nanoTime);
    }

    /** @param clock nanoseconds, for previews */
    RenderCommand(Terminal terminal, LongSupplier clock) {
        super(terminal);
        this.clock = clock;
    }

    @Override
    int execute() throws IOException {
        checkOptions();
        input = new SceneInput(sceneFile, terminal);
        Scene scene = input.read(options.frame());
        RenderSettings settings = PictureOptions.forFile(options.settings(scene, input.name()), output, format, depth);
        options.tellOfStretch(scene, settings, terminal);
        if (clusters != null) {
            checkClusters(settings);
        }
        OutputFiles files = new OutputFiles().reads(sceneFile, scene).writes("-o", output);
        companions.register(files.writes("--report", report).writes("--dump-clusters", clusters));
        files.check();
        if (part != null) {
            return renderPart(scene, settings);
        }
        RenderResult result = render(scene, settings);
        if (result.shownPixels() == 0) {
            terminal.say("stopped before anything was rendered; " + Standard.output(output) + " was not written");
            return CliException.FAILED;
        }
        PngOptions options = pngOptions(scene, settings, result.report().sampling());
        PictureOptions.write(result.image(), output, format, options, terminal);
        companions.write(result.auxiliary(), options);
        if (report != null) {
            OutputFile.write(report, ReportJson.of(result));
        }
        if (clusters != null) {
            boolean csv = OutputFile.extension(clusters).equals(".csv");
            OutputFile.write(clusters, csv ? ClusterDump.csv(result.clusters()) : ClusterDump.json(result.clusters()));
            if (result.report().sampling().method() != Method.CLUSTER) {
                terminal.say(clusters + " is empty: so few samples per pixel were evenly spaced and made no clusters");
            }
        }
        if (stats) {
            PictureOptions.printStatistics(result.report(), output, terminal);
        }
        if (!result.complete()) {
            RenderSettings.Crop region = settings.region();
            long percent = 100 * result.report().pixels() / ((long) region.width() * region.height());
            String rest = result.shownPixels() > result.report().pixels() ? ", and a preview of the rest" : "";
            terminal.say("stopped: " + Standard.output(output) + " holds " + percent + " % of the picture" + rest);
            return CliException.FAILED;
        }
        OneColor.tell(scene, settings, result, terminal);
        return PictureOptions.keepsError(result.report(), terminal) ? CliException.DONE : CliException.FAILED;
    }

    private void checkClusters(RenderSettings settings) {
        if (settings.method() != Method.CLUSTER) {
            throw CliException.wrongUsage(
                    "--dump-clusters needs --method " + Method.CLUSTER + "; " + settings.method() + " has none");
        }
        String extension = OutputFile.extension(clusters);
        if (!extension.equals(".json") && !extension.equals(".csv")) {
            throw CliException.wrongUsage(
                    "--dump-clusters must name a file that ends in .json or .csv, not \"" + clusters + "\"");
        }
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
                    samples -> PictureOptions.text(scene, options.replayable(settings, samples)),
                    output,
                    new PlanNote(display, settings.budget(), terminal),
                    terminal.stop());
        } catch (InvalidValueException e) {
            throw options.blame(e, input.name());
        } catch (SceneException e) {
            throw Failures.inFile(input.name(), e);
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
        if (!OutputFile.extension(output).equals(".film")) {
            throw CliException.wrongUsage(
                    "with --part, -o must name a file that ends in .film, not \"" + output + "\"");
        }
        // The depth is that of the picture that is to keep an error.
        boolean isDeep = depth != null && !options.hasError();
        if (isDeep || format != null || report != null || stats || aov != null || preview != null || clusters != null) {
            throw CliException.wrongUsage(
                    "with --part there is no picture yet: --depth (but for --error), --format, --report, --stats, --aov, "
                            + "--preview and "
                            + "--dump-clusters must not be given");
        }
        if (options.hasTime()) {
            throw CliException.wrongUsage(
                    "--time must not be given with --part, whose parts would differ: give --samples");
        }
    }

    private void checkOptions() {
        if (part != null) {
            checkPart();
            PictureOptions.checkDepth(depth);
        } else {
            PictureOptions.check(output, depth, format);
        }
        if (progress != null) {
            OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        }
        if (Standard.is(output) && (aov != null || preview != null)) {
            throw CliException.wrongUsage((aov != null ? "--aov writes files beside" : "--preview replaces")
                    + " the picture: -o must name a file, not standard output");
        }
        companions = new AovFiles(aov, output);
        if (preview != null) {
            OptionValues.number("--preview", preview, LEAST_PREVIEW, MOST_PREVIEW);
            if (Files.exists(output) && !Files.isRegularFile(output) && !Files.isDirectory(output)) {
                throw CliException.wrongUsage("--preview needs a file that can be replaced, unlike \"" + output + "\"");
            }
        }
        options.check();
    }

    private RenderResult render(Scene scene, RenderSettings settings) {
        RenderProgress display = ProgressDisplay.of(progress == null ? "auto" : progress, terminal.err());
        RenderProgress told = new PlanNote(display, settings.budget(), terminal);
        PreviewWriter writer = preview == null ? null : previewWriter(scene, settings, told);
        RenderRequest request = RenderRequest.of(scene, settings)
                .withProgress(writer == null ? told : writer)
                .withCancelled(terminal.stop())
                .withAuxiliary(companions.kinds())
                .withClusters(clusters != null)
                .withProgressive(writer != null);
        try {
            return Renderer.render(request);
        } catch (InvalidValueException e) {
            throw options.blame(e, input.name());
        } catch (SceneException e) {
            throw Failures.inFile(input.name(), e);
        } finally {
            if (writer != null) {
                writer.finish();
            }
            ProgressDisplay.end(display);
        }
    }

    private PreviewWriter previewWriter(Scene scene, RenderSettings settings, RenderProgress display) {
        PngOptions plain = pngOptions(scene, settings, null);
        return new PreviewWriter(
                display,
                Double.parseDouble(preview),
                image -> ImageFiles.write(image, output, plain.withText("Comment", "preview")),
                terminal,
                clock);
    }

    /** What the file says of itself: nothing that differs from run to run. */
    private PngOptions pngOptions(Scene scene, RenderSettings settings, RenderReport.Sampling sampling) {
        String canonical = sampling == null
                ? options.canonical(settings)
                : options.replayable(settings, sampling.plannedSamples());
        return new PngOptions("16".equals(depth) ? 16 : 8, PictureOptions.text(scene, canonical));
    }
}
