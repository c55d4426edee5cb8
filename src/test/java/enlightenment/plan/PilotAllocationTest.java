package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Allocation by cells of 4 × 4 pixels, of half of the samples. */
class PilotAllocationTest {
    private static final int SIDE = 16;

    private static final RenderSettings.Crop BLOCK = new RenderSettings.Crop(32, 48, SIDE, SIDE);
    private static final List<PilotCell> CELLS = PilotCell.of(List.of(BLOCK));

    @Test
    void nothingIsGainedWhereAllPixelsVaryAlike() {
        double[] variance = new double[SIDE * SIDE];
        Arrays.fill(variance, 0.25);
        assertEquals(0.25, PilotAllocation.mean(variance, CELLS), 1e-12);
        assertEquals(0, PilotAllocation.mean(new double[SIDE * SIDE], CELLS));
    }

    /** A quarter of the pixels has all of the variance v: they have 1/2 + 1/2 · √v / (√v / 4) = 2.5 times the samples. */
    @Test
    void noisyCellsHaveMoreSamples() {
        double[] variance = new double[SIDE * SIDE];
        for (int i = 0; i < variance.length; i++) {
            variance[i] = i % SIDE < 8 && i / SIDE < 8 ? 3 : 0;
        }
        assertEquals(3.0 / 4 / 2.5, PilotAllocation.mean(variance, CELLS), 1e-12);
    }

    /** The samples go to the other colour of its cell, and half of them are left for it. */
    @Test
    void aSingleBrightPixelGainsNothingByHavingBeenSeen() {
        double[] variance = new double[SIDE * SIDE];
        variance[5 * SIDE + 6] = 7;
        assertEquals(2 * 7.0 / (SIDE * SIDE), PilotAllocation.mean(variance, CELLS), 1e-12);
    }

    /** Two blocks, the second cut by the edge of the picture to a column of five pixels: its last pixel is alone in its cell. */
    @Test
    void blocksThatThePictureCutsCountAllTheirPixels() {
        List<RenderSettings.Crop> blocks = List.of(BLOCK, new RenderSettings.Crop(64, 48, 1, 5));
        double[] variance = new double[SIDE * SIDE + 5];
        Arrays.fill(variance, SIDE * SIDE, SIDE * SIDE + 4, 2);
        double pixels = variance.length;
        // Four of the pixels vary, all in one cell.
        double samples = 0.5 + 0.5 / (4 / pixels);
        assertEquals(2 * 4 / pixels / samples, PilotAllocation.mean(variance, PilotCell.of(blocks)), 1e-12);
    }

    @Test
    void someCellsOfManyKindsGainSomething() {
        double[] variance = new double[SIDE * SIDE];
        double sum = 0;
        for (int i = 0; i < variance.length; i++) {
            variance[i] = 1 + i / (4 * SIDE) + i % SIDE / 4;
            sum += variance[i];
        }
        double allocated = PilotAllocation.mean(variance, CELLS);
        assertTrue(allocated < sum / variance.length);
        // With all samples by the roots of variances there would be the square of their mean.
        double root = Arrays.stream(variance).map(Math::sqrt).sum() / variance.length;
        assertTrue(allocated > root * root);
    }
}
