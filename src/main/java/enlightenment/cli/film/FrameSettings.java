package enlightenment.cli.film;

import enlightenment.cli.input.FrameCheck;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.picture.PictureOutput;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;

/** The render settings of a film's frames: each may have a size of its own. */
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
        return PictureOutput.withRounding(options.settings(scene, input), output.depth());
    }

    /**
     * The exception to report where the renderer refused a frame. Problems get the frame's file and number; an option's fault concerns all
     * frames.
     *
     * @param e an {@link InvalidValueException} or a {@link SceneException}
     */
    RuntimeException told(int frame, RuntimeException e) {
        RuntimeException blamed = e instanceof InvalidValueException value ? options.blame(value, input) : e;
        return blamed instanceof SceneException scene ? FrameCheck.named(input, frame, scene) : blamed;
    }
}
