package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.checkpoint.Restored;
import enlightenment.file.ContentHash;
import enlightenment.net.job.TileData;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Assigns tiles to workers. It has no clock, no socket and no thread: it receives events with their times and returns actions. Equal
 * sequences of events give equal actions, so that whole renders can be simulated.
 *
 * <p>What it rests on: a tile is a pure function, so results may come late, twice and in any order from any machine that was ever assigned
 * them. Results that a machine was not assigned are acknowledged and do not count. Whatever can be lost is renewed by time: a lease that
 * its holder does not name in its heartbeats is granted to another worker, a silent worker is disconnected, one that sends heartbeats but
 * no results is not waited for. Two copies at most of a tile are waited for at once, and the first result counts.
 *
 * <p>Not for use by several threads at once. Times are nanoseconds of any origin; they must not run backwards.
 */
public final class Coordinator {
    private static final int EVENTS_REMEMBERED = 200;
    private static final int STALL_FACTOR = 8;
    private static final int MAX_DOUBLINGS = 6;

    private final CoordinatorSettings settings;
    private final TileBoard board;
    private final Audits audits;
    private final Dispatcher dispatcher;
    private final Map<Long, WorkerState> members = new LinkedHashMap<>();
    private final Map<ContentHash, WorkerState> byProcess = new HashMap<>();
    private final Set<Origin.Peer> expelled = new HashSet<>();
    private final Deque<Snapshot.Note> notes = new ArrayDeque<>();
    private final long started;
    private List<Action> actions = new ArrayList<>();
    private long now;
    private long longestTile;
    private boolean finished;
    private long duplicates;

    /**
     * A coordinator that goes on from what was restored.
     *
     * @param now the time at the start
     */
    public Coordinator(CoordinatorSettings settings, Restored restored, long now) {
        this.settings = settings;
        this.now = now;
        started = now;
        board = new TileBoard(settings.tiles(), settings.offered());
        audits = new Audits(settings);
        dispatcher = new Dispatcher(settings, board, audits, members.values(), a -> actions.add(a));
        expelled.addAll(restored.expelled());
        for (Restored.Tile tile : restored.tiles()) {
            audits.restore(tile);
            board.finish(tile.tile());
        }
    }

    /** Processes an event and returns the actions that follow from it. */
    public List<Action> handle(long time, Event event) {
        now = time;
        actions = new ArrayList<>();
        if (event instanceof Event.Joined joined) {
            join(joined);
        } else if (event instanceof Event.Delivered delivered) {
            deliver(delivered);
        } else if (event instanceof Event.Heard heard) {
            hear(heard);
        } else if (event instanceof Event.Left left) {
            leave(members.get(left.worker()), left.reason());
        } else if (event instanceof Event.Misbehaved misbehaved) {
            WorkerState member = members.get(misbehaved.worker());
            if (member != null) {
                expel(member.origin, misbehaved.reason());
            }
        } else if (event instanceof Event.Offered offered) {
            board.offer(offered.end());
        } else if (event instanceof Event.Forgotten forgotten) {
            forget(forgotten);
        } else {
            expire();
        }
        if (!finished) {
            dispatcher.serve(now);
            callServer();
            settle();
        }
        return actions;
    }

    boolean isFinished() {
        return finished;
    }

    private void join(Event.Joined event) {
        if (event.origin() instanceof Origin.Peer machine && expelled.contains(machine)) {
            actions.add(new Action.Refuse(event.worker(), "this machine was expelled: it gave wrong results"));
            return;
        }
        WorkerState before = event.process() == null ? null : byProcess.get(event.process());
        if (before != null) {
            hangUp(before, "the same worker has a newer connection");
        }
        WorkerState member = new WorkerState(event, now);
        members.put(member.worker, member);
        if (member.process != null) {
            byProcess.put(member.process, member);
        }
        dispatcher.changed(member);
        dispatcher.measure();
        note(member.name + " joined with " + member.threads + " threads");
    }

    private void leave(WorkerState member, String reason) {
        if (member == null) {
            return;
        }
        for (Lease lease : List.copyOf(member.leases.values())) {
            end(lease);
        }
        dispatcher.left(member);
        members.remove(member.worker);
        byProcess.remove(member.process, member);
        dispatcher.measure();
        note(member.name + " left: " + reason);
    }

