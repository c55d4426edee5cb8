package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.file.ContentHash;
import enlightenment.net.job.TileData;
import java.util.Set;

/** The input of a {@link Coordinator}. {@code worker} is the number that the server gave to a connection, used once. */
public sealed interface Event {
    /**
     * A worker is authenticated, has the job, and wants work.
     *
     * @param process hash of a secret of the worker process, the same over all its connections; null for the server's own threads
     * @param origin whose word its results are: a machine may be doubted and expelled
     * @param isUnproven whether its arithmetic is unproven, as it left out the canary: then its vote alone is enough for no tile
     * @param weight its speed relative to others, from the paper's speed map; 1 if nothing is known
     */
    record Joined(
            long worker,
            ContentHash process,
            Origin origin,
            boolean isUnproven,
            String name,
            int threads,
            double weight)
            implements Event {
        public Joined {
            if (!(weight > 0 && weight < Double.POSITIVE_INFINITY) || threads < 1) {
                throw new IllegalArgumentException("weight and threads must be greater than 0");
            }
        }
    }

    /** The connection is gone. */
    record Left(long worker, String reason) implements Event {}

    /** A heartbeat. */
    record Heard(long worker, Set<Long> leases) implements Event {}

    /** A tile of the right job, with the right size and without NaN, arrived whole. */
    record Delivered(long worker, long lease, int tile, TileData data) implements Event {}

    /** The worker sent what no honest worker sends. */
    record Misbehaved(long worker, String reason) implements Event {}

    /** The tiles before {@code end} may be given to workers from now on. */
    record Offered(int end) implements Event {}

    /**
     * The results of the tiles {@code first} (included) to {@code last} (excluded) are lost. Votes on them do not count: those that were
     * done must be done again.
     */
    record Forgotten(int first, int last) implements Event {}

    /** Time has passed; to be sent at least every half second. */
    record Tick() implements Event {}
}
