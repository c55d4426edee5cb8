package enlightenment.net.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Origin;
import enlightenment.checkpoint.Restored;
import enlightenment.file.ContentHash;
import enlightenment.net.job.TileData;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Rules of the coordinator, one by one. */
class CoordinatorTest {
    private static final long SECOND = CoordinatorSettings.SECOND;
    private static final long SALT = 2;

    private long now = -7 * SECOND;

    private static CoordinatorSettings settings(int tiles, double audits) {
        return CoordinatorSettings.of(tiles, 99, SALT).withAuditRate(audits);
    }

    private Coordinator coordinator(int tiles, double audits) {
        return new Coordinator(settings(tiles, audits), Restored.NOTHING, now);
    }

    /** Of these tiles only one is audited. */
    private Coordinator auditing(int tile, int tiles) {
        return new Coordinator(Peers.auditing(tile, tiles), Restored.NOTHING, now);
    }

    private List<Action> join(Coordinator c, long worker, double weight) {
        String name = "m" + worker;
        return c.handle(now, Peers.joined(worker, name, name, 1, weight));
    }

    private List<Action> joinLocal(Coordinator c, long worker) {
        return c.handle(now, Peers.server(worker, 1));
    }

    private List<Action> deliver(Coordinator c, long worker, int tile) {
        return deliver(c, worker, tile, SimTile.right(tile));
    }

    private List<Action> deliver(Coordinator c, long worker, int tile, TileData data) {
        return c.handle(now, new Event.Delivered(worker, 0, tile, data));
    }

