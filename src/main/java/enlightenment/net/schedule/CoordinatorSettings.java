package enlightenment.net.schedule;

import enlightenment.net.protocol.Limits;

/**
 * The settings of a coordinator.
 *
 * @param tiles number of tile columns of the job, numbered from 0
 * @param offered tiles from this one on are not given to anybody before an {@link Event.Offered} allows it
 * @param seed a number that no other incarnation of the server has: lease numbers are drawn from it, so that a worker's
 *     old lease is never taken for a new one
 * @param leaseNanos how long a worker should need for a lease
 * @param silenceNanos a worker that sends nothing, or a lease that its holder does not name, for this long is lost
 * @param stallNanos a worker that lives but delivers nothing for this long (or for eight times the longest that any tile took, whichever is
 *     longer) is not waited for
 * @param auditRate share of tiles, 0..1, that are rendered again by another worker
 * @param auditSalt decides which tiles these are; unknown to workers, which could lie about all others
 */
public record CoordinatorSettings(
        int tiles,
        int offered,
        long seed,
        long leaseNanos,
        long silenceNanos,
        long stallNanos,
        double auditRate,
        long auditSalt) {
    static final long SECOND = 1_000_000_000L;

    /** One in 500: what it costs leaves room in the 99.6 % of the paper's eight machines. */
    public static final double AUDIT_RATE = 0.002;

    public CoordinatorSettings {
        require(tiles >= 1 && tiles <= Limits.TILES, "a job has 1.." + Limits.TILES + " tiles, not " + tiles);
        require(offered >= 1 && offered <= tiles, "1.." + tiles + " tiles are offered, not " + offered);
        require(leaseNanos > 0 && silenceNanos > 0 && stallNanos > 0, "durations must be greater than 0");
        require(auditRate >= 0 && auditRate <= 1, "the audit rate must lie in 0..1, not " + auditRate);
    }

    /** The usual settings: leases of 4 s, silence of 5 s, stall of 60 s, 0.2 % of tiles audited. */
    public static CoordinatorSettings of(int tiles, long seed, long auditSalt) {
        return new CoordinatorSettings(tiles, tiles, seed, 4 * SECOND, 5 * SECOND, 60 * SECOND, AUDIT_RATE, auditSalt);
    }

    public CoordinatorSettings withAuditRate(double rate) {
        return new CoordinatorSettings(tiles, offered, seed, leaseNanos, silenceNanos, stallNanos, rate, auditSalt);
    }

    /** These settings, with only the tiles before {@code end} offered at first. */
    public CoordinatorSettings withOffered(int end) {
        return new CoordinatorSettings(tiles, end, seed, leaseNanos, silenceNanos, stallNanos, auditRate, auditSalt);
    }

    public CoordinatorSettings withSilence(long nanos) {
        return new CoordinatorSettings(tiles, offered, seed, leaseNanos, nanos, stallNanos, auditRate, auditSalt);
    }

    private static void require(boolean condition, String message) {
        if (!condition) {
            throw new IllegalArgumentException(message);
        }
    }
}
