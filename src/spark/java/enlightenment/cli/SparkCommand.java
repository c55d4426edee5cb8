package enlightenment.cli;

import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.math.InvalidValueException;
import enlightenment.net.EngineJob;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import enlightenment.spark.SparkRender;
import java.io.IOException;
import java.nio.file.Path;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The driver for {@code spark-submit}: makes a picture of a scene on a Spark cluster. */
@Command(
        name = "spark-submit ... enlightenment-spark.jar",
        description = "Makes a picture of a scene on a Spark cluster.",
        sortOptions = false)
public final class SparkCommand extends Subcommand {
    @Parameters(paramLabel = "SCENE", description = "the scene file")
    private Path sceneFile;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats")
    private Path output;

    @Option(names = "--checkpoint", paramLabel = "FILE", description = "keep what is done here, and go on from it")
    private Path checkpoint;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--progress", paramLabel = "KIND", description = "auto (default), bar, plain or none")
    private String progress;

    SparkCommand(Terminal terminal) {
        super(terminal);
    }

    /** Called by spark-submit; ends the process: 0 done, 1 failed, 2 wrong usage or a scene that cannot be used. */
    public static void main(String[] args) {
        ShutdownSignal stop = new ShutdownSignal();
        stop.listen();
        int code;
        try {
            code = run(args, new Terminal(System.out, System.err, stop));
        } finally {
            stop.finished();
        }
        System.exit(code);
    }

    private static int run(String[] args, Terminal terminal) {
        try {
            SparkCommand command = new SparkCommand(terminal);
            CommandLine line = Commands.configure(new CommandLine(command), terminal);
            line.parseArgs(args);
            if (command.wantsHelp()) {
                line.usage(terminal.out());
                return CliException.DONE;
            }
            return command.execute();
        } catch (Throwable t) {
            return new Failures(terminal).report(t);
        }
    }

    @Override
    int execute() throws IOException {
        check();
        Scene scene = options.frame().isPresent()
                ? SceneReader.read(sceneFile, options.frame().get())
                : SceneReader.read(sceneFile);
        RenderSettings settings =
                PictureOptions.forFile(options.settings(scene, sceneFile.toString()), output, null, depth);
        new OutputFiles()
                .reads(sceneFile, scene)
                .writes("--checkpoint", checkpoint)
                .writes("-o", output)
                .writes("--report", report)
                .check();
        RenderResult result;
        try (EngineJob job = EngineJob.start(scene, settings, checkpoint, terminal::say, terminal.stop())) {
            result = render(job);
        } catch (InvalidValueException e) {
            throw options.blame(e, sceneFile.toString());
        } catch (SceneException e) {
            throw Failures.inFile(sceneFile.toString(), e);
        }
        return finish(result, scene, settings);
    }

    private void check() {
        PictureOptions.check(output, depth, null);
        if (progress != null) {
            OptionValues.word("--progress", progress, ProgressDisplay.KINDS);
        }
        options.check();
        if (checkpoint != null && options.hasTime()) {
            throw CliException.wrongUsage(
                    "--checkpoint must not be given with --time, which is planned anew each time: give --samples");
        }
    }

    private RenderResult render(EngineJob job) throws IOException {
        RenderProgress display = ProgressDisplay.of(progress == null ? "auto" : progress, terminal.err());
        JavaSparkContext spark = new JavaSparkContext(SparkRender.configure(new SparkConf()));
        try {
            return SparkRender.render(spark, job, display, terminal.stop(), terminal::say);
        } finally {
            ProgressDisplay.end(display);
            spark.stop();
        }
    }

    private int finish(RenderResult result, Scene scene, RenderSettings settings) throws IOException {
        if (result.report().pixels() == 0) {
            terminal.say("stopped before anything was rendered; " + output + " was not written");
            return CliException.FAILED;
        }
        String text = options.replayable(settings, result.report().sampling().plannedSamples());
        PngOptions png = new PngOptions("16".equals(depth) ? 16 : 8, PictureOptions.text(scene, text));
        ImageFiles.write(result.image(), output, png);
        if (report != null) {
            OutputFile.write(report, ReportJson.of(result));
        }
        if (!result.complete()) {
            terminal.say("stopped: " + output + " is not complete");
            return CliException.FAILED;
        }
        return PictureOptions.keepsError(result.report(), terminal) ? CliException.DONE : CliException.FAILED;
    }
}
