package enlightenment.bsdf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The matrix of fluorescent surfaces against closed forms, sums over single nanometres, and what energy and Stokes allow. */
class ReradiationTest {
    private static final int R = 0;
    private static final int G = 1;
    private static final int B = 2;
    private static final int U = Reradiation.ULTRAVIOLET;

    /** Where the bands begin and end, in nanometres. */
    private static final double[] LOW = {580, 490, 400, 300};

    private static final double[] HIGH = {780, 580, 490, 400};

    @Test
    void aTypicalDyeHasTheElementsOfTheDesign() {
        Reradiation dye = new Reradiation(320, 450, 500, 600, 0.9);
        double[] color = {0.6, 0.5, 0.2};
        assertEquals(0.346234, 0.9 * dye.share(G, U), 1e-6, "of an ultraviolet reflectance of 0.1");
        assertEquals(0.079086, dye.share(R, U) * 0.9, 1e-6);
        assertEquals(0.252314, dye.element(G, B, color), 1e-6);
        assertEquals(0.057633, dye.element(R, B, color), 1e-6);
        assertEquals(0.509947, columnSum(dye, B, color), 1e-6);
        assertEquals(0.52532, 0.1 + 0.9 * (dye.share(G, U) + dye.share(R, U)), 1e-6);
        for (int from = 0; from < Reradiation.BANDS; from++) {
            for (int to = 0; to < Reradiation.BANDS; to++) {
                if (to == from) {
                    assertEquals(color[Math.min(from, B)], dye.element(to, from, color), 0);
                } else if (from < B || to == B) {
                    assertEquals(0, dye.element(to, from, color), 0);
                }
            }
        }
    }

    @Test
    void fromOneBandToOneOtherThereIsAClosedForm() {
        Reradiation dye = new Reradiation(300, 400, 490, 580, 1);
        assertEquals(350 * Math.log(580.0 / 490) / 90, dye.share(G, U), 1e-12);
        assertEquals(0.655755, dye.share(G, U), 1e-6);
        Reradiation blueToRed = new Reradiation(410, 470, 600, 700, 0.7);
        assertEquals(0.7 * 60 / 90 * 440 * Math.log(700.0 / 600) / 100, blueToRed.share(R, B), 1e-12);
        assertEquals(0, blueToRed.share(G, B), 0);
        assertEquals(0, blueToRed.share(R, U), 0);
    }

    @Test
    void aDyeWithoutYieldOrOnlyShorterWavesToGiveIsIdle() {
        assertTrue(new Reradiation(320, 450, 500, 600, 0).isIdle(true));
        assertTrue(new Reradiation(500, 600, 300, 450, 1).isIdle(true));
        Reradiation black = new Reradiation(300, 390, 500, 600, 1);
        assertTrue(black.isIdle(false));
        assertFalse(black.isIdle(true));
        assertFalse(new Reradiation(300, 410, 500, 600, 1).isIdle(false));
    }

    @Test
    void singleNanometresAddUpToTheSameWhereverBandsOverlap() {
        SplittableRandom random = new SplittableRandom(1);
        for (int n = 0; n < 40; n++) {
            double[] d = dye(random);
            Reradiation dye = new Reradiation(d[0], d[1], d[2], d[3], d[4]);
            for (int from = 0; from < Reradiation.BANDS; from++) {
                for (int to = 0; to < Reradiation.BANDS; to++) {
                    assertEquals(byNanometres(to, from, d), dye.share(to, from), 2e-3, "from " + from + " to " + to);
                }
            }
        }
    }

    /** Midpoints of quarters of nanometres, as far as they lie in the bands. */
    private static double byNanometres(int to, int from, double[] d) {
        double step = 0.25;
        double sum = 0;
        for (double at = LOW[from] + step / 2; at < HIGH[from]; at += step) {
            double low = Math.max(at, d[2]);
            double inner = 0;
            for (double wave = LOW[to] + step / 2; wave < HIGH[to] && low < d[3]; wave += step) {
                inner += at / wave * overlap(wave, step, low, d[3]);
            }
            sum += low < d[3] ? overlap(at, step, d[0], Math.min(d[1], d[3])) * inner / (d[3] - low) : 0;
        }
        return d[4] * sum / (HIGH[from] - LOW[from]);
    }

