package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.file.ContentHash;
import enlightenment.net.secure.Handshake;
import java.nio.charset.StandardCharsets;

/** Processes and machines by names, for tests. */
public final class Peers {
    private Peers() {}

    public static byte[] secret(String name) {
        return ContentHash.of(name.getBytes(StandardCharsets.UTF_8)).toBytes();
    }

    public static Origin.Peer machine(String name) {
        return Origin.Peer.of(secret(name));
    }

    /** The machine as real workers of a job say it. */
    public static Origin.Peer machine(String name, ContentHash job) {
        return Origin.Peer.of(Handshake.hmac(secret(name), job.toBytes()));
    }

    /** Settings of a job of which one tile only is audited. */
    static CoordinatorSettings auditing(int tile, int tiles) {
        double rate = 0.5;
        long salt = 0;
        while (!isOnlyChoice(rate, salt, tile, tiles)) {
            salt++;
        }
        return CoordinatorSettings.of(tiles, 99, salt).withAuditRate(rate);
    }

    private static boolean isOnlyChoice(double rate, long salt, int tile, int tiles) {
        for (int other = 0; other < tiles; other++) {
            if (Audits.isChosen(rate, salt, other) != (other == tile)) {
                return false;
            }
        }
        return true;
    }

    public static Event.Joined joined(long worker, String process, String machine, int threads, double weight) {
        ContentHash key = ContentHash.of(secret(process));
        return new Event.Joined(worker, key, machine(machine), false, machine, threads, weight);
    }

    public static Event.Joined server(long worker, int threads) {
        return new Event.Joined(worker, null, Origin.SERVER, false, "this process", threads, 1);
    }
}
