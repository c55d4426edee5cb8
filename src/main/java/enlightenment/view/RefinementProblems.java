package enlightenment.view;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import java.util.List;
import java.util.concurrent.CancellationException;

/** Converts failures of a render into problems in words. They must not end the view, as the next change may mend the scene. */
final class RefinementProblems {
    private RefinementProblems() {}

    /** A render that may fail. */
    @FunctionalInterface
    interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Runs a render and returns its problems.
     *
     * @param source finds the lines of problems
     * @return the problems, one in a line; empty if the render succeeded or was cancelled
     */
    static List<String> of(Work work, SceneSource source) throws InterruptedException {
        try {
            work.run();
            return List.of();
        } catch (CancellationException e) {
            return List.of();
        } catch (SceneException e) {
            return ViewSession.lines(source.located(e));
        } catch (InvalidValueException e) {
            return List.of(e.getMessage());
        } catch (OutOfMemoryError e) {
            return List.of("out of memory: a smaller window, or java -Xmx, may help");
        } catch (RuntimeException e) {
            return List.of("internal error: " + e);
        }
    }
}
