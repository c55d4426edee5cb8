package enlightenment.view;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import java.util.List;
import java.util.concurrent.CancellationException;

/** Why something of a view could not be rendered: a scene that cannot be rendered must not end the view, as the next change may mend it. */
final class RefinementProblems {
    private RefinementProblems() {}

    /** What renders something of a view. */
    @FunctionalInterface
    interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Does some work.
     *
     * @param source finds the lines of problems
     * @return why it failed, one problem in a line; empty if it did not, or was cancelled
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
