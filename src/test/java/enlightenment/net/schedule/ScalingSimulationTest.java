package enlightenment.net.schedule;

import static enlightenment.net.schedule.ScalingSimulation.MEASURED;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.schedule.ScalingSimulation.Fleet;
import enlightenment.net.schedule.ScalingSimulation.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class ScalingSimulationTest {
    /** The paper's job: 900 minutes of one machine. */
    private static final double[] JOB = ScalingSimulation.PAPERS.unitSeconds();

    private static Outcome run(int workers, double spread) {
        return ScalingSimulation.run(JOB, MEASURED, new Fleet(workers, spread, 0, 0), 0, 1);
    }

    @Test
    void oneWorkerIsAsFastAsTheMachineItself() {
        assertTrue(run(1, 1).efficiency() > 0.9999);
    }

    @Test
    void eightMachinesDoTheWorkOfEightBetterThanInThePaper() {
        double efficiency = run(8, 1).efficiency();
        assertTrue(efficiency > 0.996 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void machinesOfDifferentSpeedAreUsedAsWell() {
        double efficiency = run(8, 4).efficiency();
        assertTrue(efficiency > 0.996 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void eightMachinesAreBusyToTheEndThoughTheExpensivePartComesLast() {
        double[] job = ScalingSimulation.PAPERS.withExpensive(1).unitSeconds();
        double efficiency = ScalingSimulation.run(job, MEASURED, new Fleet(8, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.99 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void aThousandMachinesDoTheWorkOfNineHundredAndFiftyWhereThereArePixelsForThem() {
        assertBusy(ScalingSimulation.LARGE, 0);
    }

    /** Its tiles are made in passes: there are 5,000 blocks of pixels only, and without passes 0.58 would be busy. */
    @Test
    void aThousandMachinesDoTheWorkOfNineHundredAndFiftyForASmallPictureWithManySamples() {
        assertEquals(16 * 5_000, JOB.length);
        assertBusy(ScalingSimulation.PAPERS, 0);
    }

    @Test
    @Tag("full")
    void soItIsWithAuditsAndWhereTheExpensivePartComesLast() {
        assertBusy(ScalingSimulation.PAPERS, CoordinatorSettings.AUDIT_RATE);
        assertBusy(ScalingSimulation.PAPERS.withExpensive(1), 0);
    }

    private static void assertBusy(ScalingSimulation.Job job, double auditRate) {
        double efficiency = ScalingSimulation.run(job.unitSeconds(), MEASURED, new Fleet(1_000, 1, 0, 0), auditRate, 1)
                .efficiency();
        assertTrue(efficiency > 0.95 && efficiency <= 1, "efficiency " + efficiency + " of " + job);
    }

    @Test
    void crashesAndStragglersCostLittle() {
        // Of 100 machines a few crash, away for a minute of four, and about 5 straggle for half of the time: what is
        // left of the
        // power is 0.97, and the end waits for nobody, as a tile takes seconds and not minutes.
        Outcome outcome = ScalingSimulation.run(
                ScalingSimulation.LARGE.unitSeconds(), MEASURED, new Fleet(100, 4, 0.5, 0.05), 0, 1);
        assertTrue(outcome.crashes() > 0);
        assertTrue(outcome.efficiency() > 0.93, outcome.toString());
    }

    @Test
    void staticSharesAreAsGoodAsTheirMostExpensiveShare() {
        assertEquals(1, ScalingSimulation.efficiencyOfStaticShares(new double[] {1, 1, 1, 1}, 2), 1e-15);
        assertEquals(10.0 / 12, ScalingSimulation.efficiencyOfStaticShares(new double[] {1, 1, 2, 6, 0, 0}, 2), 1e-15);
    }

    @Test
    @Tag("full")
    void threeThousandMachinesAreStillBusy() {
        // Five minutes of work for each.
        double[] job = new ScalingSimulation.Job(8_000, 4_000, 15_000, 0.5).unitSeconds();
        double efficiency = ScalingSimulation.run(job, MEASURED, new Fleet(3_000, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.98, "efficiency " + efficiency);
    }
}
