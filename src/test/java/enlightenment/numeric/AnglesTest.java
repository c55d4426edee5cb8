package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class AnglesTest {
    @Test
    void anglesAgreeWithTheExactOnesAllTheWayRound() {
        for (int i = -20_000; i <= 20_000; i++) {
            double phi = Math.PI * i / 20_000;
            double x = 3 * StrictMath.cos(phi);
            double y = 3 * StrictMath.sin(phi);
            double exact = StrictMath.atan2(y, x);
            assertEquals(exact, Angles.atan2(y, x), 4 * Math.ulp(exact), "at " + phi);
        }
    }

    @Test
    void theAxesAndTheOriginAreExact() {
        assertEquals(0, Angles.atan2(0, 0));
        assertEquals(0, Angles.atan2(0, 2));
        assertEquals(Math.PI, Angles.atan2(0, -2));
        assertEquals(Math.PI / 2, Angles.atan2(5, 0));
        assertEquals(-Math.PI / 2, Angles.atan2(-5, 0));
        assertEquals(Math.PI / 4, Angles.atan2(1e-300, 1e-300));
    }
}
