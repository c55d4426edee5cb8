package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.Rendered;
import enlightenment.net.server.Connections;
import enlightenment.render.RenderProgress;
import java.io.IOException;
import java.util.function.BooleanSupplier;

/** The rounds of a server, each with more samples than the one before, until the picture is as exact as was asked. */
final class ServerRounds {
    private static final long PAUSE_MILLIS = 200;

    /** How often a round tries to listen where the one before did. */
    private static final int TRIES = 50;

    private final ServerRound first;
    private ServerRound latest;
    private boolean isStopped;

    ServerRounds(ServerRound first) {
        this.first = first;
        latest = first;
    }

    /** Renders round after round; returns the last picture that became whole, or what there is of the first. */
    Rendered await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        Rendered best = first.await(progress, cancelled);
        ServerRound next = after(first, best, cancelled);
        while (next != null) {
            try {
                Rendered result = next.await(progress, cancelled);
                best = result.complete() ? result : best;
                next = after(next, result, cancelled);
            } catch (IOException e) {
                // There is a picture already.
                first.say(e.getMessage());
                next = null;
            }
        }
        return best;
    }

    /** Ends a round; returns the one that goes on, or null if there is no more to do. */
    private ServerRound after(ServerRound round, Rendered result, BooleanSupplier cancelled) {
        DividedRender more = cancelled.getAsBoolean() || isStopped()
                ? null
                : round.job().render().next(result, round::say).orElse(null);
        if (more == null) {
            round.end(false);
            return null;
        }
        ServerOptions options = round.optionsFor(more);
        round.end(true);
        return begun(round, options, more);
    }

    private ServerRound begun(ServerRound before, ServerOptions options, DividedRender more) {
        for (int k = 1; !isStopped(); k++) {
            try {
                return put(before.follow(more, options));
            } catch (IOException e) {
                // The thread that listened here may need a moment to let go of the port.
                if (k == TRIES || !Connections.sleep(PAUSE_MILLIS)) {
                    before.say("the picture cannot be rendered again with more samples: " + e.getMessage());
                    return null;
                }
            }
        }
        return null;
    }

    private ServerRound put(ServerRound round) {
        synchronized (this) {
            latest = round;
        }
        if (isStopped()) {
            round.end(false);
        }
        return round;
    }

    private synchronized boolean isStopped() {
        return isStopped;
    }

    /** Ends the latest round, and no other will follow. */
    void stop() {
        ServerRound round;
        synchronized (this) {
            isStopped = true;
            round = latest;
        }
        round.end(false);
    }
}
