package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.net.schedule.Snapshot;
import enlightenment.status.State;
import enlightenment.status.Status;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;

class SnapshotStatusTest {
    private static Snapshot snapshot(boolean finished) {
        Snapshot.Worker one =
                new Snapshot.Worker(7, "one \"quoted\"", 3, 1.5, 5, 1, 2_000, OptionalDouble.of(2.5), 4, 0.25, false);
        Snapshot.Worker two = new Snapshot.Worker(8, "two", 1, 0.5, 0, 0, 0, OptionalDouble.empty(), 2, 0.125, true);
        return new Snapshot(
                finished,
                20,
                9,
                6,
                5,
                1,
                2,
                3,
                4.5,
                OptionalDouble.empty(),
                List.of(one, two),
                Set.of("b", "a"),
                List.of(new Snapshot.Note(0.5, "one joined")));
    }

    @Test
    void thePageIsToldWhatTheSnapshotTells() {
        Status status = SnapshotStatus.of(snapshot(false));
        assertEquals(State.RENDERING, status.state());
        assertEquals(9, status.done());
        assertEquals(20, status.total());
        assertEquals("tiles", status.unit());
        assertEquals(4.5, status.elapsedSeconds());
        assertEquals(OptionalDouble.empty(), status.remainingSeconds());
        assertEquals(List.of(new Status.Note(0.5, "one joined")), status.notes());
        Map<String, ?> figures = status.statistics();
        Map<String, Integer> counts = Map.of("tiles", 20, "leased", 6, "free", 5, "auditsOpen", 1, "confirmed", 2);
        counts.forEach((key, count) -> assertEquals(count, figures.get(key), key));
        assertEquals(3L, figures.get("duplicates"));
        assertEquals(List.of("a", "b"), figures.get("expelled"));
        Map<String, Object> one = Map.of(
                "name",
                "one \"quoted\"",
                "threads",
                3,
                "connectedSeconds",
                1.5,
                "tiles",
                5,
                "audits",
                1,
                "bytes",
                2_000L,
                "tilesPerSecond",
                OptionalDouble.of(2.5),
                "owed",
                4,
                "silentSeconds",
                0.25,
                "stalled",
                false);
        assertEquals(one, ((List<?>) figures.get("workers")).get(0));
        assertEquals(2, ((List<?>) figures.get("workers")).size());
        assertEquals(State.FINISHED, SnapshotStatus.of(snapshot(true)).state());
    }

    @Test
    void everyTileMakesAnotherPicture() {
        assertEquals(10, SnapshotStatus.of(snapshot(false)).picture());
    }
}
