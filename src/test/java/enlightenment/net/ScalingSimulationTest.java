package enlightenment.net;

import static enlightenment.net.ScalingSimulation.ASSUMED;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.net.ScalingSimulation.Fleet;
import enlightenment.net.ScalingSimulation.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class ScalingSimulationTest {
    /** The paper's job: 900 minutes of one machine. */
    private static final double[] JOB = ScalingSimulation.unevenTiles(20_000, 240, 900 * 60);

    private static Outcome run(int workers, double spread, double crashesPerHour, double stragglers) {
        return ScalingSimulation.run(JOB, ASSUMED, new Fleet(workers, spread, crashesPerHour, stragglers), 0, 1);
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
    void aThousandMachinesDoTheWorkOfNineHundredAndFifty() {
        double[] job = ScalingSimulation.unevenTiles(200_000, 240, 900 * 60);
        double efficiency = ScalingSimulation.run(job, ASSUMED, new Fleet(1_000, 1, 0, 0), 0, 1)
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
        double[] job = ScalingSimulation.unevenTiles(600_000, 240, 10_000 * 300.0);
        double efficiency = ScalingSimulation.run(job, ASSUMED, new Fleet(10_000, 1, 0, 0), 0, 1)
                .efficiency();
        assertTrue(efficiency > 0.9, "efficiency " + efficiency);
    }
}