    private static <T extends Action> List<T> only(Class<T> kind, List<Action> actions) {
        return actions.stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    private static Action.Grant grant(List<Action> actions) {
        List<Action.Grant> grants = only(Action.Grant.class, actions);
        assertEquals(1, grants.size(), actions.toString());
        return grants.get(0);
    }

    private static String range(Action.Grant grant) {
        return grant.worker() + ": " + grant.first() + ".." + grant.last();
    }

    /** The worker delivers its lease at an even pace; returns the last actions. */
    private List<Action> work(Coordinator c, Action.Grant grant, long nanosPerTile) {
        List<Action> all = new ArrayList<>();
        for (int tile = grant.first(); tile < grant.last(); tile++) {
            now += nanosPerTile;
            all.addAll(deliver(c, grant.worker(), tile));
        }
        return all;
    }

    @Test
    void aNewWorkerGetsAProbeAtOnceAndThenLeasesOfItsSpeed() {
        Coordinator c = coordinator(10_000, 0);
        Deque<Action.Grant> todo = granted(join(c, 1, 1));
        assertEquals("1: 0..1", range(todo.getFirst()));
        // Ten tiles per second, leases of four seconds.
        workThrough(c, todo, 12, SECOND / 10);
        Action.Grant next = todo.getLast();
        assertEquals(40, next.last() - next.first(), 1);
    }

    private static Deque<Action.Grant> granted(List<Action> actions) {
        return new ArrayDeque<>(only(Action.Grant.class, actions));
    }

    /** The worker delivers that many leases in the order of their granting; what it is granted meanwhile comes after. */
    private void workThrough(Coordinator c, Deque<Action.Grant> todo, int leases, long nanosPerTile) {
        for (int i = 0; i < leases && !todo.isEmpty(); i++) {
            todo.addAll(granted(work(c, todo.removeFirst(), nanosPerTile)));
        }
    }

    private static Action.Grant grantOf(List<Action> actions, long worker) {
        return only(Action.Grant.class, actions).stream()
                .filter(g -> g.worker() == worker)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aLateJoinerIsProbedWithAQuarterOfALeaseOfWhatItsWeightPromises() {
        Coordinator c = coordinator(100_000, 0);
        workThrough(c, granted(join(c, 1, 1)), 7, SECOND / 10);
        // Worker 1 of weight 1 makes 10 tiles per second: 4 s of it are 40 tiles, and 3 times a quarter of that is 30.
        Action.Grant probe = grantOf(join(c, 2, 3), 2);
        assertEquals(30, probe.last() - probe.first(), 1);
    }

    @Test
    void noLeaseTakesMoreThanHalfOfAFairPartOfWhatIsFree() {
        Coordinator c = coordinator(100, 0);
        Deque<Action.Grant> todo = granted(join(c, 1, 1));
        Set<Integer> seen = new HashSet<>();
        int leases = 0;
        while (!todo.isEmpty()) {
            Action.Grant next = todo.removeFirst();
            leases++;
            for (int tile = next.first(); tile < next.last(); tile++) {
                assertTrue(seen.add(tile));
                int free = c.snapshot(now).free();
                now += SECOND / 1000;
                for (Action.Grant grant : granted(deliver(c, 1, tile))) {
                    assertTrue(grant.last() - grant.first() <= Math.max(1, free / 2), range(grant));
                    todo.add(grant);
                }
            }
        }
        assertEquals(100, seen.size());
        assertTrue(leases > 5 && leases < 40, "leases " + leases);
    }

    @Test
    void aClosedConnectionGivesItsTilesToTheOthersAtOnce() {
        Coordinator c = coordinator(1, 0);
        assertEquals("1: 0..1", range(grant(join(c, 1, 1))));
        assertEquals("2: 0..1", range(grant(join(c, 2, 1))), "a copy for the idle one");
        assertEquals(List.of(), only(Action.Grant.class, join(c, 3, 1)), "two copies at most");
        assertEquals("3: 0..1", range(grant(c.handle(now, new Event.Left(1, "reset")))));
    }

    @Test
    void aSilentWorkerIsHungUpOnAndItsTilesGoToOthers() {
        Coordinator c = coordinator(1, 0);
        grant(join(c, 1, 1));
        now += 5 * SECOND - 1;
        assertEquals(List.of(), c.handle(now, new Event.Tick()));
        now += 1;
        List<Action> actions = c.handle(now, new Event.Tick());
        assertEquals(List.of(new Action.HangUp(1, "silent for 5000 ms")), actions);
        assertEquals("2: 0..1", range(grant(join(c, 2, 1))));
    }

    @Test
    void aLeaseThatItsHolderDoesNotNameIsGivenOut() {
        Coordinator c = coordinator(1, 0);
        Action.Grant lost = grant(join(c, 1, 1));
        List<Action> actions = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            now += SECOND / 2;
            actions.addAll(c.handle(now, new Event.Heard(1, Set.of())));
            actions.addAll(c.handle(now, new Event.Tick()));
        }
        assertTrue(actions.contains(new Action.Cancel(1, lost.lease())));
        Action.Grant again = grant(actions);
        assertEquals("1: 0..1", range(again));
        assertNotEquals(lost.lease(), again.lease());
    }

    @Test
    void aNamedLeaseIsRenewedAndAnUnknownOneCancelled() {
        Coordinator c = coordinator(1, 0);
        Action.Grant held = grant(join(c, 1, 1));
        for (int i = 0; i < 40; i++) {
            now += SECOND / 2;
            c.handle(now, new Event.Heard(1, Set.of(held.lease())));
            assertEquals(List.of(), c.handle(now, new Event.Tick()));
        }
        List<Action> answer = c.handle(now, new Event.Heard(1, Set.of(held.lease(), 4711L)));
        assertEquals(List.of(new Action.Cancel(1, 4711), new Action.Answer(1, 0)), answer);
    }

    @Test
    void whoLivesButDeliversNothingIsNotWaitedForAndItsLateResultIsWelcome() {
        Coordinator c = coordinator(1, 0);
        Action.Grant held = grant(join(c, 1, 1));
        for (int i = 0; i < 119; i++) {
            now += SECOND / 2;
            c.handle(now, new Event.Heard(1, Set.of(held.lease())));
            c.handle(now, new Event.Tick());
        }
        assertEquals(0, c.snapshot(now).free());
        now += SECOND / 2;
        assertEquals(List.of(new Action.Cancel(1, held.lease())), c.handle(now, new Event.Tick()));
        assertEquals(1, c.snapshot(now).free());
        assertTrue(c.snapshot(now).workers().get(0).stalled());
        assertTrue(deliver(c, 1, 0).contains(new Action.Finish()));
    }

    @Test
    void oneLeaseIsPrefetchedWhenHalfOfTheFirstIsDone() {
        Coordinator c = coordinator(100_000, 0);
        Deque<Action.Grant> todo = granted(join(c, 1, 1));
        while (todo.size() != 1 || todo.getFirst().last() - todo.getFirst().first() < 39) {
            workThrough(c, todo, 1, SECOND / 10);
        }
        Action.Grant next = todo.getFirst();
        int tiles = next.last() - next.first();
        for (int i = 0; i < tiles; i++) {
            now += SECOND / 10;
            List<Action> actions = deliver(c, 1, next.first() + i);
            boolean isHalf = i + 1 == tiles - tiles / 2;
            assertEquals(isHalf ? 1 : 0, only(Action.Grant.class, actions).size(), "tile " + i + " of " + tiles);
        }
    }

    @Test
    void atTheEndHalfOfWhatIsNotBegunMovesToAnIdleWorker() {
        Coordinator c = coordinator(40, 0);
        // Slow probes, then leases that are too large for what comes.
        Deque<Action.Grant> todo = granted(join(c, 1, 1));
        while (c.snapshot(now).free() > 0) {
            workThrough(c, todo, 1, SECOND / 1000);
        }
        int before = c.snapshot(now).workers().get(0).owed();
        assertTrue(before > 1, "owes " + before);
        Action.Grant held = todo.getLast();
        int notBegun = Math.min(before - 1, held.last() - held.first());
        List<Action> actions = join(c, 2, 1);
        Action.Grant moved = grant(actions);
        assertEquals(
                List.of(new Action.Skip(1, held.lease(), moved.first(), moved.last())),
                only(Action.Skip.class, actions).stream().map(a -> (Action) a).toList());
        assertEquals(held.last(), moved.last());
        assertEquals((notBegun + 1) / 2, moved.last() - moved.first());
        assertEquals(
                before,
                c.snapshot(now).workers().stream()
                        .mapToInt(Snapshot.Worker::owed)
                        .sum());
    }

    @Test
    void whatIsInHandIsCopiedAndTheFirstResultWins() {
        Coordinator c = coordinator(2, 0);
        Deque<Action.Grant> mine = granted(join(c, 1, 1));
        assertEquals(2, mine.size());
        assertEquals("2: 1..2", range(grant(join(c, 2, 1))), "moved");
        assertEquals("3: 0..1", range(grant(join(c, 3, 1))), "copied");
        List<Action> first = deliver(c, 3, 0);
        assertTrue(first.contains(new Action.Keep(0, Peers.machine("m3"), SimTile.right(0))));
        assertTrue(first.contains(new Action.Skip(1, mine.getFirst().lease(), 0, 1)));
        List<Action> second = deliver(c, 1, 0);
        assertEquals(List.of(), only(Action.Keep.class, second));
        assertTrue(second.contains(new Action.Confirm(0, Peers.machine("m1"))));
        assertTrue(second.contains(new Action.Acknowledge(1, 0)));
    }

    @Test
    void aMismatchIsDecidedByTheServerAndTheLiarsTilesAreRedone() {
        Coordinator c = auditing(0, 4);
        join(c, 1, 1);
        deliver(c, 1, 0, SimTile.wrong(0, 1));
        deliver(c, 1, 1);
        join(c, 2, 1);
        List<Action> dispute = deliver(c, 2, 0);
        assertEquals(List.of(), only(Action.Expel.class, dispute));
        assertTrue(dispute.contains(new Action.CallLocal(0)), dispute.toString());
        List<Action.Grant> asked = only(Action.Grant.class, join(c, 3, 1));
        assertTrue(asked.stream().noneMatch(g -> g.first() == 0), "no other machine is asked: " + asked);
        assertEquals("4: 0..1", range(only(Action.Grant.class, joinLocal(c, 4)).get(0)));
        List<Action> decided = deliver(c, 4, 0);
        assertTrue(decided.contains(new Action.Keep(0, Origin.SERVER, SimTile.right(0))), decided.toString());
        assertTrue(decided.contains(new Action.Confirm(0, Origin.SERVER)));
        assertEquals(
                Peers.machine("m1"), only(Action.Expel.class, decided).get(0).machine());
        assertEquals(1, only(Action.Expel.class, decided).size(), "the honest one stays");
        assertTrue(decided.contains(new Action.Revoke(1)));
        assertEquals(1, only(Action.Refuse.class, decided).size());
        List<Action> back = c.handle(now, Peers.joined(9, "m1-again", "m1", 1, 1));
        assertEquals(1, only(Action.Refuse.class, back).size());
        assertEquals(Set.of(Peers.machine("m1").toString()), c.snapshot(now).expelled());
    }

    @Test
    void aPictureWithADisputeIsNotDoneBeforeTheServerHasDecided() {
        Coordinator c = coordinator(1, 0);
        join(c, 1, 1);
        join(c, 2, 1);
        deliver(c, 1, 0);
        assertTrue(c.isFinished(), "nobody disputes");
        Coordinator d = auditing(0, 2);
        join(d, 1, 1);
        join(d, 2, 1);
        deliver(d, 1, 0, SimTile.wrong(0, 1));
        deliver(d, 2, 0);
        List<Action> last = deliver(d, 2, 1);
        assertTrue(last.contains(new Action.CallLocal(0)), last.toString());
        assertFalse(d.isFinished());
        assertEquals("3: 0..1", range(grant(joinLocal(d, 3))));
        List<Action> decided = deliver(d, 3, 0);
        assertEquals(
                Peers.machine("m1"), only(Action.Expel.class, decided).get(0).machine());
        assertTrue(decided.contains(new Action.Finish()), decided.toString());
    }

    @Test
    void whoeverTakesManyNamesCannotOutvoteAnHonestMachine() {
        Coordinator c = auditing(0, 4);
        join(c, 1, 1);
        deliver(c, 1, 0);
        // The first is asked, the others are not.
        for (int liar = 2; liar < 12; liar++) {
            join(c, liar, 1);
            List<Action> said = deliver(c, liar, 0, SimTile.wrong(0, 1));
            assertEquals(List.of(), only(Action.Expel.class, said));
            assertEquals(List.of(), only(Action.Keep.class, said));
        }
        joinLocal(c, 20);
        Set<Origin.Peer> expelled = new HashSet<>();
        only(Action.Expel.class, deliver(c, 20, 0)).forEach(e -> expelled.add(e.machine()));
        assertEquals(Set.of(Peers.machine("m2")), expelled);
    }

    @Test
    void whatTwoLiarsConfirmedFallsWithThem() {
        Coordinator c = auditing(0, 3);
        join(c, 1, 1);
        join(c, 2, 1);
        deliver(c, 1, 0, SimTile.wrong(0, 1));
        List<Action> agreed = deliver(c, 2, 0, SimTile.wrong(0, 1));
        assertEquals(List.of(new Action.Confirm(0, Peers.machine("m2"))), only(Action.Confirm.class, agreed));
        c.handle(now, new Event.Misbehaved(1, "nonsense"));
        assertEquals(1, c.snapshot(now).done(), "the other one's word is left");
        assertEquals(0, c.snapshot(now).confirmed());
        assertTrue(c.handle(now, new Event.Misbehaved(2, "nonsense")).contains(new Action.Revoke(0)));
        assertEquals(0, c.snapshot(now).done());
    }

    @Test
    void theServersOwnThreadsAreNeverExpelledReplacedOrHungUpOn() {
        Coordinator c = coordinator(2, 0);
        joinLocal(c, 1);
        now += 100 * SECOND;
        List<Action> late = c.handle(now, new Event.Tick());
        assertEquals(List.of(), only(Action.HangUp.class, late));
        assertEquals(1, c.snapshot(now).workers().size());
        int liar = 10;
        int asked = 0;
        for (String name : new String[] {"local", "", "this process", "the server", "null"}) {
            List<Action> actions = c.handle(now, Peers.joined(++liar, name, name, 1, 1));
            assertEquals(List.of(), only(Action.HangUp.class, actions), name);
            asked += granted(actions).stream().anyMatch(g -> g.first() == 0) ? 1 : 0;
            deliver(c, liar, 0, SimTile.wrong(0, liar));
        }
        assertEquals(List.of(), only(Action.Expel.class, c.handle(now, new Event.Misbehaved(1, "nonsense"))));
        deliver(c, 1, 0);
        assertTrue(asked > 0, "somebody was asked");
        assertEquals(asked, c.snapshot(now).expelled().size(), "who was asked and contradicts the server");
        assertTrue(deliver(c, 1, 1).contains(new Action.Finish()));
    }

    @Test
    void everyTileOfAMachineThatHasNotComputedTheCanaryIsAudited() {
        Coordinator c = coordinator(3, 0);
        ContentHash process = ContentHash.of(new byte[1]);
        c.handle(now, new Event.Joined(1, process, Peers.machine("new"), true, "new", 1, 1));
        deliver(c, 1, 0);
        deliver(c, 1, 1, SimTile.wrong(1, 1));
        assertEquals(2, c.snapshot(now).auditsOpen());
        assertEquals("2: 0..1", range(only(Action.Grant.class, join(c, 2, 1)).get(0)));
    }

    @Test
    void whoContradictsItselfIsExpelled() {
        Coordinator c = coordinator(5, 0);
        join(c, 1, 1);
        deliver(c, 1, 0);
        List<Action> actions = deliver(c, 1, 0, SimTile.wrong(0, 1));
        assertEquals(
                Peers.machine("m1"), only(Action.Expel.class, actions).get(0).machine());
        assertTrue(actions.contains(new Action.Revoke(0)));
    }

    @Test
    void aTileOutOfRangeExpelsItsSender() {
        Coordinator c = coordinator(5, 0);
        join(c, 1, 1);
        assertEquals(1, only(Action.Expel.class, deliver(c, 1, 5)).size());
    }

    @Test
    void everyTileIsAuditedAtARateOfOneAndNoneAtZero() {
        for (double rate : new double[] {0, 1}) {
            Coordinator c = coordinator(30, rate);
            List<Action> todo = new ArrayList<>(join(c, 1, 1));
            todo.addAll(join(c, 2, 1));
            int audits = 0;
            while (!todo.isEmpty()) {
                Action action = todo.remove(0);
                if (action instanceof Action.Grant g) {
                    now += SECOND;
                    todo.addAll(work(c, g, SECOND / 100));
                }
                audits += action instanceof Action.Confirm ? 1 : 0;
            }
            assertTrue(c.isFinished());
            if (rate == 1) {
                assertEquals(30, audits);
            }
        }
    }

    @Test
    void theShareOfAuditedTilesIsTheRateAndTheSameInEveryRun() {
        int chosen = 0;
        for (int tile = 0; tile < 100_000; tile++) {
            chosen += Audits.isChosen(0.02, SALT, tile) ? 1 : 0;
        }
        // Binomial: 2000 with a standard deviation of 44.
        assertEquals(2_000, chosen, 5 * 44);
        assertFalse(Audits.isChosen(0, 5, 5));
        assertTrue(Audits.isChosen(1, 5, 5));
    }

    @Test
    void whatWasRestoredIsNotRenderedAgainAndOldLeasesStillBringTiles() {
        Restored restored = new Restored(
                List.of(new Restored.Tile(
                        0, Peers.machine("m1"), SimTile.right(0).hash(), null)),
                Set.of(Peers.machine("m7")));
        Coordinator c = new Coordinator(settings(3, 0), restored, now);
        assertEquals("1: 1..2", range(grantOf(join(c, 1, 1), 1)));
        List<Action> old = c.handle(now, new Event.Delivered(1, 123_456, 2, SimTile.right(2)));
        assertTrue(old.contains(new Action.Keep(2, Peers.machine("m1"), SimTile.right(2))));
        assertEquals(1, only(Action.Refuse.class, join(c, 7, 1)).size());
        assertTrue(deliver(c, 1, 1).contains(new Action.Finish()));
    }

    @Test
    void aNewConnectionOfTheSameWorkerReplacesTheOldOne() {
        Coordinator c = coordinator(1, 0);
        grant(join(c, 1, 1));
        List<Action> actions = c.handle(now, Peers.joined(2, "m1", "m1", 1, 1));
        assertEquals(
                List.of(new Action.HangUp(1, "the same worker has a newer connection")),
                only(Action.HangUp.class, actions).stream().map(a -> (Action) a).toList());
        assertEquals("2: 0..1", range(grant(actions)));
    }

    @Test
    void tilesAreGivenAwayWhenTheyAreOffered() {
        Coordinator c = new Coordinator(settings(40, 0).withOffered(10), Restored.NOTHING, now);
        join(c, 1, 1);
        Set<Integer> given = new HashSet<>();
        for (int tile = 0; tile < 10; tile++) {
            now += SECOND / 100;
            only(Action.Grant.class, deliver(c, 1, tile)).forEach(g -> {
                for (int t = g.first(); t < g.last(); t++) {
                    given.add(t);
                }
            });
        }
        assertTrue(given.stream().allMatch(t -> t < 10), given.toString());
        assertFalse(c.isFinished());
        // What nobody asked for does not count, and is asked for later.
        assertEquals(List.of(), only(Action.Keep.class, deliver(c, 1, 12)));
        List<Action.Grant> grants = new ArrayList<>(only(Action.Grant.class, c.handle(now, new Event.Offered(40))));
        assertFalse(grants.isEmpty());
        for (int k = 0; k < grants.size(); k++) {
            for (int tile = grants.get(k).first(); tile < grants.get(k).last(); tile++) {
                now += SECOND / 100;
                grants.addAll(only(Action.Grant.class, deliver(c, 1, tile)));
            }
        }
        assertTrue(c.isFinished());
    }

    @Test
    void whatIsForgottenIsDoneAgainAndOldVotesOnItDoNotCount() {
        Coordinator c = coordinator(4, 1);
        join(c, 1, 1);
        for (int tile = 0; tile < 3; tile++) {
            deliver(c, 1, tile);
        }
        c.handle(now, new Event.Forgotten(0, 2));
        assertEquals(1, c.snapshot(now).done());
        // The first word again: another than before is no contradiction.
        assertEquals(
                1, only(Action.Keep.class, deliver(c, 1, 0, SimTile.right(3))).size());
        assertEquals(0, only(Action.Expel.class, deliver(c, 1, 1)).size());
        assertEquals(3, c.snapshot(now).done());
    }

    @Test
    void theSnapshotCountsAndEstimates() {
        Coordinator c = coordinator(1_000, 0);
        assertTrue(c.snapshot(now).remainingSeconds().isEmpty());
        workThrough(c, granted(join(c, 1, 1)), 6, SECOND / 10);
        Snapshot s = c.snapshot(now + SECOND);
        assertEquals(1_000, s.done() + s.leased() + s.free());
        assertEquals(s.leased(), s.workers().get(0).owed());
        assertEquals(s.done(), s.workers().get(0).tiles());
        assertEquals(10, s.workers().get(0).tilesPerSecond().orElseThrow(), 1e-6);
        assertEquals((1_000 - s.done()) / 10.0, s.remainingSeconds().orElseThrow(), 1e-3);
        assertEquals(1, s.workers().get(0).silentSeconds(), 1e-9);
        assertEquals("m1 joined with 1 threads", s.notes().get(0).text());
    }
}
