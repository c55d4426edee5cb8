package enlightenment.net.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class WorkerCoreTest {
    private static final long NEVER = Long.MAX_VALUE;

    private static WorkerCore.Task finishNext(WorkerCore core) {
        WorkerCore.Task task = core.begin().orElseThrow();
        core.finished(task, SimTile.right(task.tile()));
        return task;
    }

    private static List<Integer> tiles(List<WorkerCore.Outgoing> outgoing) {
        return outgoing.stream().map(WorkerCore.Outgoing::tile).toList();
    }

    @Test
    void tilesAreRenderedInTheOrderOfTheirGrants() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 3, 5);
        core.granted(8, 0, 1);
        assertEquals(new WorkerCore.Task(7, 3), core.begin().orElseThrow());
        assertEquals(new WorkerCore.Task(7, 4), core.begin().orElseThrow());
        assertEquals(new WorkerCore.Task(8, 0), core.begin().orElseThrow());
        assertTrue(core.begin().isEmpty());
    }

    @Test
    void atMostTheWindowTravelsAndNothingIsBegunWhenTheBoxIsFull() {
        WorkerCore core = new WorkerCore(2, 3, NEVER);
        core.granted(1, 0, 100);
        for (int i = 0; i < 5; i++) {
            finishNext(core);
        }
        assertTrue(core.begin().isEmpty());
        assertEquals(List.of(0, 1, 2), tiles(core.outgoing(0)));
        assertEquals(List.of(), tiles(core.outgoing(1)));
        core.acknowledged(1);
        assertEquals(List.of(3), tiles(core.outgoing(2)));
        assertEquals(5, core.begin().orElseThrow().tile());
    }

    @Test
    void aLeaseIsNamedUntilItsLastTileIsAcknowledged() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 0, 2);
        finishNext(core);
        finishNext(core);
        core.outgoing(0);
        core.acknowledged(0);
        assertEquals(List.of(7L), core.leases());
        core.acknowledged(1);
        assertEquals(List.of(), core.leases());
    }

    @Test
    void aCancelledLeaseKeepsWhatIsBegunOnly() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 0, 5);
        WorkerCore.Task begun = core.begin().orElseThrow();
        core.cancelled(7);
        assertTrue(core.begin().isEmpty());
        assertEquals(List.of(7L), core.leases());
        core.finished(begun, SimTile.right(0));
        assertEquals(List.of(0), tiles(core.outgoing(0)));
        core.acknowledged(0);
        assertEquals(List.of(), core.leases());
    }

    @Test
    void aSkippedTileIsNotBegun() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 0, 3);
        core.skipped(7, 1, 2);
        assertEquals(0, core.begin().orElseThrow().tile());
        assertEquals(2, core.begin().orElseThrow().tile());
        assertTrue(core.begin().isEmpty());
    }

    @Test
    void aTileOfTwoLeasesIsRenderedOnce() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 0, 1);
        core.granted(8, 0, 1);
        finishNext(core);
        assertTrue(core.begin().isEmpty());
        core.acknowledged(0);
        assertTrue(core.begin().isEmpty());
        assertEquals(List.of(), core.leases());
    }

    @Test
    void afterADisconnectionFinishedTilesAreSentAgainAndLeasesAreOver() {
        WorkerCore core = new WorkerCore(1, 8, NEVER);
        core.granted(7, 0, 5);
        finishNext(core);
        WorkerCore.Task inHand = core.begin().orElseThrow();
        core.outgoing(0);
        core.disconnected();
        assertEquals(List.of(), core.leases());
        assertTrue(core.begin().isEmpty());
        core.finished(inHand, SimTile.right(1));
        assertEquals(List.of(0, 1), tiles(core.outgoing(1)));
        assertEquals(2, core.unacknowledged());
    }

    @Test
    void whatIsNotAcknowledgedInTimeIsSentAgain() {
        WorkerCore core = new WorkerCore(1, 8, 100);
        core.granted(7, 0, 1);
        finishNext(core);
        assertEquals(List.of(0), tiles(core.outgoing(0)));
        assertEquals(List.of(), tiles(core.outgoing(99)));
        assertEquals(List.of(0), tiles(core.outgoing(100)));
    }
}
