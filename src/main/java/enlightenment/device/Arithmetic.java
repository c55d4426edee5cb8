package enlightenment.device;

import enlightenment.numeric.Angles;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * What a device must compute to the last bit before it is trusted with a picture: sums, products, quotients and roots of numbers of every
 * size down to subnormal ones, fused operations, and products that must not be fused with sums.
 */
public final class Arithmetic {
    /** Numbers that a calculation takes, and results that it gives. */
    public static final int INPUTS = 3;

    public static final int RESULTS = 10;

    private static final String[] NAMES = {
        "a sum",
        "a difference",
        "a product",
        "a quotient",
        "a root",
        "a fused product and sum",
        "a product and a sum",
        "a floor",
        "a hash",
        "an angle"
    };

    private static final int RANDOM = 4000;

    private static final double[] SPECIAL = {
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.1,
        1.0 / 3,
        Double.MIN_VALUE,
        -3 * Double.MIN_VALUE,
        0x1.fffffp-1023,
        Double.MIN_NORMAL,
        0x1p-600,
        0x1.8p600,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY
    };

    private Arithmetic() {}

    /** The numbers to calculate with, {@link #INPUTS} for each calculation. */
    public static double[] inputs() {
        int n = SPECIAL.length;
        double[] all = new double[INPUTS * (n * n + RANDOM)];
        int at = 0;
        for (double a : SPECIAL) {
            for (double b : SPECIAL) {
                all[at++] = a;
                all[at++] = b;
                all[at++] = SPECIAL[(at * 7 + 3) % n];
            }
        }
        for (int k = 0; k < RANDOM; k++) {
            // Products of the first two nearly cancel with the third: that tells fused from rounded twice.
            double a = number(2L * k);
            double b = number(2L * k + 1);
            all[at++] = a;
            all[at++] = b;
            all[at++] = k % 2 == 0 ? -(a * b) : number(-k - 1L);
        }
        return all;
    }

    /** Of any sign and bits, with exponents of ±40 mostly, and subnormal now and then. */
    private static double number(long k) {
        long bits = Hash.of(k, 1);
        double fraction = 1 + Hash.unit(Hash.of(k, 2));
        int exponent = (bits & 31) == 0 ? -1030 - (int) (bits >>> 8 & 31) : (int) (bits >>> 8 & 63) - 32;
        return Math.scalb((bits & 64) == 0 ? fraction : -fraction, exponent);
    }

    /** What Java makes of them, {@link #RESULTS} for each calculation. */
    public static double[] results(double[] inputs) {
        int n = inputs.length / INPUTS;
        double[] all = new double[RESULTS * n];
        for (int k = 0; k < n; k++) {
            double a = inputs[INPUTS * k];
            double b = inputs[INPUTS * k + 1];
            double c = inputs[INPUTS * k + 2];
            int at = RESULTS * k;
            all[at] = a + b;
            all[at + 1] = a - b;
            all[at + 2] = a * b;
            all[at + 3] = a / b;
            all[at + 4] = Math.sqrt(Math.abs(a));
            all[at + 5] = Math.fma(a, b, c);
            all[at + 6] = a * b + c;
            all[at + 7] = Math.floor(a);
            all[at + 8] = Sobol.x(k, Hash.of(k, 7));
            all[at + 9] = Angles.atan2(a, b);
        }
        return all;
    }

    /**
     * Compares what a device found with what Java finds; which bits tell that a result is no number does not matter.
     *
     * @throws DeviceFailure if they differ
     */
    public static void check(double[] inputs, double[] found) {
        double[] expected = results(inputs);
        OptionalInt wrong = IntStream.range(0, expected.length)
                .filter(i -> Double.doubleToLongBits(expected[i]) != Double.doubleToLongBits(found[i]))
                .findFirst();
        if (wrong.isPresent()) {
            int i = wrong.getAsInt();
            int k = i / RESULTS * INPUTS;
            throw new DeviceFailure("it does not compute as Java does: " + NAMES[i % RESULTS] + " of " + inputs[k]
                    + ", " + inputs[k + 1] + " and " + inputs[k + 2] + " is " + found[i] + " there, " + expected[i]
                    + " here");
        }
    }
}
