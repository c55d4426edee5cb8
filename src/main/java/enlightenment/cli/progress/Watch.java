package enlightenment.cli.progress;

import enlightenment.cli.input.Failures;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.listen.ServerLog;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.status.StatusServer;
import enlightenment.status.WatchedRender;
import enlightenment.text.Plain;
import enlightenment.window.NoDisplayException;
import enlightenment.window.PictureWindow;
import java.io.Closeable;
import java.io.IOException;
import java.net.BindException;
import java.util.List;

/** The display of a render while it runs: a page, a window, or nothing. */
public final class Watch implements Closeable {
    /** Shows nothing. */
    static final Watch NONE = new Watch();

    private static final int LONGEST_TITLE = 200;

    /** How long the end waits for pages that have not received it yet. */
    private static final long FAREWELL_MILLIS = 3_000;

    private final Terminal terminal;
    private final String title;
    private final RenderSettings settings;
    private final WatchedRender render;
    private StatusServer page;
    private PictureWindow window;
    private boolean windowStays;
    private List<Integer> frames = List.of();

    /** The work that is watched. */
    @FunctionalInterface
    public interface Work {
        void run(Watch watch) throws IOException;
    }

    private Watch() {
        terminal = null;
        title = "";
        settings = null;
        render = null;
    }

    Watch(String title, RenderSettings settings, ViewOption view, Terminal terminal) {
        this.terminal = terminal;
        this.title = Plain.line(title, LONGEST_TITLE);
        this.settings = settings;
        render = new WatchedRender(this.title, view::view, System::nanoTime);
        render.statistic("method", settings.method().word());
        render.statistic("width", settings.region().width());
        render.statistic("height", settings.region().height());
        render.statistic("threads", settings.threads());
    }

    /** Shows a page at a port; 0 for any that is free. */
    void serve(int port) {
        try {
            page = StatusServer.start(render, port, new ServerLog(terminal::say, System::nanoTime));
        } catch (IOException e) {
            String why = e instanceof BindException ? "it is in use, or not for everybody: " : "";
            throw CliException.failed("--serve: cannot listen at port " + port + ": " + why + e.getMessage());
        }
        terminal.say("the picture so far: http://127.0.0.1:" + page.port() + "/");
    }

    /** @param stays whether a finished picture stays in view until the window is closed */
    void openWindow(boolean stays) {
        windowStays = stays;
        RenderSettings.Crop region = settings.region();
        try {
            window = PictureWindow.open(render, region.width(), region.height(), terminal.stop()::request);
        } catch (NoDisplayException e) {
            throw CliException.failed("--window: no display; try --serve");
        }
    }

    /** Sets the frames of a film that are rendered, and begins with the first. */
    public void frames(List<Integer> all) {
        frames = all;
        next(0);
    }

    /** A frame is done. */
    public void written(int frame) {
        next(frames.indexOf(frame) + 1);
    }

    private void next(int place) {
        if (render != null && place < frames.size()) {
            render.title(title + ", frame " + frames.get(place));
        }
    }

    /** A listener that passes everything on to the display. */
    public RenderProgress over(RenderProgress display) {
        return render == null ? display : render.listening(display);
    }

    /** There will be no other picture: this is shown as it is in the file. */
    public void rendered(Image shown, RenderResult result) {
        if (render != null) {
            render.rendered(shown, result);
        }
    }

    /** Does the work, and says what goes wrong before it waits for those that look; gives the exit code. */
    int run(Work work) {
        int code = ExitCode.DONE;
        try {
            work.run(this);
        } catch (Throwable t) {
            code = new Failures(terminal).report(t);
        }
        boolean isWhole = code == ExitCode.DONE || render.isWhole();
        render.ended(isWhole);
        if (window != null && windowStays && isWhole && !terminal.stop().getAsBoolean()) {
            terminal.say("done; the command ends when the window is closed");
            window.awaitClosed(terminal.stop());
        }
        if (page != null) {
            page.awaitWatchers(FAREWELL_MILLIS);
        }
        return code;
    }

    @Override
    public void close() throws IOException {
        if (window != null) {
            window.close();
        }
        if (page != null) {
            page.close();
        }
    }
}
