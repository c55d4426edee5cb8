package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.SampledPicture.Function;
import enlightenment.sampling.Hash;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The variance of single samples, told by pixels of one or two of them, where it is known. */
class NeighboursTest {
    private static final int SIDE = 256;

    /** The mean over all pixels of what they tell. */
    private static double variance(Function function, int samples, long seed) {
        FilmTile tile = new FilmTile(0, 0, SIDE, SIDE);
        Random random = new Random(seed);
        SampleSpread spread = new SampleSpread();
        for (int k = 0; k < SIDE * SIDE; k++) {
            SampledPicture.sample(function, tile, k % SIDE, k / SIDE, samples, seed, random, spread);
        }
        Neighbours neighbours = new Neighbours(tile);
        double sum = 0;
        for (int k = 0; k < SIDE * SIDE; k++) {
            sum += neighbours.single(k % SIDE, k / SIDE);
        }
        return sum / (SIDE * SIDE);
    }

    /** Random grey squares of side 1 and variance 1/12. */
    static double texels(double x, double y) {
        return Hash.unit(Hash.of(17, (long) Math.floor(x), (long) Math.floor(y)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void ofNoiseItIsTheVarianceOfTheNoise(int samples) {
        // Pairs are about as many as pixels: √(2/65536) = 0.6 %, four of that and as much again for uneven weights.
        assertEquals(0.04, variance((x, y, noise) -> 0.5 + 0.2 * noise, samples, 1), 0.04 * 0.05);
    }

    /** Of two points of an interval of length w < 1 that borders 1 apart cut anywhere, 1 − w/3 are on the same side of them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aTextureAsFineAsThePixelsIsNotTakenForNoise(int samples) {
        double expected = (1 - (1 - 0.97 / 3) * (1 - 0.93 / 3)) / 12;
        double told = variance((x, y, noise) -> texels(0.97 * x, 0.93 * y), samples, 2);
        assertEquals(expected, told, 0.08 * expected);
        // Half the squared difference of neighbours is 1/12 and little less: what it was taken for.
        assertTrue(told < 0.75 / 12, "" + told);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void ofARampItIsATwelfthOfTheSquareOfItsSlope(int samples) {
        double expected = (0.01 * 0.01 + 0.02 * 0.02) / 12;
        assertEquals(expected, variance((x, y, noise) -> 0.01 * x - 0.02 * y, samples, 3), 0.05 * expected);
    }

    /** Of pixels left and right of a straight vertical edge at p only those that it cuts vary: p (1 − p). */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void ofEdgesItIsTheProductOfTheirParts(int samples) {
        // Edges 5.3 pixels apart are everywhere in pixels: the mean of p (1 − p) is 1/6, in one of 5.3 pixels.
        double expected = 1 / (6 * 5.3);
        double told = variance((x, y, noise) -> (int) (x / 5.3) % 2, samples, 4);
        assertEquals(expected, told, 0.06 * expected);
    }

    @Test
    void withoutPlacesOnlyThePixelItselfIsThere() {
        FilmTile tile = new FilmTile(0, 0, 1, 1);
        SampleSpread spread = new SampleSpread();
        spread.begin(2);
        for (int s = 0; s < 2; s++) {
            tile.add(0, 0, s, s, s);
            spread.at(0.25 + 0.5 * s, 0.25 + 0.5 * s);
            spread.add(s, s, s);
        }
        tile.spread(0, 0, spread);
        // Two samples 0 and 1: their variance is ½, that of their mean ¼.
        assertEquals(0.5, new Neighbours(tile).single(0, 0), 1e-7);
        assertEquals(0.25, tile.halves(0, 0), 1e-7);
        assertEquals(0.25, tile.quarters(0, 0), 1e-7);
    }
}
