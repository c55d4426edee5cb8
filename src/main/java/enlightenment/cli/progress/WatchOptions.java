package enlightenment.cli.progress;

import enlightenment.cli.option.NumberOrNothing;
import enlightenment.cli.option.WholeNumber;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import picocli.CommandLine.Option;

/** The options that say how a render can be watched. */
public final class WatchOptions {
    @Option(
            names = "--serve",
            arity = "0..1",
            paramLabel = "PORT",
            fallbackValue = "0",
            converter = WholeNumber.Port.class,
            preprocessor = PortOrNothing.class,
            description = "show the picture so far as a web page on this machine; without PORT at any that is free")
    private Integer port;

    @Option(names = "--window", description = "show the picture so far in a window; closing it ends the render")
    private boolean window;

    public WatchOptions() {}

    /** Whether somebody may look at the picture while it is rendered. */
    public boolean isGiven() {
        return port != null || window;
    }

    /** Whether the picture is shown in a window, which takes memory for all of it. */
    public boolean needsWholePicture() {
        return window;
    }

    /**
     * Does what can be watched.
     *
     * @param title what is rendered
     * @param settings how, as far as that is the same for all of it
     * @param view how pictures are shown
     * @param keeps whether a finished picture stays in its window until that is closed
     * @return one of {@link ExitCode}
     */
    public int watch(
            String title, RenderSettings settings, ViewOption view, boolean keeps, Terminal terminal, Watch.Work work)
            throws IOException {
        if (!isGiven()) {
            work.run(Watch.NONE);
            return ExitCode.DONE;
        }
        try (Watch watch = new Watch(title, settings, view, terminal)) {
            if (window) {
                watch.openWindow(keeps);
            }
            if (port != null) {
                watch.serve(port);
            }
            return watch.run(work);
        }
    }

    /** As if {@code --serve=0} had been given. */
    static final class PortOrNothing extends NumberOrNothing {
        PortOrNothing() {
            super("0");
        }
    }
}
