package enlightenment.cli.film;

import enlightenment.net.RenderServer;
import enlightenment.render.RenderProgress;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Renders frames of a film and writes them. */
interface FrameMaker {
    /** Receives a call for each frame written. */
    @FunctionalInterface
    interface Listener {
        /**
         * A frame is written; it may come again, and then counts as it is then.
         *
         * @param isFaulty whether it is not as exact as was asked, or not to be trusted
         */
        void written(int frame, boolean isFaulty);
    }

    /**
     * Renders and writes frames.
     *
     * @return whether all are written: false if the user cancelled
     */
    boolean make(List<Integer> frames, RenderProgress display, Listener listener) throws IOException;

    /** The audits of the frames that were made with workers; empty without. */
    default Optional<RenderServer.AuditReport> audits() {
        return Optional.empty();
    }
}
