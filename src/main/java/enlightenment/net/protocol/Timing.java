package enlightenment.net.protocol;

/**
 * The deadlines of server and workers for each other. Every wait has one.
 *
 * @param authenticationMillis from the connection to the proof. (5 s refused honest workers on a loaded machine.)
 * @param frameMillis from a frame's first byte to its last; single bytes do not prolong it
 * @param writeMillis for a frame to be received
 * @param idleMillis without a whole frame, as long as no heartbeats are due
 * @param heartbeatMillis between a worker's heartbeats
 * @param silenceMillis without a message until the other side is believed lost
 */
public record Timing(
        int authenticationMillis,
        int frameMillis,
        int writeMillis,
        int idleMillis,
        int heartbeatMillis,
        int silenceMillis) {
    public static final Timing DEFAULT = new Timing(15_000, 10_000, 10_000, 60_000, 1_000, 5_000);
}
