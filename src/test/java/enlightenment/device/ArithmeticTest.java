package enlightenment.device;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Devices that compute otherwise than Java are told from those that do not. */
class ArithmeticTest {
    private final double[] inputs = Arithmetic.inputs();
    private final double[] right = Arithmetic.results(inputs);

    /** Replaces one of the results of each calculation. */
    private double[] changed(int result, Calculation by) {
        double[] all = right.clone();
        for (int k = 0; k < inputs.length / Arithmetic.INPUTS; k++) {
            int at = Arithmetic.INPUTS * k;
            all[Arithmetic.RESULTS * k + result] = by.of(inputs[at], inputs[at + 1], inputs[at + 2]);
        }
        return all;
    }

    private interface Calculation {
        double of(double a, double b, double c);
    }

    private void assertRefused(double[] found, String part) {
        DeviceFailure e = assertThrows(DeviceFailure.class, () -> Arithmetic.check(inputs, found));
        assertTrue(e.getMessage().contains(part), e.getMessage());
    }

    @Test
    void javaComputesAsJavaDoes() {
        assertDoesNotThrow(() -> Arithmetic.check(inputs, right.clone()));
    }

    @Test
    void aDeviceThatFusesProductsWithSumsIsRefused() {
        assertRefused(changed(6, Math::fma), "a product and a sum");
    }

    @Test
    void aDeviceThatFusesNothingIsRefused() {
        assertRefused(changed(5, (a, b, c) -> a * b + c), "a fused product and sum");
    }

    @Test
    void aDeviceThatFlushesSubnormalNumbersIsRefused() {
        assertRefused(
                changed(2, (a, b, c) -> Math.abs(a * b) < Double.MIN_NORMAL ? 0 * (a * b) : a * b), "a product of");
    }

    @Test
    void aDeviceThatDividesByInversesIsRefused() {
        assertRefused(changed(3, (a, b, c) -> a * (1 / b)), "a quotient");
    }

    @Test
    void aDeviceThatTakesRootsInSinglePrecisionIsRefused() {
        assertRefused(changed(4, (a, b, c) -> (float) Math.sqrt(Math.abs(a))), "a root");
    }

    @Test
    void noNumberIsNoNumberWhateverItsBits() {
        double[] other = right.clone();
        int changes = 0;
        for (int k = 0; k < other.length; k++) {
            if (other[k] != other[k]) {
                other[k] = Double.longBitsToDouble(0x7FF8_0000_0000_1234L);
                changes++;
            }
        }
        assertTrue(changes > 0);
        assertDoesNotThrow(() -> Arithmetic.check(inputs, other));
    }
}