    private static double overlap(double middle, double length, double low, double high) {
        return Math.max(0, Math.min(middle + length / 2, high) - Math.max(middle - length / 2, low));
    }

    private static double[] dye(SplittableRandom random) {
        double a = random.nextDouble(300, 780);
        double b = random.nextDouble(300, 780);
        double c = random.nextDouble(300, 780);
        double d = random.nextDouble(300, 780);
        double width = 5;
        return new double[] {
            Math.min(a, b), Math.max(a, b) + width, Math.min(c, d), Math.max(c, d) + width, random.nextDouble()
        };
    }

    private static double columnSum(Reradiation dye, int from, double[] color) {
        double sum = 0;
        for (int to = 0; to < Reradiation.BANDS; to++) {
            sum += dye.element(to, from, color);
        }
        return sum;
    }

    @Test
    void noMoreLightLeavesThanCameAndNeverWithShorterWaves() {
        assertPhysical(3_000);
    }

    @Tag("full")
    @Test
    void nowhereDoesMoreLightLeaveThanCame() {
        assertPhysical(100_000);
    }

    private static void assertPhysical(int materials) {
        SplittableRandom random = new SplittableRandom(2);
        double[] color = new double[3];
        for (int n = 0; n < materials; n++) {
            double[] d = dye(random);
            double yield = n % 3 == 0 ? 1 : d[4];
            Reradiation dye = new Reradiation(d[0], d[1], d[2], d[3], yield);
            for (int c = 0; c < 3; c++) {
                color[c] = n % 5 == 0 ? 0 : random.nextDouble();
            }
            for (int from = 0; from < Reradiation.BANDS; from++) {
                double sum = columnSum(dye, from, color);
                assertTrue(sum <= 1 + 1e-12 && sum >= color[Math.min(from, B)], "column " + from + ": " + sum);
                for (int to = 0; to < Reradiation.BANDS; to++) {
                    assertTrue(dye.element(to, from, color) >= 0);
                    assertTrue(to <= from || dye.element(to, from, color) == 0);
                }
            }
        }
    }

    @Test
    void vectorsAndRowsAreMultipliedByTheElements() {
        Reradiation dye = new Reradiation(310, 560, 430, 700, 0.8);
        double[] color = {0.6, 0.5, 0.2};
        double[] light = {0.3, 0.7, 1.1, 5};
        double[] rows = {1, 0, 0, 0, 0, 1, 0, 0, 0.2, 0.3, 0.4, 0.5};
        double[] leaves = light.clone();
        double[] worth = rows.clone();
        dye.scatter(color, leaves);
        dye.adjoin(color, worth);
        for (int to = 0; to < Reradiation.BANDS; to++) {
            double sum = 0;
            for (int from = 0; from < Reradiation.BANDS; from++) {
                sum += dye.element(to, from, color) * light[from];
            }
            assertEquals(sum, leaves[to], 1e-15);
        }
        for (int row = 0; row < 3; row++) {
            for (int from = 0; from < Reradiation.BANDS; from++) {
                double sum = 0;
                for (int to = 0; to < Reradiation.BANDS; to++) {
                    sum += rows[4 * row + to] * dye.element(to, from, color);
                }
                assertEquals(sum, worth[4 * row + from], 1e-15);
            }
        }
    }

    @Test
    void extremesOfWavelengthsGiveNumbers() {
        double[][] dyes = {
            {300, 780, 300, 780, 1},
            {300, 300, 780, 780, 1},
            {779, 780, 300, 780, 1},
            {300, 300.0000001, 779.9999, 780, 1},
        };
        for (double[] d : dyes) {
            Reradiation dye = new Reradiation(d[0], d[1], d[2], d[3], d[4]);
            for (int from = 0; from < Reradiation.BANDS; from++) {
                for (int to = 0; to < Reradiation.BANDS; to++) {
                    double share = dye.share(to, from);
                    assertTrue(share >= 0 && share <= 1, d[0] + ".." + d[1] + ": " + share);
                }
            }
        }
    }
}
