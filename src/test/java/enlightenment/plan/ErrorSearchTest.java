package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Errors that are known functions of the number of samples. */
class ErrorSearchTest {
    private static final double MOST = 1 << 24;
    private static final double ROUNDED = 1 + 1e-12;

    private static double search(DoubleUnaryOperator error, double asked, double least, double most) {
        ErrorSearch search = new ErrorSearch(asked, least, most);
        double n = Math.min(Math.max(4, least), most);
        for (int k = 0; k < 7; k++) {
            search.found(n, error.applyAsDouble(n));
            if (search.isOver()) {
                break;
            }
            n = search.next();
            assertTrue(n >= least && n <= most);
        }
        return search.answer();
    }

    @Test
    void ofPowersTheAnswerKeepsTheErrorAndIsNotWasteful() {
        for (double slope : new double[] {0.5, 0.6, 0.75, 1}) {
            for (double asked = 0.2; asked > 1e-3; asked *= 0.7) {
                DoubleUnaryOperator error = n -> 0.3 * Math.pow(n, -slope);
                double found = error.applyAsDouble(search(error, asked, 1, MOST));
                assertTrue(found <= ROUNDED * asked && found > 0.75 * asked, slope + ": " + found + " for " + asked);
            }
        }
    }

    /** A survey that costs 1.27 per pixel: with 2.27 there is one sample each, and a few more make all the difference. */
    @Test
    void ofAFixedCostTheStepBehindItIsFound() {
        DoubleUnaryOperator error = n -> n < 2.3 ? 0.05 : 0.02 * Math.pow(n - 1.27, -0.9);
        for (double asked : new double[] {0.019, 0.01, 0.005, 0.001}) {
            double found = error.applyAsDouble(search(error, asked, 2.27, MOST));
            assertTrue(found <= asked, found + " for " + asked);
        }
        assertEquals(2.27, search(error, 0.06, 2.27, MOST));
    }

    /** Many pixels may take twice as many light points at the same number: only what was tried is known. */
    @Test
    void ofAStaircaseTheAnswerIsOnTheRightStep() {
        for (double step : new double[] {1.1, 1.5, 2}) {
            DoubleUnaryOperator error = n -> 0.3 / Math.pow(step, Math.floor(Math.log(n) / Math.log(step) + 1e-9));
            for (double asked = 0.2; asked > 1e-3; asked *= 0.7) {
                double found = error.applyAsDouble(search(error, asked, 1, MOST));
                assertTrue(
                        found <= ROUNDED * asked && found > 0.7 * asked / step, step + ": " + found + " for " + asked);
            }
        }
    }

    @Test
    void limitsAreKept() {
        assertEquals(100, search(n -> 1 / Math.sqrt(n), 1e-9, 1, 100));
        assertEquals(1, search(n -> 0, 0.1, 1, MOST));
        assertEquals(1, search(n -> 1 / Math.sqrt(n), 2, 1, MOST));
    }
}
