package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Sampler.Purpose;
import org.junit.jupiter.api.Test;

/** The numbers of a pixel's samples: stratified within it, independent between addresses and pixels. */
class SobolSamplerTest {
    private final SobolSampler sampler = new SobolSampler();
    private final double[] point = new double[2];

    /** Sixteen points: one in each of the boxes of every dyadic shape. */
    private static void checkNet(double[][] points, String what) {
        for (int columns = 1; columns <= points.length; columns *= 2) {
            boolean[] seen = new boolean[points.length];
            int rows = points.length / columns;
            for (double[] p : points) {
                int box = (int) (columns * p[0]) * rows + (int) (rows * p[1]);
                assertTrue(!seen[box], what + ": two in one box of " + columns + " × " + rows);
                seen[box] = true;
            }
        }
    }

    @Test
    void theSamplesOfAPixelAreStratifiedForEveryPurposeOfTheFirstBounces() {
        for (int pixel = 0; pixel < 20; pixel++) {
            sampler.pixel(3, pixel, 7);
            double[][] film = new double[16][];
            double[][] directions = new double[16][];
            double[][] lights = new double[64][];
            for (int s = 0; s < 16; s++) {
                sampler.sample(s);
                film[s] = new double[] {sampler.filmX(), sampler.filmY()};
                sampler.pair(pixel % 2, Purpose.DIRECTION, point);
                directions[s] = point.clone();
                sampler.lightPoints(1, pixel, 4);
                for (int k = 0; k < 4; k++) {
                    lights[4 * s + k] = new double[] {sampler.lightX(k), sampler.lightY(k)};
                }
            }
            checkNet(film, "film");
            checkNet(directions, "directions");
            checkNet(lights, "lights");
        }
    }

    @Test
    void numbersOfDifferentAddressesAreIndependent() {
        // Of 8 × 8 fields of (number here, number there), over many pixels, none is preferred.
        int[] purposes = new int[64];
        int[] bounces = new int[64];
        int[] ofFilm = new int[64];
        int[] ofLight = new int[64];
        int[] units = new int[64];
        for (int pixel = 0; pixel < 20_000; pixel++) {
            sampler.pixel(11, pixel % 200, pixel / 200);
            sampler.sample(5);
            sampler.pair(2, Purpose.DIRECTION, point);
            int here = 8 * (int) (8 * point[0]);
            ofFilm[here + (int) (8 * sampler.filmX())]++;
            sampler.lightPoints(0, 2, 1);
            ofLight[here + (int) (8 * sampler.lightX(0))]++;
            units[here + (int) (8 * sampler.unit(2, Purpose.DIRECTION))]++;
            sampler.pair(2, Purpose.CHOICE, point);
            purposes[here + (int) (8 * point[0])]++;
            sampler.pair(3, Purpose.DIRECTION, point);
            bounces[here + (int) (8 * point[0])]++;
        }
        ChiSquare.checkEven(purposes, "purposes");
        ChiSquare.checkEven(bounces, "bounces");
        ChiSquare.checkEven(ofFilm, "film");
        ChiSquare.checkEven(ofLight, "light");
        ChiSquare.checkEven(units, "units");
    }

    @Test
    void aNumberIsAFunctionOfItsAddress() {
        sampler.pixel(1, 4, 5);
        sampler.sample(3);
        double u = sampler.unit(7, Purpose.ROULETTE);
        sampler.pair(7, Purpose.ROULETTE, point);
        double x = point[0];
        sampler.sample(4);
        assertNotEquals(u, sampler.unit(7, Purpose.ROULETTE));
        sampler.pixel(1, 5, 5);
        sampler.sample(3);
        assertNotEquals(u, sampler.unit(7, Purpose.ROULETTE));
        sampler.pixel(1, 4, 5);
        sampler.pair(7, Purpose.ROULETTE, point);
        assertEquals(x, point[0]);
        assertEquals(u, sampler.unit(7, Purpose.ROULETTE));
    }
}
