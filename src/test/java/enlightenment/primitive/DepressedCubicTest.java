package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Roots of cubics without square term, built from their roots. */
class DepressedCubicTest {
    private static final double FINE = 1e-16;

    @Test
    void threeRootsAreFoundInOrder() {
        double[][] roots = {{-3, 1, 2}, {-2, -1, 3}, {-1, 0, 1}, {-1e-3, -1, 1.001}, {-1, -1e-12, 1 + 1e-12}};
        for (double[] given : roots) {
            double[] r = given.clone();
            Arrays.sort(r);
            double p = r[0] * r[1] + r[1] * r[2] + r[2] * r[0];
            double q = -r[0] * r[1] * r[2];
            double turn = DepressedCubic.turn(p);
            assertTrue(DepressedCubic.hasThreeRoots(q, turn));
            assertEquals(r[0], DepressedCubic.smallest(p, q, turn, FINE), 1e-14);
            assertEquals(r[1], DepressedCubic.middle(p, q, turn, FINE), 1e-14);
            assertEquals(r[2], DepressedCubic.largest(p, q, turn, FINE), 1e-14);
        }
    }

    @Test
    void aDoubleRootIsFoundToTheSquareRootOfThePrecision() {
        // (s − 1)²(s + 2)
        double turn = DepressedCubic.turn(-3);
        assertEquals(1, turn);
        assertTrue(DepressedCubic.hasThreeRoots(2, turn));
        assertEquals(1, DepressedCubic.largest(-3, 2, turn, FINE), 3e-8);
        assertEquals(1, DepressedCubic.middle(-3, 2, turn, FINE), 3e-8);
        assertEquals(-2, DepressedCubic.smallest(-3, 2, turn, FINE), 1e-15);
    }

    @Test
    void theOnlyRootIsFoundWithinTheLimitAndClippedBeyondIt() {
        // (s − 2)(s² + 2s + 5) = s³ + s − 10, and one that falls in between: (s − 3)(s² + 3s + 4) = s³ − 5s − 12
        assertFalse(DepressedCubic.hasThreeRoots(-12, DepressedCubic.turn(-5)));
        assertEquals(2, DepressedCubic.only(1, -10, 8, FINE), 1e-15);
        assertEquals(-2, DepressedCubic.only(1, 10, 8, FINE), 1e-15);
        assertEquals(3, DepressedCubic.only(-5, -12, 8, FINE), 1e-15);
        assertEquals(1.5, DepressedCubic.only(-5, -12, 1.5, FINE));
        assertEquals(0, DepressedCubic.only(1, 0, 8, FINE));
        assertEquals(1e-12, DepressedCubic.only(1, -1e-12, 8, 0), 1e-27);
    }
}
