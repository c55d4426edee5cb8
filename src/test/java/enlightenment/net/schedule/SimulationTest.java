package enlightenment.net.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The coordinator among machines and networks that fail: whole renders in simulated time, repeatable by their seeds. */
class SimulationTest {
    private static final int SCHEDULES = 1_500;

    /** What happened in many schedules. */
    private record Sum(
            int crashes,
            int restarts,
            int partitions,
            int freezes,
            int expulsions,
            long events,
            List<String> complaints) {}

    private static Sum runAll(long firstSeed, int count) {
        int crashes = 0;
        int restarts = 0;
        int partitions = 0;
        int freezes = 0;
        int expulsions = 0;
        long events = 0;
        List<String> complaints = new ArrayList<>();
        for (long seed = firstSeed; seed < firstSeed + count; seed++) {
            SimSchedule schedule = new SimSchedule(seed).run();
            crashes += schedule.crashes;
            restarts += schedule.server.restarts;
            partitions += schedule.partitions;
            freezes += schedule.freezes;
            expulsions += schedule.server.expulsions;
            events += schedule.world.events;
            for (String complaint : schedule.complaints()) {
                complaints.add("seed " + seed + ": " + complaint);
            }
        }
        return new Sum(crashes, restarts, partitions, freezes, expulsions, events, complaints);
    }

    private static void check(Sum sum, int schedules) {
        assertEquals(List.of(), sum.complaints.stream().limit(20).toList());
        // The schedules must be worth their name.
        assertTrue(sum.crashes > schedules / 4, sum.toString());
        assertTrue(sum.restarts > schedules / 4, sum.toString());
        assertTrue(sum.partitions > schedules / 4, sum.toString());
        assertTrue(sum.freezes > schedules / 8, sum.toString());
        assertTrue(sum.expulsions > schedules / 100, sum.toString());
    }

    @Test
    void nothingIsLostDoubledOrWrongAndEveryRenderEndsWhateverFails() {
        check(runAll(1, SCHEDULES), SCHEDULES);
    }

    @Test
    @Tag("full")
    void nothingIsLostDoubledOrWrongInAHundredThousandSchedules() {
        Sum sum = runAll(1_000_000, 100_000);
        check(sum, 100_000);
    }

    @Test
    void theSimulationFindsTheRendersThatHangIfHeartbeatsDoNotNameTheirLeases() {
        boolean isHung = false;
        for (long seed = 1; seed <= 300 && !isHung; seed++) {
            isHung = !new SimSchedule(seed, true).run().ended;
        }
        assertTrue(isHung, "no schedule hung");
    }

    @Test
    void whoKnowsTheTokenAndMeansHarmGetsNobodyElseExpelledAndCannotKeepARenderFromEnding() {
        checkWithIntruders(250);
    }

    @Test
    @Tag("full")
    void whoMeansHarmGetsNobodyElseExpelledInEightHundredSchedules() {
        checkWithIntruders(800);
    }

    private static void checkWithIntruders(int schedules) {
        int expulsions = 0;
        List<String> complaints = new ArrayList<>();
        for (long seed = 1; seed <= schedules; seed++) {
            SimSchedule schedule = new SimSchedule(seed).withIntruder().run();
            expulsions += schedule.server.expulsions;
            for (String complaint : schedule.complaints()) {
                complaints.add("seed " + seed + ": " + complaint);
            }
        }
        assertEquals(List.of(), complaints.stream().limit(20).toList());
        assertTrue(expulsions > schedules / 2, "only " + expulsions + " expulsions");
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        checkRepeats(15);
    }

    @Test
    @Tag("full")
    void theSameSeedGivesTheSameRunFiftyTimes() {
        checkRepeats(50);
    }

    private static void checkRepeats(int seeds) {
        for (long seed = 1; seed <= seeds; seed++) {
            SimSchedule once = new SimSchedule(seed).run();
            SimSchedule again = new SimSchedule(seed).run();
            assertEquals(once.world.elapsed(), again.world.elapsed());
            assertEquals(once.world.events, again.world.events);
            assertEquals(once.server.atEnd, again.server.atEnd);
        }
    }
}
