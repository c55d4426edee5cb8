package enlightenment.net.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Restored;
import enlightenment.net.job.TileData;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Results count for who was asked for them, and audits that nobody made are not forgotten. */
class AskedResultsTest {
    private static final long SECOND = CoordinatorSettings.SECOND;

    private final List<Action> all = new ArrayList<>();
    private long now = 5 * SECOND;

    private static Coordinator coordinator(int tiles, double audits) {
        return new Coordinator(CoordinatorSettings.of(tiles, 7, 3).withAuditRate(audits), Restored.NOTHING, 5 * SECOND);
    }

    private void tell(Coordinator c, Event event) {
        all.addAll(c.handle(now, event));
    }

    private void join(Coordinator c, long worker) {
        tell(c, Peers.joined(worker, "p" + worker, "m" + worker, 1, 1));
    }

    private void deliver(Coordinator c, long worker, int tile, TileData data) {
        tell(c, new Event.Delivered(worker, 0, tile, data));
    }

    private Set<Integer> kept() {
        Set<Integer> tiles = new TreeSet<>();
        all.stream().filter(Action.Keep.class::isInstance).forEach(a -> tiles.add(((Action.Keep) a).tile()));
        return tiles;
    }

    private Set<Integer> grantedTo(long worker) {
        Set<Integer> tiles = new TreeSet<>();
        for (Action action : all) {
            if (action instanceof Action.Grant g && g.worker() == worker) {
                for (int tile = g.first(); tile < g.last(); tile++) {
                    tiles.add(tile);
                }
            }
        }
        return tiles;
    }

    /** Does what it is asked for until nothing is asked any more. */
    private void workAlone(Coordinator c, long worker) {
        Set<Integer> made = new TreeSet<>();
        for (boolean isMore = true; isMore; ) {
            isMore = false;
            for (int tile : grantedTo(worker)) {
                if (made.add(tile)) {
                    isMore = true;
                    now += SECOND / 10;
                    deliver(c, worker, tile, SimTile.right(tile));
                }
            }
        }
    }

    @Test
    void whoSendsAllTilesUnaskedMakesNoneButThoseThatItIsAskedFor() {
        int tiles = 500;
        Coordinator c = coordinator(tiles, 0.05);
        join(c, 1);
        for (int tile = tiles - 1; tile >= 0; tile--) {
            deliver(c, 1, tile, SimTile.wrong(tile, 1));
        }
        assertTrue(grantedTo(1).containsAll(kept()), "kept " + kept());
        assertFalse(c.isFinished());
        long acknowledged =
                all.stream().filter(Action.Acknowledge.class::isInstance).count();
        assertEquals(tiles, acknowledged, "an honest worker with results of an earlier server lets go of them");
        assertTrue(c.snapshot(now).notes().stream().anyMatch(n -> n.text().contains("which it was not asked for")));
    }

    @Test
    void whatAnotherWasAskedForDoesNotCount() {
        Coordinator c = coordinator(2, 0);
        join(c, 1);
        join(c, 2);
        assertEquals(Set.of(1), grantedTo(2), "of the tiles of the first it has the one that is not begun");
        deliver(c, 2, 0, SimTile.wrong(0, 1));
        assertEquals(Set.of(), kept());
        deliver(c, 2, 1, SimTile.right(1));
        assertEquals(Set.of(1), kept());
    }

    @Test
    void ofATileTheLastEightMachinesThatWereAskedAreRemembered() {
        GrantLog log = new GrantLog(2);
        for (int machine = 0; machine < 9; machine++) {
            log.granted(Peers.machine("m" + machine), 1, 2);
        }
        for (int machine = 0; machine < 9; machine++) {
            assertEquals(machine > 0, log.isGranted(Peers.machine("m" + machine), 1), "machine " + machine);
            assertFalse(log.isGranted(Peers.machine("m" + machine), 0));
        }
    }

    @Test
    void aLateResultOfALeaseThatIsOverCountsStill() {
        Coordinator c = coordinator(1, 0);
        join(c, 1);
        for (int i = 0; i < 9; i++) {
            now += SECOND;
            tell(c, new Event.Heard(1, Set.of()));
            tell(c, new Event.Tick());
        }
        assertTrue(all.stream().anyMatch(Action.Cancel.class::isInstance), "the lease is over");
        deliver(c, 1, 0, SimTile.right(0));
        assertEquals(Set.of(0), kept());
    }

    @Test
    void anAuditThatNobodyCouldMakeIsMissing() {
        Coordinator c = new Coordinator(Peers.auditing(2, 4), Restored.NOTHING, now);
        join(c, 1);
        workAlone(c, 1);
        assertTrue(c.isFinished());
        assertEquals(List.of(2), c.auditsDue());
        assertEquals(List.of(2), c.auditsMissing());
    }

    @Test
    void anAuditThatAnotherMachineMadeIsNotMissing() {
        Coordinator c = new Coordinator(Peers.auditing(2, 4), Restored.NOTHING, now);
        join(c, 1);
        join(c, 2);
        for (int turn = 0; turn < 4; turn++) {
            workAlone(c, 1);
            workAlone(c, 2);
        }
        assertTrue(c.isFinished());
        assertEquals(List.of(2), c.auditsDue());
        assertEquals(List.of(), c.auditsMissing());
    }

    @Test
    void theServersOwnTilesNeedNoAudit() {
        Coordinator c = coordinator(3, 1);
        tell(c, Peers.server(1, 1));
        workAlone(c, 1);
        assertTrue(c.isFinished());
        assertEquals(List.of(), c.auditsDue());
    }

    @Test
    void anAuditThatWasMadeBeforeTheServerDiedIsNotMissing() {
        TileData right = SimTile.right(0);
        Restored restored = new Restored(
                List.of(
                        new Restored.Tile(0, Peers.machine("m1"), right.hash(), Peers.machine("m2")),
                        new Restored.Tile(1, Peers.machine("m1"), right.hash(), null)),
                Set.of());
        Coordinator c = new Coordinator(CoordinatorSettings.of(2, 7, 3).withAuditRate(1), restored, now);
        tell(c, new Event.Tick());
        assertTrue(c.isFinished());
        assertEquals(List.of(0, 1), c.auditsDue());
        assertEquals(List.of(1), c.auditsMissing());
    }
}
