package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * The immutable state of a distributed render at one moment, for people and scripts.
 *
 * @param finished whether everything is done
 * @param tiles number of tiles
 * @param done tiles that are done
 * @param leased tiles that someone is rendering
 * @param free tiles that wait
 * @param auditsOpen tiles that need another worker's vote
 * @param confirmed tiles that two workers agree on
 * @param duplicates results that came for tiles that were done, audits among them
 * @param elapsedSeconds since this incarnation of the server began
 * @param remainingSeconds expected time to the end, empty if no speed is known
 * @param workers the workers that are connected, in the order of their joining
 * @param expelled machines that are not trusted, each by the digits that it is called by
 * @param notes the last joins, losses and other events, oldest first
 */
public record Snapshot(
        boolean finished,
        int tiles,
        int done,
        int leased,
        int free,
        int auditsOpen,
        int confirmed,
        long duplicates,
        double elapsedSeconds,
        OptionalDouble remainingSeconds,
        List<Worker> workers,
        Set<String> expelled,
        List<Note> notes) {

    /** An event in words, this many seconds after the start. */
    public record Note(double seconds, String text) {}

    /**
     * A connected worker.
     *
     * @param worker number of its connection
     * @param tiles tiles that it delivered over this connection, audits and copies among them
     * @param audits audits among them
     * @param bytes bytes of these tiles
     * @param tilesPerSecond smoothed speed, empty until it has delivered
     * @param owed tiles that it has been asked for
     * @param silentSeconds since its last message
     * @param stalled whether it lives but delivers nothing
     */
    public record Worker(
            long worker,
            String name,
            int threads,
            double connectedSeconds,
            int tiles,
            int audits,
            long bytes,
            OptionalDouble tilesPerSecond,
            int owed,
            double silentSeconds,
            boolean stalled) {}

    /**
     * The parts of a coordinator that a snapshot is made from.
     *
     * @param started when this incarnation of the server began, on the clock of the snapshot
     */
    record Source(
            boolean finished,
            TileBoard board,
            Audits audits,
            Dispatcher dispatcher,
            Collection<WorkerState> members,
            Set<Origin.Peer> expelled,
            Collection<Note> notes,
            long duplicates,
            long started) {}

    static Snapshot of(Source source, long now) {
        TileBoard board = source.board;
        int auditsOpen = source.audits.openCount();
        return new Snapshot(
                source.finished,
                board.tiles(),
                board.done(),
                board.undone() - board.free(),
                board.free(),
                auditsOpen,
                source.audits.confirmedCount(),
                source.duplicates,
                seconds(now - source.started),
                remaining(source.finished ? 0 : board.undone() + auditsOpen, source.dispatcher.totalSpeed()),
                source.members.stream().map(member -> worker(member, now)).toList(),
                source.expelled.stream().map(Origin.Peer::toString).collect(Collectors.toCollection(TreeSet::new)),
                List.copyOf(source.notes));
    }

    private static OptionalDouble remaining(double left, double speed) {
        if (left == 0) {
            return OptionalDouble.of(0);
        }
        return speed > 0 ? OptionalDouble.of(left / speed) : OptionalDouble.empty();
    }

    private static Worker worker(WorkerState member, long now) {
        return new Worker(
                member.worker,
                member.name,
                member.threads,
                seconds(now - member.joined),
                member.tiles,
                member.audits,
                member.bytes,
                member.speed.isKnown() ? OptionalDouble.of(member.speed.perSecond()) : OptionalDouble.empty(),
                member.owed(),
                seconds(now - member.heard),
                member.isStalled());
    }

    private static double seconds(long nanos) {
        return nanos / (double) CoordinatorSettings.SECOND;
    }
}
