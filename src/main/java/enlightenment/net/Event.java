package enlightenment.net;

import java.util.Set;

/** What a {@link Coordinator} is told. {@code worker} is the number that the server gave to a connection, used once. */
sealed interface Event {
    /**
     * A worker is authenticated, has the job, and wants work.
     *
     * @param key identity of the worker process: the same over all its connections
     * @param machine identity of the machine, whose word the results are: it may be doubted and expelled;
     *     {@link Coordinator#LOCAL} for the server's own threads
     * @param weight its speed relative to others, from the paper's speed map; 1 if nothing is known
     */
    record Joined(long worker, String key, String machine, String name, int threads, double weight) implements Event {
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

    /** Time has passed; wanted at least every half second. */
    record Tick() implements Event {}
}