    private void hangUp(WorkerState member, String reason) {
        actions.add(new Action.HangUp(member.worker, reason));
        leave(member, reason);
    }

    /** The lease is over, with whatever is still owed. */
    private void end(Lease lease) {
        giveBack(lease);
        lease.member.leases.remove(lease.id);
        dispatcher.changed(lease.member);
    }

    private void giveBack(Lease lease) {
        if (lease.kind == Lease.Kind.AUDIT) {
            audits.release(lease);
        } else {
            board.release(lease);
        }
    }

    private void hear(Event.Heard event) {
        WorkerState member = members.get(event.worker());
        if (member == null) {
            return;
        }
        member.heard = now;
        for (Long id : event.leases()) {
            Lease lease = member.leases.get(id);
            if (lease == null) {
                actions.add(new Action.Cancel(member.worker, id));
            } else {
                lease.renewed = now;
            }
        }
        actions.add(new Action.Answer(member.worker, board.done()));
    }

    private void deliver(Event.Delivered event) {
        WorkerState member = members.get(event.worker());
        if (member == null) {
            return;
        }
        int tile = event.tile();
        if (tile < 0 || tile >= settings.tiles()) {
            expel(member.origin, "sent tile " + tile + " of 0.." + (settings.tiles() - 1));
            return;
        }
        member.heard = now;
        if (!dispatcher.wasAsked(member, tile)) {
            unasked(member, tile);
        } else if (!finished) {
            count(member, event);
        }
        actions.add(new Action.Acknowledge(member.worker, tile));
    }

    /** Honest workers have such tiles of an earlier incarnation of the server: they are made again by whom they are granted to. */
    private void unasked(WorkerState member, int tile) {
        if (member.unasked++ == 0) {
            note(member.name + " sent tile " + tile + ", which it was not asked for: such tiles do not count");
        }
    }

    private void count(WorkerState member, Event.Delivered event) {
        int tile = event.tile();
        Audits.Open open = audits.open(tile);
        boolean isAudit = open != null && open.lease != null && open.lease.member == member;
        Audits.Verdict verdict = audits.vote(tile, member.origin, event.data().hash(), member.isUnproven);
        if (verdict.keep()) {
            actions.add(new Action.Keep(tile, member.origin, event.data()));
        } else {
            duplicates++;
        }
        if (!verdict.repeated()) {
            credit(member, event.data(), isAudit);
        }
        discharge(member, tile);
        for (Lease holder : board.finish(tile)) {
            skip(holder, tile);
        }
        if (verdict.moot() != null) {
            skip(verdict.moot(), tile);
        }
        if (verdict.confirmedBy() != null) {
            actions.add(new Action.Confirm(tile, verdict.confirmedBy()));
        }
        for (Origin liar : verdict.liars()) {
            expel(liar, "its tile " + tile + " differs from what the server or itself made of it");
        }
    }

    private void credit(WorkerState member, TileData data, boolean isAudit) {
        long took = Math.max(now - member.progress, 0);
        dispatcher.delivered(member, took / (double) CoordinatorSettings.SECOND);
        member.progress = now;
        member.stalls = 0;
        member.resting = false;
        member.tiles++;
        member.audits += isAudit ? 1 : 0;
        member.bytes += data.bytes().length;
        longestTile = Math.max(longestTile, took);
    }

    /** The member owes the tile no more, in whatever lease of it. */
    private void discharge(WorkerState member, int tile) {
        for (Lease lease : List.copyOf(member.leases.values())) {
            if (lease.clear(tile)) {
                lease.renewed = now;
                endIfDone(lease);
            }
        }
    }

    private void endIfDone(Lease lease) {
        if (lease.owed() == 0) {
            end(lease);
        }
        dispatcher.changed(lease.member);
    }

    /** Releases a lease's tile that another worker has finished first. */
    private void skip(Lease lease, int tile) {
        if (lease.clear(tile)) {
            actions.add(new Action.Skip(lease.member.worker, lease.id, tile, tile + 1));
            endIfDone(lease);
        }
    }

