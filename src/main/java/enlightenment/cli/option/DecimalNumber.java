package enlightenment.cli.option;

import java.math.BigDecimal;
import picocli.CommandLine.ITypeConverter;

/** A decimal number between two limits, both included. Options name subclasses, which have their limits. */
public abstract class DecimalNumber implements ITypeConverter<Double> {
    private final double min;
    private final double max;

    /** @param max the largest value, or {@link Double#MAX_VALUE} for no limit */
    public DecimalNumber(double min, double max) {
        this.min = min;
        this.max = max;
    }

    @Override
    public final Double convert(String text) {
        return parse(text, min, max);
    }

    /** Parses a decimal number. What Java also accepts, such as {@code NaN} or {@code 1f}, is refused. */
    public static double parse(String text, double min, double max) {
        if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
            double value = Double.parseDouble(text);
            if (value >= min && value <= max) {
                return value;
            }
        }
        String limits = max == Double.MAX_VALUE ? "of at least " + plain(min) : "in " + plain(min) + ".." + plain(max);
        throw BadValue.expected("a number " + limits, text);
    }

    /** A number with all its digits and without an exponent. */
    public static String plain(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }
}
