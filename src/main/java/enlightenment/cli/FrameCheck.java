package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.render.Renderer;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.util.Optional;

/** Whether frames of an animation can be used, found out without rendering them. */
final class FrameCheck {
    private FrameCheck() {}

    /** Fails with messages that name the frame, if it cannot. */
    static void check(SceneInput input, int frame) {
        Scene scene = input.read(Optional.of(frame));
        try {
            Renderer.checkShapes(scene);
        } catch (InvalidValueException e) {
            throw named(input, frame, e);
        } catch (SceneException e) {
            throw named(input, frame, e);
        }
    }

    /** A value of a frame that cannot be used, with its file and frame. */
    static SceneException named(SceneInput input, int frame, InvalidValueException e) {
        return SceneFailures.inFile(input.name(), new InvalidValueException(e.key(), e.problem() + inFrame(frame)));
    }

    /** The problems of a frame, with its file and number. */
    static SceneException named(SceneInput input, int frame, SceneException e) {
        return new SceneException(e.problems().stream()
                .map(p -> new SceneException.Problem(
                        p.file().isEmpty() ? input.name() : p.file(),
                        p.line(),
                        p.column(),
                        p.pointer(),
                        p.message() + inFrame(frame)))
                .toList());
    }

    private static String inFrame(int frame) {
        return " (in frame " + frame + ")";
    }
}
