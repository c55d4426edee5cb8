package enlightenment.net;

import static enlightenment.net.ScalingSimulation.MEASURED;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.ScalingSimulation.Fleet;
import enlightenment.net.ScalingSimulation.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class ScalingSimulationTest {
    /** The paper's job: 900 minutes of one machine. */
    private static final double[] JOB = ScalingSimulation.PAPERS.tileSeconds();

    private static Outcome run(int workers, double spread, double crashesPerHour, double stragglers) {
        return ScalingSimulation.run(JOB, MEASURED, new Fleet(workers, spread, crashesPerHour, stragglers), 0, 1);
    }

    @Test
    void oneWorkerIsAsFastAsTheMachineItself() {
        assertTrue(run(1, 1, 0, 0).efficiency() > 0.9999);
    }

    @Test
    void eightMachinesDoTheWorkOfEightBetterThanInThePaper() {
        double efficiency = run(8, 1, 0, 0).efficiency();
        assertTrue(efficiency > 0.996 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void machinesOfDifferentSpeedAreUsedAsWell() {
        double efficiency = run(8, 4, 0, 0).efficiency();
        assertTrue(efficiency > 0.996 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void eightMachinesAreBusyToTheEndThoughTheExpensivePartComesLast() {
        double[] job = ScalingSimulation.PAPERS.withExpensive(1).tileSeconds();
        double efficiency = ScalingSimulation.run(job, MEASURED, new Fleet(8, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.99 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void aThousandMachinesDoTheWorkOfNineHundredAndFiftyWhereThereArePixelsForThem() {
        double efficiency = ScalingSimulation.run(
                        ScalingSimulation.LARGE.tileSeconds(), MEASURED, new Fleet(1_000, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.95 && efficiency <= 1, "efficiency " + efficiency);
    }

    @Test
    void crashesAndStragglersCostLittle() {
        // Of 100 machines about 8 crash, away for a minute each of nine, and 5 straggle for half of the time: what is
        // left of the power is 0.97, and the end waits for nobody.
        Outcome outcome = run(100, 4, 0.5, 0.05);
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
    void tenThousandMachinesAreStillBusy() {
        // Five minutes of work for each.
        double[] job = new ScalingSimulation.Job(8_000, 4_000, 50_000, 0.5).tileSeconds();
        double efficiency = ScalingSimulation.run(job, MEASURED, new Fleet(10_000, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.9, "efficiency " + efficiency);
    }
}
