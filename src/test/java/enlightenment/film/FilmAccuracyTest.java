package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Hash;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What a film loses: nothing that shows after a billion samples (numerics, N35 and N36). */
class FilmAccuracyTest {
    private static final MathContext DIGITS = new MathContext(40);
    private static final int LOW_BITS = 24;

    private static void checkMeans(int n) {
        FilmTile tile = new FilmTile(0, 0, 1, 1);
        // The uniform numbers are multiples of 2^-53: their exact sum is kept in two integers.
        long high = 0;
        long low = 0;
        for (int i = 0; i < n; i++) {
            long bits = Hash.mix(i) >>> 11;
            high += bits >>> LOW_BITS;
            low += bits & (1L << LOW_BITS) - 1;
            tile.add(0, 0, 0.1, 1, bits * 0x1p-53);
        }
        BigInteger sum = BigInteger.valueOf(high).shiftLeft(LOW_BITS).add(BigInteger.valueOf(low));
        BigDecimal exact = new BigDecimal(sum).multiply(new BigDecimal(0x1p-53)).divide(BigDecimal.valueOf(n), DIGITS);
        assertEquals((long) n, tile.count(0, 0));
        checkMean(new BigDecimal(0.1), tile.mean(0, 0, 0));
        assertEquals(1, tile.mean(0, 0, 1));
        checkMean(exact, tile.mean(0, 0, 2));
    }

    private static void checkMean(BigDecimal exact, double mean) {
        double error =
                new BigDecimal(mean).subtract(exact).divide(exact, DIGITS).abs().doubleValue();
        assertTrue(error <= 1e-15, mean + " is off by " + error);
    }

    /** After one sample of the brightness given, n dim ones: their sum must be kept to a millionth. */
    private static void checkFirefly(double bright, int n) {
        FilmTile tile = new FilmTile(0, 0, 1, 1);
        tile.add(0, 0, bright, 0, 0);
        for (int i = 0; i < n; i++) {
            tile.add(0, 0, 1e-5, 0, 0);
        }
        BigDecimal all = new BigDecimal(tile.mean(0, 0, 0)).multiply(BigDecimal.valueOf(n + 1L));
        double kept = all.subtract(new BigDecimal(bright)).doubleValue();
        double dim = n * 1e-5;
        assertEquals(dim, kept, dim * 1e-6);
    }

    @Test
    void theMeanOfTenMillionSamplesIsRight() {
        checkMeans(10_000_000);
    }

    @Tag("full")
    @Test
    void theMeanOfABillionSamplesIsRight() {
        checkMeans(1_000_000_000);
    }

    @Test
    void aFireflyDoesNotSwallowAMillionDimSamples() {
        checkFirefly(1e10, 1_000_000);
    }

    @Tag("full")
    @Test
    void aFireflyDoesNotSwallowAHundredMillionDimSamples() {
        checkFirefly(1e12, 100_000_000);
    }
}
