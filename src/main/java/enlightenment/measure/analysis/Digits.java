package enlightenment.measure.analysis;

import enlightenment.scene.RenderSettings;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Rounding of numbers to few significant digits, for texts and options. */
public final class Digits {
    private Digits() {}

    /** A number of samples rounded up to two significant digits, within the range of a budget. */
    public static double upTwo(double samples) {
        double rounded = new BigDecimal(samples)
                .round(new MathContext(9, RoundingMode.HALF_EVEN))
                .round(new MathContext(2, RoundingMode.UP))
                .doubleValue();
        return Math.min(Math.max(rounded, 1), RenderSettings.Budget.MAX_SAMPLES);
    }

    /** A number rounded up to two significant digits. */
    static double upTwoOf(double value) {
        return new BigDecimal(value)
                .round(new MathContext(9, RoundingMode.HALF_EVEN))
                .round(new MathContext(2, RoundingMode.UP))
                .doubleValue();
    }

    /** A number of samples rounded to two significant digits, within the range of a budget. */
    public static double nearTwo(double samples) {
        double rounded = new BigDecimal(samples)
                .round(new MathContext(2, RoundingMode.HALF_EVEN))
                .doubleValue();
        return Math.min(Math.max(rounded, 1), RenderSettings.Budget.MAX_SAMPLES);
    }

    /** A number with the given significant digits, without an exponent. */
    public static String of(double value, int digits) {
        if (value == 0) {
            return "0";
        }
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits, RoundingMode.HALF_EVEN));
        return rounded.setScale(Math.max(digits - rounded.precision() + rounded.scale(), 0), RoundingMode.HALF_EVEN)
                .toPlainString();
    }

    /** A budget as the value of {@code --samples}. */
    public static String samples(double samples) {
        return BigDecimal.valueOf(samples).stripTrailingZeros().toPlainString();
    }
}
