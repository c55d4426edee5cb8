package enlightenment.cli.scene;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameCheck;
import enlightenment.cli.input.FrameChoice;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.render.Renderer;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code enlightenment validate}: finds all problems of scenes without rendering them. */
@Command(name = "validate", description = "Finds all problems of scenes, in all their frames, without rendering them.")
public final class ValidateCommand extends Subcommand {
    @Parameters(arity = "1..*", paramLabel = "SCENE", description = "the scene files; - for standard input")
    private List<Path> sceneFiles;

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    public ValidateCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        foreign.check();
        int code = ExitCode.DONE;
        for (Path file : sceneFiles) {
            SceneInput input = new SceneInput(file, foreign, terminal);
            try {
                Scene scene = read(input);
                Optional<Animation> animation = scene.animation();
                boolean valid = animation.isEmpty() || validateFrames(input, scene, animation.get());
                code = valid ? code : ExitCode.WRONG_INPUT;
                if (animation.isEmpty()) {
                    terminal.show(input.name() + ": valid");
                }
            } catch (SceneException e) {
                SceneFailures.tell(e, terminal);
                code = ExitCode.WRONG_INPUT;
            }
        }
        return code;
    }

    /** Reads the scene and checks what its text does not show. */
    private static Scene read(SceneInput input) {
        Scene scene = input.read(Optional.empty());
        try {
            Renderer.check(scene, RenderSettings.of(scene));
            return scene;
        } catch (InvalidValueException e) {
            throw SceneFailures.inFile(input, e);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
    }

    /** Prints the problems of frames: each once, for the first frame that has it. */
    private boolean validateFrames(SceneInput input, Scene scene, Animation animation) throws IOException {
        FrameChoice choice = FrameChoice.of(animation, input.size());
        Set<String> places = new HashSet<>();
        List<Integer> bad = new ArrayList<>();
        FrameCheck check = new FrameCheck(input, animation);
        for (int frame : choice.frames()) {
            try {
                check.check(frame);
            } catch (SceneException e) {
                bad.add(frame);
                List<SceneException.Problem> fresh = e.problems().stream()
                        .filter(p -> places.add(p.pointer()))
                        .toList();
                if (!fresh.isEmpty()) {
                    SceneFailures.tell(new SceneException(fresh), terminal);
                }
            }
        }
        if (bad.isEmpty()) {
            terminal.show(input.name() + ": valid in " + choice.inWords());
        } else {
            terminal.note(input.name() + ": " + bad.size() + " of " + choice.inWords() + " cannot be used: "
                    + FrameChoice.ranges(bad));
        }
        return bad.isEmpty();
    }
}
