package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.TestScenes;
import enlightenment.scene.ClassicMethods;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;

/** Plans for a time, by a clock that ticks each time it is read: on one thread they do not depend on the machine. */
class TimePlannerTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().build();

    private static RenderPlan plan(Planner planner, long nanosPerReading) {
        AtomicLong clock = new AtomicLong();
        return planner.plan(new Stopwatch(() -> clock.getAndAdd(nanosPerReading)), 0);
    }

    private static Planner planner(Method method, double seconds) {
        return planner(method, RenderSettings.Budget.NONE.withSeconds(seconds));
    }

    private static Planner planner(Method method, RenderSettings.Budget budget) {
        RenderSettings settings = RenderSettings.of(SCENE)
                .withMethod(method)
                .withSize(64, 32)
                .withThreads(1)
                .withBudget(budget);
        CompiledScene compiled = SceneCompiler.compile(SCENE, settings);
        return new Planner(compiled, settings, () -> false);
    }

    /** What a plan costs is how often its clock can be read. */
    private static void assertPlans(Method method, long slow, long quick) {
        RenderPlan plan = plan(planner(method, 1), slow);
        assertEquals("time", plan.decidedBy());
        assertEquals(plan, plan(planner(method, 1), slow));
        assertTrue(plan.samples() > 1, plan.toString());
        assertTrue(plan(planner(method, 1), quick).samples() > plan.samples(), plan.toString());
    }

    @ParameterizedTest
    @ClassicMethods
    void theSameClockGivesTheSamePlanAndAFasterMachineMoreSamples(Method method) {
        assertPlans(method, 400_000, 100_000);
    }

    @ParameterizedTest
    @Tag("full")
    @ClassicMethods
    void soItIsOnMachinesTenTimesAsFast(Method method) {
        assertPlans(method, 100_000, 10_000);
    }

    /** Of a minute that nobody needs trials would take seconds, of an hour minutes. */
    @ParameterizedTest
    @ClassicMethods
    void aTimeThatIsFarMoreThanWhatIsAskedForCostsNoTrials(Method method) {
        for (RenderSettings.Budget asked :
                List.of(RenderSettings.Budget.NONE.withSamples(8), RenderSettings.Budget.NONE.withError(0.05))) {
            AtomicLong clock = new AtomicLong();
            Stopwatch time = new Stopwatch(() -> clock.getAndAdd(100_000));
            RenderPlan plan = planner(method, asked.withSeconds(60)).plan(time, 0);
            RenderPlan alone = planner(method, asked).plan(new Stopwatch(() -> 0), 0);
            assertEquals(alone, plan);
            assertTrue(clock.get() < 1_000_000_000L, plan + " after " + clock.get() / 1e9 + " s");
        }
    }

    @Test
    void whereThereIsNoTimeTheLeastIsTakenAndSaid() {
        Planner planner = planner(Method.RAYTRACE, 1);
        RenderPlan plan = plan(planner, 2_000_000_000L);
        assertEquals(1, plan.samples());
        assertEquals(1, planner.notes().size());
        assertTrue(planner.notes().get(0).contains("too short"), planner.notes().get(0));
    }
}
