package enlightenment.cli.input;

import enlightenment.cli.option.WholeNumber;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The option that chooses one frame of an animation. */
public final class FrameOption {
    @Option(
            names = "--frame",
            paramLabel = "N",
            converter = Number.class,
            description = "frame of an animation, counted from 0")
    private Integer frame;

    public FrameOption() {}

    /** The frame that was asked for, or null. */
    public Integer number() {
        return frame;
    }

    /** The scene at the frame that was asked for. */
    public Scene read(SceneInput input) {
        return input.read(Optional.ofNullable(frame));
    }

    /** The option as it was given, word by word. */
    public List<String> given() {
        return frame == null ? List.of() : List.of("--frame", frame.toString());
    }

    static final class Number extends WholeNumber {
        Number() {
            super(0, Integer.MAX_VALUE);
        }
    }
}
