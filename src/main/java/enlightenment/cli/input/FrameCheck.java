package enlightenment.cli.input;

import enlightenment.render.Film;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.util.Optional;

/** Whether frames of an animation can be used, found out without rendering them. */
public final class FrameCheck {
    private final SceneInput input;
    private final Film film;

    /** A check of the frames of a scene file's animation. */
    public FrameCheck(SceneInput input, Animation animation) {
        this.input = input;
        film = Film.of(animation, frame -> input.read(Optional.of(frame)));
    }

    /** Fails with messages that name the frame, if it cannot. */
    public void check(int frame) {
        Scene scene = film.scene(frame);
        try {
            film.check(scene);
        } catch (SceneException e) {
            throw named(input, frame, e);
        }
    }

    /** The problems of a frame, with its file and number. */
    public static SceneException named(SceneInput input, int frame, SceneException e) {
        return SceneFailures.inFile(
                input,
                new SceneException(e.problems().stream()
                        .map(p -> new SceneException.Problem(
                                p.file(), p.line(), p.column(), p.pointer(), p.message() + " (in frame " + frame + ")"))
                        .toList()));
    }
}
