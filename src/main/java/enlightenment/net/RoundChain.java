package enlightenment.net;

import enlightenment.net.server.Connections;
import enlightenment.net.server.ServerJob;
import java.io.IOException;
import java.util.function.Supplier;

/** Jobs that follow each other at the same ports: workers come again by themselves. */
final class RoundChain {
    private static final long PAUSE_MILLIS = 200;

    /** How often a round tries to listen at the port of the one before. */
    private static final int TRIES = 50;

    private ServerRound latest;
    private boolean isStopped;

    RoundChain(ServerRound first) {
        latest = first;
    }

    synchronized ServerRound latest() {
        return latest;
    }

    synchronized boolean isStopped() {
        return isStopped;
    }

    /**
     * Ends the latest round and begins the next one.
     *
     * @param job makes the next round's job, afresh for each attempt
     * @return null if the port cannot be had, or the chain was stopped
     */
    ServerRound follow(Supplier<ServerJob> job) {
        ServerRound before = latest();
        ServerOptions options = before.optionsOfNext();
        before.end(true);
        for (int k = 1; !isStopped(); k++) {
            try {
                return put(before.follow(job.get(), options));
            } catch (IOException e) {
                // The thread that listened here may need a moment to let go of the port.
                if (k == TRIES || !Connections.sleep(PAUSE_MILLIS)) {
                    before.say("what is to be rendered again with more samples cannot be: " + e.getMessage());
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
