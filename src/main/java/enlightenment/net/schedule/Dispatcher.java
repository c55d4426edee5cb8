package enlightenment.net.schedule;

import enlightenment.sampling.Hash;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Grants leases. Audits come first, then free tiles, then tiles of the lease that is expected to end last.
 *
 * <p>A lease is sized so that its worker needs the time of {@link CoordinatorSettings#leaseNanos()} for it, a quarter of
 * it while its speed is not known. No lease takes more than half of the worker's fair part (by speed) of what is free, so
 * that leases shrink towards the end; with workers alike that is what is free / (2 × workers).
 */
final class Dispatcher {
    private static final int AUDITS_PER_CALL = 16;
    private static final double UNKNOWN_SPEED = 1;

    /** Largest number of leases of work that a worker holds: well below what a heartbeat can name. */
    private static final int MAX_LEASES = 16;

    private final CoordinatorSettings settings;
    private final TileBoard board;
    private final Audits audits;
    private final Collection<WorkerState> members;
    private final Consumer<Action> actions;
    private final GrantLog granted;

    /** Members with threads to spare, and members that should get a lease before they have; first come, first served. */
    private final Set<WorkerState> idle = new LinkedHashSet<>();

    private final Set<WorkerState> hungry = new LinkedHashSet<>();

    private long leasesGranted;

    /** Tiles per second of the members whose speed is known, their weight, and the weight of the others. */
    private double knownSpeed;

    private double knownWeight;
    private double unknownWeight;

    Dispatcher(
            CoordinatorSettings settings,
            TileBoard board,
            Audits audits,
            Collection<WorkerState> members,
            Consumer<Action> actions) {
        this.settings = settings;
        this.board = board;
        this.audits = audits;
        this.members = members;
        this.actions = actions;
        granted = new GrantLog(settings.tiles());
    }

    /** Whether the member's machine was ever asked for the tile: its results of others count for nothing. */
    boolean wasAsked(WorkerState member, int tile) {
        return granted.isGranted(member.origin, tile);
    }

    /** The member's leases have changed. */
    void changed(WorkerState member) {
        int leases = member.workLeases();
        boolean usable = !member.isStalled();
        if (usable && leases < MAX_LEASES && member.owed() < member.threads) {
            idle.add(member);
        } else {
            idle.remove(member);
        }
        if (usable && leases == 1 && isNearItsEnd(member)) {
            hungry.add(member);
        } else {
            hungry.remove(member);
        }
    }

    /** Whether half of its only lease is done. */
    private static boolean isNearItsEnd(WorkerState member) {
        Lease work = null;
        for (Lease lease : member.leases.values()) {
            work = lease.kind == Lease.Kind.AUDIT ? work : lease;
        }
        return work != null && work.owed() <= Math.max(member.threads, (work.last - work.first) / 2);
    }

    void left(WorkerState member) {
        idle.remove(member);
        hungry.remove(member);
    }

    /** Adds up the speeds afresh; to be called when members come or go and, against rounding, now and then. */
    void measure() {
        knownSpeed = 0;
        knownWeight = 0;
        unknownWeight = 0;
        for (WorkerState member : members) {
            if (member.speed.isKnown()) {
                knownSpeed += member.speed.perSecond();
                knownWeight += member.weight;
            } else {
                unknownWeight += member.weight;
            }
        }
    }

    /** The member has delivered a tile, this long after the one before. */
    void delivered(WorkerState member, double afterSeconds) {
        double before = member.speed.isKnown() ? member.speed.perSecond() : 0;
        boolean wasKnown = member.speed.isKnown();
        member.speed.delivered(afterSeconds);
        if (member.speed.isKnown()) {
            knownSpeed += member.speed.perSecond() - before;
            knownWeight += wasKnown ? 0 : member.weight;
            unknownWeight -= wasKnown ? 0 : member.weight;
        }
    }

    private boolean isSpeedKnown() {
        return knownWeight > 0;
    }

    /** The tiles per second that a worker of weight 1 is expected to make. */
    private double unitSpeed() {
        return isSpeedKnown() ? knownSpeed / knownWeight : UNKNOWN_SPEED;
    }

    /** Tiles per second of all members, 0 if nothing is known. */
    double totalSpeed() {
        return isSpeedKnown() ? knownSpeed + unknownWeight * unitSpeed() : 0;
    }

    /** Hands out whatever can be handed out now. */
    void serve(long now) {
        serveAudits(now);
        // Towards the end leases are small, and a worker of many threads may need several at once.
        while (board.free() > 0 && !idle.isEmpty()) {
            serveFree(idle, now);
        }
        serveFree(hungry, now);
        while (board.free() == 0 && board.copyable() > 0 && !idle.isEmpty()) {
            if (!help(now)) {
                return;
            }
        }
    }

    private void serveAudits(long now) {
        if (idle.isEmpty() && hungry.isEmpty()) {
            return;
        }
        for (Audits.Open open : audits.someWaiting(AUDITS_PER_CALL)) {
            WorkerState auditor = firstAble(open, idle);
            auditor = auditor == null ? firstAble(open, hungry) : auditor;
            if (auditor != null) {
                audits.lease(open, grant(auditor, open.tile, open.tile + 1, Lease.Kind.AUDIT, now));
            }
        }
    }

    private static WorkerState firstAble(Audits.Open open, Set<WorkerState> candidates) {
        for (WorkerState member : candidates) {
            if (!member.hasAudit() && open.canBeVotedOnBy(member)) {
                return member;
            }
        }
        return null;
    }

    /** Whether anybody who is connected could vote on the tile, now or later. */
    boolean canBeVotedOn(Audits.Open open) {
        for (WorkerState member : members) {
            if (!member.isStalled() && open.canBeVotedOnBy(member)) {
                return true;
            }
        }
        return false;
    }

    private void serveFree(Set<WorkerState> candidates, long now) {
        if (board.free() == 0 || candidates.isEmpty()) {
            return;
        }
        for (WorkerState member : new ArrayList<>(candidates)) {
            if (board.free() == 0) {
                return;
            }
            int first = board.nextFree();
            int last = board.endOfFree(first, size(member));
            board.hold(grant(member, first, last, Lease.Kind.WORK, now));
            changed(member);
        }
    }

    /** The number of tiles for the member's next lease, at least one. */
    int size(WorkerState member) {
        double speed = member.speedOr(unitSpeed());
        double seconds = settings.leaseNanos() / (double) CoordinatorSettings.SECOND;
        double tiles = member.threads;
        if (member.speed.isKnown()) {
            tiles = Math.max(tiles, speed * seconds);
        } else if (isSpeedKnown()) {
            tiles = Math.max(tiles, speed * seconds / 4);
        }
        double all = knownSpeed + unknownWeight * unitSpeed();
        double limit = board.free() * Math.min(speed / all, 1) / 2;
        return (int) Math.max(1, Math.min(tiles, limit));
    }

    private Lease grant(WorkerState member, int first, int last, Lease.Kind kind, long now) {
        long id = Hash.of(settings.seed(), ++leasesGranted);
        Lease lease = new Lease(id, member, first, last, kind, now);
        if (member.leases.isEmpty()) {
            member.progress = now;
        }
        member.leases.put(id, lease);
        granted.granted(member.origin, first, last);
        actions.accept(new Action.Grant(member.worker, id, first, last));
        return lease;
    }

    /**
     * Gives an idle member tiles of the lease that is expected to end last; false if no member can help. Of tiles that its holder has
     * hardly begun the latter half moves to the idle member, and can be divided again; tiles in progress are copied.
     */
    private boolean help(long now) {
        Lease late = latest(now);
        WorkerState helper = late == null ? null : firstOtherThan(late.member);
        if (helper == null) {
            return false;
        }
        int[] singles = board.lastSingles(late);
        int begun = firstNotBegun(late, singles[0]);
        boolean isMove = begun < singles[1];
        int from = isMove ? begun : singles[0];
        int first = from + (singles[1] - from) / 2;
        int last = Math.min(singles[1], first + sizeOfHelp(helper));
        if (isMove) {
            for (int tile = first; tile < last; tile++) {
                board.takeFrom(late, tile);
            }
            actions.accept(new Action.Skip(late.member.worker, late.id, first, last));
            if (late.owed() == 0) {
                late.member.leases.remove(late.id);
            }
            changed(late.member);
        }
        board.hold(grant(helper, first, last, isMove ? Lease.Kind.WORK : Lease.Kind.COPY, now));
        changed(helper);
        return true;
    }

    private WorkerState firstOtherThan(WorkerState member) {
        for (WorkerState candidate : idle) {
            if (candidate != member) {
                return candidate;
            }
        }
        return null;
    }

    /**
     * The first tile from {@code from} on that the holder has not begun. It begins as many tiles as it has threads. Audits do not count,
     * here as in {@link WorkerState#owed()}: so only a member with more tiles than it can begin loses some by this, no member becomes idle
     * by it, and two members cannot pass a tile to and fro.
     */
    private static int firstNotBegun(Lease lease, int from) {
        int inHand = lease.member.threads;
        for (Lease earlier : lease.member.leases.values()) {
            if (earlier == lease) {
                break;
            }
            inHand -= earlier.kind == Lease.Kind.AUDIT ? 0 : earlier.owed();
        }
        int tile = lease.first;
        while (tile < lease.last && inHand > 0) {
            inHand -= lease.owes(tile) ? 1 : 0;
            tile++;
        }
        return Math.max(tile, from);
    }

    private int sizeOfHelp(WorkerState helper) {
        double seconds = settings.leaseNanos() / (double) CoordinatorSettings.SECOND;
        double inTime = Math.max(helper.threads - helper.owed(), helper.speedOr(unitSpeed()) * seconds);
        return (int) Math.max(1, Math.min(inTime, board.undone()));
    }

    /** The last lease with something to copy of the member that is expected to be done last. */
    private Lease latest(long now) {
        Lease latest = null;
        double longest = -1;
        for (WorkerState member : members) {
            Lease copyable = lastCopyable(member);
            if (copyable == null) {
                continue;
            }
            // Who has been silent for long is believed to stay so for as long again.
            double since = (now - member.progress) / (double) CoordinatorSettings.SECOND;
            double remaining = Math.max(member.owed() / member.speedOr(unitSpeed()), since);
            if (remaining > longest) {
                longest = remaining;
                latest = copyable;
            }
        }
        return latest;
    }

    private static Lease lastCopyable(WorkerState member) {
        Lease last = null;
        for (Lease lease : member.leases.values()) {
            last = lease.single > 0 ? lease : last;
        }
        return last;
    }

    /** The members that have nothing to do, for the status. */
    List<WorkerState> idle() {
        return List.copyOf(idle);
    }
}
