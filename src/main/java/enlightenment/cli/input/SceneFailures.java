package enlightenment.cli.input;

import enlightenment.cli.terminal.Terminal;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import java.util.ArrayList;
import java.util.List;

/** Reports of what is wrong with scenes. */
public final class SceneFailures {
    private SceneFailures() {}

    /** Prints every problem in a line of its own. */
    public static void tell(SceneException e, Terminal terminal) {
        for (SceneException.Problem p : e.problems()) {
            if (p.file().isEmpty()) {
                terminal.say(p.toString());
            } else {
                terminal.note(p.toString());
            }
        }
    }

    /** The exception with the input's name and lines for problems that have none. */
    public static SceneException inFile(SceneInput input, SceneException e) {
        List<SceneException.Problem> problems = new ArrayList<>();
        for (SceneException.Problem p : e.problems()) {
            problems.add(
                    p.file().isEmpty() ? new SceneException.Problem(input.name(), 0, 0, p.pointer(), p.message()) : p);
        }
        return input.located(new SceneException(problems));
    }

    /** A value that was found to be unusable only when the scene in this file was put together. */
    public static SceneException inFile(SceneInput input, InvalidValueException e) {
        return inFile(input, SceneException.of(e));
    }
}
