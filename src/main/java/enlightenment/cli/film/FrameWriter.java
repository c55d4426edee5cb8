package enlightenment.cli.film;

import enlightenment.cli.picture.BrightnessHint;
import enlightenment.cli.picture.LightNotes;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.picture.RequestedError;
import enlightenment.cli.picture.ViewOption;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;

/** Writes frames with the files beside them, each as a whole, and says what is to be said of them. */
final class FrameWriter {
    private final FrameOutput output;
    private final ViewOption view;
    private final FrameDigest digests;
    private final FilmReport report;
    private final Terminal terminal;
    private final FilmNotes notes;

    FrameWriter(FrameOutput output, ViewOption view, FrameDigest digests, FilmReport report, Terminal terminal) {
        this.output = output;
        this.view = view;
        this.digests = digests;
        this.report = report;
        this.terminal = terminal;
        notes = new FilmNotes(terminal);
    }

    /** The notes that may concern many frames. */
    FilmNotes notes() {
        return notes;
    }

    /**
     * The data for the texts in a frame's files.
     *
     * @param title the scene's name
     */
    record Subject(int frame, String title, RenderSettings settings, String digest) {}

    /** The data for the texts in the files of a frame. */
    Subject subject(int frame, Scene scene, RenderSettings settings) throws IOException {
        return new Subject(frame, scene.name(), settings, digests.of(scene, settings));
    }

    /**
     * Writes the files of a frame, and gives up its picture.
     *
     * @return false if the picture is not as exact as was asked, or not to be trusted: that has been said
     */
    boolean write(Subject subject, RenderResult result) throws IOException {
        int frame = subject.frame;
        double samples = result.report().sampling().plannedSamples();
        String line = SettingsLine.replayable(subject.settings, samples, frame);
        Image shown = view.view(result.image());
        ImageFiles.PngOptions png = new ImageFiles.PngOptions(output.depth(), PictureText.of(subject.title, line))
                .withText(FrameDigest.KEYWORD, subject.digest);
        output.beside(frame).write(result.auxiliary(), shown, png);
        // The last: where it is there, the others are.
        ImageFiles.write(shown, output.pattern().file(frame), png);
        report.add(frame, result);
        BrightnessHint.tell(result, shown, false, (kind, said) -> notes.say(frame, kind, said));
        LightNotes.tell(result, said -> notes.say(frame, said));
        try {
            LightNotes.require(result, shown);
            RequestedError.require(result);
            return true;
        } catch (CliException e) {
            terminal.say(named(frame) + e.getMessage());
            return false;
        } finally {
            result.image().release();
        }
    }

    /** The prefix of messages about a frame. */
    static String named(int frame) {
        return "frame " + frame + ": ";
    }
}
