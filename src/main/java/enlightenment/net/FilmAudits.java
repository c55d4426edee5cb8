package enlightenment.net;

import java.util.Map;
import java.util.TreeMap;

/** The audits of a film's frames: of each those of the round that made it last. Used by one thread. */
final class FilmAudits {
    /** Tiles that two machines were to render, and those that rest on the word of one. */
    private record Count(int due, int missing) {
        private static final Count NONE = new Count(0, 0);

        private Count plus(Count other) {
            return new Count(due + other.due, missing + other.missing);
        }
    }

    private final Map<Integer, Count> byFrame = new TreeMap<>();

    /** A round has ended. */
    void add(FilmQueue.Round round, ServerRound server) {
        round.numbers().forEach(byFrame::remove);
        for (int tile : server.auditsDue()) {
            byFrame.merge(round.numberOfTile(tile), new Count(1, 0), Count::plus);
        }
        for (int tile : server.auditsMissing()) {
            byFrame.merge(round.numberOfTile(tile), new Count(0, 1), Count::plus);
        }
    }

    AuditCount count() {
        Count sum = byFrame.values().stream().reduce(Count.NONE, Count::plus);
        return new AuditCount(
                sum.due,
                sum.missing,
                true,
                byFrame.entrySet().stream()
                        .filter(e -> e.getValue().missing > 0)
                        .map(Map.Entry::getKey)
                        .toList());
    }
}
