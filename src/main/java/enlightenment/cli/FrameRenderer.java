package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.math.InvalidValueException;
import enlightenment.render.Film;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;

/** Renders frames of a film and writes them, each as soon as it is whole. */
final class FrameRenderer {
    private final Film film;
    private final FrameOutput output;
    private final ViewOption view;
    private final RenderOptions options;
    private final FrameDigest digests;
    private final SceneInput input;
    private final Terminal terminal;

    /** What became of a frame. */
    enum Outcome {
        WRITTEN,
        /** Written, but not as exact as was asked, or not to be trusted: that has been said. */
        FAULTY,
        /** Not written: the user wanted an end. */
        STOPPED
    }

    FrameRenderer(
            Film film,
            FrameOutput output,
            ViewOption view,
            RenderOptions options,
            FrameDigest digests,
            SceneInput input,
            Terminal terminal) {
        this.film = film;
        this.output = output;
        this.view = view;
        this.options = options;
        this.digests = digests;
        this.input = input;
        this.terminal = terminal;
    }

    /** The settings for a frame. */
    static RenderSettings settings(RenderOptions options, FrameOutput output, Scene scene, SceneInput input) {
        return PictureOutput.withRounding(options.settings(scene, input.name()), output.depth());
    }

    Outcome render(int frame, RenderProgress progress) throws IOException {
        Scene scene = film.scene(frame);
        RenderSettings settings = settings(options, output, scene, input);
        RenderResult result = render(frame, scene, settings, progress);
        if (!result.complete()) {
            return Outcome.STOPPED;
        }
        double samples = result.report().sampling().plannedSamples();
        Image shown = view.view(result.image());
        PngOptions png = new PngOptions(
                        output.depth(), PictureText.of(scene, SettingsLine.replayable(settings, samples, frame)))
                .withText(FrameDigest.KEYWORD, digests.of(scene, settings));
        ImageFiles.write(shown, output.pattern().file(frame), png);
        LightNotes.tell(result, shown, said -> terminal.say(named(frame) + said));
        try {
            LightNotes.require(result);
            RequestedError.require(result);
            return Outcome.WRITTEN;
        } catch (CliException e) {
            terminal.say(named(frame) + e.getMessage());
            return Outcome.FAULTY;
        }
    }

    private static String named(int frame) {
        return "frame " + frame + ": ";
    }

    private RenderResult render(int frame, Scene scene, RenderSettings settings, RenderProgress progress) {
        try {
            return film.render(RenderRequest.of(scene, settings)
                    .withProgress(new BudgetNotes(progress, settings.budget(), terminal, named(frame)))
                    .withCancelled(terminal.stop()));
        } catch (InvalidValueException e) {
            throw blamed(frame, options.blame(e, input.name()));
        } catch (SceneException e) {
            throw FrameCheck.named(input, frame, e);
        }
    }

    /** An option's fault is one of all frames. */
    private RuntimeException blamed(int frame, RuntimeException e) {
        return e instanceof SceneException s ? FrameCheck.named(input, frame, s) : e;
    }
}
