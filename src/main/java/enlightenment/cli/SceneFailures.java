package enlightenment.cli;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import java.util.ArrayList;
import java.util.List;

/** What is wrong with scenes. */
final class SceneFailures {
    private SceneFailures() {}

    /** Tells every problem, one in a line. */
    static void tell(SceneException e, Terminal terminal) {
        for (SceneException.Problem p : e.problems()) {
            if (p.file().isEmpty()) {
                terminal.say(p.toString());
            } else {
                terminal.note(p.toString());
            }
        }
    }

    /** The same problems, with the file where they did not name one. */
    static SceneException inFile(String file, SceneException e) {
        List<SceneException.Problem> problems = new ArrayList<>();
        for (SceneException.Problem p : e.problems()) {
            problems.add(p.file().isEmpty() ? new SceneException.Problem(file, 0, 0, p.pointer(), p.message()) : p);
        }
        return new SceneException(problems);
    }

    /** A value that was found to be unusable only when the scene in this file was put together. */
    static SceneException inFile(String file, InvalidValueException e) {
        return new SceneException(
                List.of(new SceneException.Problem(file, 0, 0, e.key().isEmpty() ? "" : "/" + e.key(), e.problem())));
    }
}
