package enlightenment.cli.film;

import enlightenment.cli.progress.WatchOptions;
import enlightenment.cli.setting.BudgetNotes;
import enlightenment.cli.setting.DeviceOption;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.render.Film;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;

/** Renders the frames of a film in this process, one after the other. */
final class FrameRenderer implements FrameMaker {
    private final Film film;
    private final FrameSettings settings;
    private final FrameOutput output;
    private final DeviceOption device;
    private final FrameWriter writer;
    private final WatchOptions watching;
    private final Terminal terminal;

    FrameRenderer(
            Film film,
            FrameSettings settings,
            FrameOutput output,
            DeviceOption device,
            FrameWriter writer,
            WatchOptions watching,
            Terminal terminal) {
        this.film = film;
        this.settings = settings;
        this.output = output;
        this.device = device;
        this.writer = writer;
        this.watching = watching;
        this.terminal = terminal;
    }

    @Override
    public boolean make(List<Integer> frames, RenderProgress display, Listener listener) throws IOException {
        FilmProgress told = new FilmProgress(display, frames.size());
        for (int frame : frames) {
            Scene scene = film.scene(frame);
            RenderSettings chosen = settings.of(scene);
            RenderResult result;
            try {
                result = render(frame, scene, chosen, told);
            } catch (CancellationException e) {
                return false;
            }
            if (!result.complete()) {
                return false;
            }
            listener.written(frame, !writer.write(writer.subject(frame, scene, chosen), result));
            told.frameFinished();
        }
        return true;
    }

    private RenderResult render(int frame, Scene scene, RenderSettings chosen, RenderProgress progress) {
        try {
            RenderRequest request = device.addTo(RenderRequest.of(scene, chosen))
                    .withProgress(new BudgetNotes(
                            progress, chosen.budget(), terminal, FrameWriter.named(frame), said -> writer.notes()
                                    .say(frame, said)))
                    .withAuxiliary(output.aov().kinds())
                    .withWatched(watching.isGiven())
                    .withCancelled(terminal.stop());
            return film.render(watching.needsWholePicture() ? request : request.withScratch(output.scratch()));
        } catch (InvalidValueException | SceneException e) {
            throw settings.told(frame, e);
        }
    }
}
