package enlightenment.cli;

import enlightenment.cli.input.Failures;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneArgument;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.PictureOutput;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.picture.ReportOutput;
import enlightenment.cli.picture.RequestedError;
import enlightenment.cli.picture.StoppedRender;
import enlightenment.cli.progress.ProgressOption;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.net.EngineJob;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.spark.SparkRender;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The driver for {@code spark-submit}: makes a picture of a scene on a Spark cluster. */
@Command(
        name = "spark-submit ... enlightenment-spark.jar",
        description = "Makes a picture of a scene on a Spark cluster.",
        sortOptions = false)
public final class SparkCommand extends Subcommand {
    @Mixin
    private SceneArgument argument = new SceneArgument();

    @Mixin
    private PictureOutput output = new PictureOutput();

    @Option(names = "--checkpoint", paramLabel = "FILE", description = "keep what is done here, and go on from it")
    private Path checkpoint;

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Mixin
    private FrameOption frame = new FrameOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    @Mixin
    private ProgressOption progress = new ProgressOption();

    private SceneInput input;

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
            return Commands.configure(new CommandLine(new SparkCommand(terminal)), terminal)
                    .execute(args);
        } catch (Throwable t) {
            // Errors such as a lack of memory, which picocli lets pass.
            return new Failures(terminal).report(t);
        }
    }

    @Override
    protected int execute() throws IOException {
        check();
        input = argument.open(terminal);
        Scene scene = frame.read(input);
        RenderSettings settings = PictureOutput.withRounding(options.settings(scene, input), output.writtenDepth());
        CommandFiles files = new CommandFiles().reads(argument.file(), scene).writes("--checkpoint", checkpoint);
        files.writes("-o", output.file());
        report.register(files);
        files.check();
        RenderResult result;
        try (EngineJob job = EngineJob.start(scene, settings, checkpoint, terminal::say, terminal.stop())) {
            result = render(job);
        } catch (CancellationException e) {
            throw nothingRendered();
        } catch (InvalidValueException e) {
            throw options.blame(e, input);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
        finish(result, scene, settings);
        return ExitCode.DONE;
    }

    private void check() {
        output.check();
        if (checkpoint != null && options.hasTime()) {
            throw CliException.wrongUsage(
                    "--checkpoint must not be given with --time, which is planned anew each time: give --samples");
        }
    }

    private RenderResult render(EngineJob job) throws IOException {
        RenderProgress display = progress.display(terminal.err());
        JavaSparkContext spark = new JavaSparkContext(SparkRender.configure(new SparkConf()));
        try {
            return SparkRender.render(spark, job, display, terminal.stop(), terminal::say);
        } finally {
            ProgressOption.end(display);
            spark.stop();
        }
    }

    private CliException nothingRendered() {
        return CliException.failed("stopped before anything was rendered; " + output.name() + " was not written");
    }

    private void finish(RenderResult result, Scene scene, RenderSettings settings) throws IOException {
        if (result.report().pixels() == 0) {
            throw nothingRendered();
        }
        double samples = result.report().sampling().plannedSamples();
        String line = SettingsLine.replayable(settings, samples, frame.number());
        output.write(result.image(), PictureText.of(scene, line), settings, terminal);
        report.write(result, output, terminal);
        if (!result.complete()) {
            throw StoppedRender.after(result, output, "");
        }
        RequestedError.require(result);
    }
}
