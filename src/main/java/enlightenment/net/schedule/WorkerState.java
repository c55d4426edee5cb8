package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.file.ContentHash;
import java.util.LinkedHashMap;
import java.util.Map;

/** A connected worker as the coordinator sees it. */
final class WorkerState {
    final long worker;
    final ContentHash process;
    final Origin origin;
    final boolean isUnproven;
    final String name;
    final int threads;
    final double weight;
    final long joined;
    final Map<Long, Lease> leases = new LinkedHashMap<>();
    final Speed speed = new Speed();

    /** The time of its last message. */
    long heard;

    /** When it last delivered a tile or, if that is later, was given work after it had none. */
    long progress;

    /** How often it stalled since it last delivered; it is tried again after longer and longer times. */
    int stalls;

    long restsUntil;
    boolean resting;
    int tiles;
    int audits;
    long bytes;

    /** Number of results that it had no lease for. */
    long unasked;

    WorkerState(Event.Joined event, long now) {
        worker = event.worker();
        process = event.process();
        origin = event.origin();
        isUnproven = event.isUnproven();
        name = event.name();
        threads = event.threads();
        weight = event.weight();
        joined = now;
        heard = now;
        progress = now;
    }

    /** Whether this is the worker of the server's own threads. */
    boolean isServer() {
        return origin.equals(Origin.SERVER);
    }

    /** Tiles that it owes and that are waited for, audits aside. */
    int owed() {
        int owed = 0;
        for (Lease lease : leases.values()) {
            owed += lease.kind == Lease.Kind.AUDIT || lease.stalled ? 0 : lease.owed();
        }
        return owed;
    }

    /** Number of leases of work that it holds. */
    int workLeases() {
        int count = 0;
        for (Lease lease : leases.values()) {
            count += lease.kind == Lease.Kind.AUDIT ? 0 : 1;
        }
        return count;
    }

    boolean hasAudit() {
        return leases.size() > workLeases();
    }

    /** Gets nothing now: it lives, but delivered nothing of what it had. */
    boolean isStalled() {
        if (resting) {
            return true;
        }
        for (Lease lease : leases.values()) {
            if (lease.stalled) {
                return true;
            }
        }
        return false;
    }

    /** Tiles per second: measured, or its weight times what a worker of weight 1 is expected to make. */
    double speedOr(double unit) {
        return speed.isKnown() ? speed.perSecond() : weight * unit;
    }
}
