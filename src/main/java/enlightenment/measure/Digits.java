package enlightenment.measure;

import enlightenment.scene.Budget;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers of few digits, which people can read aloud and type. */
public final class Digits {
    private Digits() {}

    /** A number of samples that is not smaller and has two digits; within the limits of a budget. */
    static double upTwo(double samples) {
        double two = new BigDecimal(samples)
                .round(new MathContext(9, RoundingMode.HALF_EVEN))
                .round(new MathContext(2, RoundingMode.UP))
                .doubleValue();
        return Math.min(Math.max(two, 1), Budget.MAX_SAMPLES);
    }

    /** The next number of samples that has two digits; within the limits of a budget. */
    static double nearTwo(double samples) {
        double two = new BigDecimal(samples)
                .round(new MathContext(2, RoundingMode.HALF_EVEN))
                .doubleValue();
        return Math.min(Math.max(two, 1), Budget.MAX_SAMPLES);
    }

    /** A number in so many significant digits, without an exponent. */
    public static String of(double value, int digits) {
        if (value == 0) {
            return "0";
        }
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits, RoundingMode.HALF_EVEN));
        return rounded.setScale(Math.max(digits - rounded.precision() + rounded.scale(), 0), RoundingMode.HALF_EVEN)
                .toPlainString();
    }

    /** A budget of samples as it is given to {@code --samples}. */
    public static String samples(double samples) {
        return BigDecimal.valueOf(samples).stripTrailingZeros().toPlainString();
    }
}
