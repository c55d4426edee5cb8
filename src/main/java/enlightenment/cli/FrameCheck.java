package enlightenment.cli;

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
        } catch (SceneException e) {
            throw named(input, frame, e);
        }
    }

    /** The problems of a frame, with its file and number. */
    static SceneException named(SceneInput input, int frame, SceneException e) {
        return SceneFailures.inFile(
                input,
                new SceneException(e.problems().stream()
                        .map(p -> new SceneException.Problem(
                                p.file(), p.line(), p.column(), p.pointer(), p.message() + " (in frame " + frame + ")"))
                        .toList()));
    }
}
