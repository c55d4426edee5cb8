package enlightenment.cli.view;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.listen.ServerLog;
import enlightenment.text.Plain;
import enlightenment.view.LiveView;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment view}: shows a scene in a browser while its camera and its file change. */
@Command(
        name = "view",
        description = "Shows a scene in a browser while its camera and its file change.",
        sortOptions = false)
public final class ViewCommand extends Subcommand {
    private static final int LONGEST_TITLE = 200;
    private static final long POLL_MILLIS = 100;

    @Parameters(paramLabel = "SCENE", description = "the scene file, or a file of another program")
    private Path file;

    @Option(
            names = "--port",
            paramLabel = "N",
            defaultValue = "0",
            converter = WholeNumber.Port.class,
            description = "port of the page on this machine; without it any that is free")
    private int port;

    @Option(names = "--open", description = "open the page in the browser of this machine")
    private boolean open;

    @Option(names = "--save", description = "at the end, write camera and exposure into the scene file")
    private boolean save;

    @Option(
            names = "--samples",
            paramLabel = "N",
            defaultValue = "1024",
            converter = Samples.class,
            description = "samples per pixel after which a picture is finished (${DEFAULT-VALUE})")
    private int samples;

    @Option(
            names = "--threads",
            paramLabel = "N",
            converter = WholeNumber.Threads.class,
            description = "number of threads; without it one for each processor")
    private Integer threads;

    @Mixin
    private FrameOption frame = new FrameOption();

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    public ViewCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        foreign.check();
        if (StandardStreams.isNamed(file)) {
            throw CliException.wrongUsage("view needs a file that it can watch, not standard input");
        }
        ViewedFile source = new ViewedFile(file, foreign, frame, terminal);
        int shared = threads == null ? Runtime.getRuntime().availableProcessors() : threads;
        String title = Plain.line(String.valueOf(file.getFileName()), LONGEST_TITLE);
        ServerLog log = new ServerLog(terminal::say, System::nanoTime);
        try (LiveView view = start(source, new LiveView.Options(title, port, shared, samples), log)) {
            terminal.say("the view: " + view.address() + " (Ctrl-C ends it)");
            if (open && !Browser.open(view.address())) {
                terminal.say("no browser could be started: open that address in one");
            }
            await();
            if (save) {
                save(view);
            }
        }
        return ExitCode.DONE;
    }

    private LiveView start(ViewedFile source, LiveView.Options options, ServerLog log) {
        try {
            return LiveView.start(source, new RenderedFiles(), options, log);
        } catch (IOException e) {
            throw CliException.failed("--port: cannot listen at port " + port + ": " + e.getMessage());
        }
    }

    private void await() {
        try {
            while (!terminal.stop().getAsBoolean()) {
                Thread.sleep(POLL_MILLIS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void save(LiveView view) {
        Optional<String> refusal = view.save();
        if (refusal.isPresent()) {
            throw CliException.failed("--save: " + refusal.get());
        }
    }

    static final class Samples extends WholeNumber {
        private static final int MOST = 1 << 20;

        Samples() {
            super(1, MOST);
        }
    }
}
