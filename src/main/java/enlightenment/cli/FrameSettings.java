package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;

/** How the frames of a film are rendered: each may have a size of its own. */
final class FrameSettings {
    private final RenderOptions options;
    private final FrameOutput output;
    private final SceneInput input;

    FrameSettings(RenderOptions options, FrameOutput output, SceneInput input) {
        this.options = options;
        this.output = output;
        this.input = input;
    }

    /** The settings for a frame. */
    RenderSettings of(Scene scene) {
        return PictureOutput.withRounding(options.settings(scene, input.name()), output.depth());
    }

    /** What to tell of a value of a frame that the renderer refused. An option's fault is one of all frames. */
    RuntimeException blame(int frame, InvalidValueException e) {
        RuntimeException blamed = options.blame(e, input.name());
        return blamed instanceof SceneException s ? named(frame, s) : blamed;
    }

    /** The problems of a frame, with its file and number. */
    SceneException named(int frame, SceneException e) {
        return FrameCheck.named(input, frame, e);
    }
}