    private void expel(Origin origin, String reason) {
        if (!(origin instanceof Origin.Peer machine) || !expelled.add(machine)) {
            return;
        }
        note("machine " + machine + " expelled: " + reason);
        actions.add(new Action.Expel(machine, reason));
        for (WorkerState member : List.copyOf(members.values())) {
            if (member.origin.equals(machine)) {
                note(member.name + " is of that machine");
                actions.add(new Action.Refuse(member.worker, reason));
                leave(member, "expelled");
            }
        }
        for (Integer tile : audits.expel(machine)) {
            board.undo(tile);
            actions.add(new Action.Revoke(tile));
        }
    }

    private void forget(Event.Forgotten event) {
        for (int tile = event.first(); tile < event.last(); tile++) {
            if (board.isDone(tile)) {
                Lease moot = audits.forget(tile);
                if (moot != null) {
                    skip(moot, tile);
                }
                board.undo(tile);
            }
        }
    }

    /** Ends leases that were not renewed, disconnects silent workers and stops waiting for stalled ones. */
    private void expire() {
        dispatcher.measure();
        long stall = Math.max(settings.stallNanos(), STALL_FACTOR * longestTile);
        for (WorkerState member : List.copyOf(members.values())) {
            if (!member.isServer() && now - member.heard >= settings.silenceNanos()) {
                hangUp(member, "silent for " + (now - member.heard) / 1_000_000 + " ms");
                continue;
            }
            for (Lease lease : List.copyOf(member.leases.values())) {
                if (now - lease.renewed >= settings.silenceNanos()) {
                    actions.add(new Action.Cancel(member.worker, lease.id));
                    end(lease);
                }
            }
            if (!member.isStalled() && !member.leases.isEmpty() && now - member.progress >= stall) {
                stall(member, stall);
            } else if (member.resting && now - member.restsUntil >= 0) {
                member.resting = false;
                dispatcher.changed(member);
            }
        }
    }

    /** Gives the tiles of a member that delivers nothing to others. Its own results still count whenever they come. */
    private void stall(WorkerState member, long time) {
        note(member.name + " delivers nothing; its tiles go to others");
        member.resting = true;
        member.restsUntil = now + (time << Math.min(member.stalls, MAX_DOUBLINGS));
        member.stalls++;
        for (Lease lease : List.copyOf(member.leases.values())) {
            lease.stalled = true;
            giveBack(lease);
            actions.add(new Action.Cancel(member.worker, lease.id));
        }
        dispatcher.changed(member);
    }

    /** Demands that the server joins as a worker if votes differ on a tile, which only the server can decide. */
    private void callServer() {
        Integer disputed = audits.firstDisputed();
        if (disputed != null && members.values().stream().noneMatch(WorkerState::isServer)) {
            actions.add(new Action.CallLocal(disputed));
        }
    }

    /** Finishes once all is done. Audits that no member can make are forgone, but not disputes: the server decides these. */
    private void settle() {
        if (board.undone() > 0) {
            return;
        }
        for (Audits.Open open : audits.open()) {
            if (open.isDisputed() || open.lease != null || dispatcher.canBeVotedOn(open)) {
                return;
            }
        }
        finished = true;
        actions.add(new Action.Finish());
        note("finished");
    }

    private void note(String text) {
        if (notes.size() == EVENTS_REMEMBERED) {
            notes.removeFirst();
        }
        notes.addLast(new Snapshot.Note((now - started) / 1e9, text));
    }

    /** The leases that the coordinator believes the worker to hold. */
    Set<Long> leasesOf(long worker) {
        WorkerState member = members.get(worker);
        return member == null ? Set.of() : Set.copyOf(member.leases.keySet());
    }

    /** The machines whose results are not trusted any more. */
    public Set<Origin.Peer> expelled() {
        return Set.copyOf(expelled);
    }

    /** The tiles that a second machine was to render too, or the server, in ascending order. */
    public List<Integer> auditsDue() {
        return audits.due();
    }

    /** Tiles of {@link #auditsDue} that have no second vote: their results rest on a single machine. */
    public List<Integer> auditsMissing() {
        return audits.missing();
    }

    /** The state of the render at this time. */
    public Snapshot snapshot(long time) {
        return Snapshot.of(
                new Snapshot.Source(
                        finished, board, audits, dispatcher, members.values(), expelled, notes, duplicates, started),
                time);
    }
}
