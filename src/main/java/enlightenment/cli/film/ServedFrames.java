package enlightenment.cli.film;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.net.RenderServer;
import enlightenment.net.ServerOptions;
import enlightenment.render.Film;
import enlightenment.render.RenderProgress;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** Renders the frames of a film with the help of workers. */
final class ServedFrames implements FrameMaker {
    private final Film film;
    private final FrameSettings settings;
    private final FrameWriter writer;
    private final FilmServing serving;
    private final ServerOptions options;
    private final Terminal terminal;
    private final Map<Integer, FrameWriter.Subject> subjects = new HashMap<>();

    private RenderServer.AuditReport audits = RenderServer.AuditReport.NONE;

    /** The frame that is prepared. */
    private int current;

    ServedFrames(
            Film film,
            FrameSettings settings,
            FrameWriter writer,
            FilmServing serving,
            ServerOptions options,
            Terminal terminal) {
        this.film = film;
        this.settings = settings;
        this.writer = writer;
        this.serving = serving;
        this.options = options;
        this.terminal = terminal;
    }

    @Override
    public boolean make(List<Integer> frames, RenderProgress display, Listener listener) throws IOException {
        if (frames.isEmpty()) {
            return true;
        }
        try (RenderServer.OfFilm server = RenderServer.OfFilm.start(frames, this::prepared, options, terminal.stop())) {
            serving.announce(server, terminal);
            boolean areAllThere = server.await(
                    (frame, result) -> listener.written(frame, !writer.write(subjects.get(frame), result)),
                    display,
                    terminal.stop());
            audits = server.audits();
            return areAllThere;
        } catch (CancellationException e) {
            return false;
        } catch (InvalidValueException | SceneException e) {
            throw settings.told(current, e);
        } catch (IllegalArgumentException e) {
            throw CliException.wrongUsage(e.getMessage());
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    @Override
    public Optional<RenderServer.AuditReport> audits() {
        return Optional.of(audits);
    }

    private RenderServer.OfFilm.Frame prepared(int frame) {
        current = frame;
        Scene scene = film.scene(frame);
        RenderSettings chosen = settings.of(scene);
        try {
            subjects.put(frame, writer.subject(frame, scene, chosen));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new RenderServer.OfFilm.Frame(scene, chosen);
    }
}
