package enlightenment.compiled;

/**
 * How light that is found by chance only ({@link ChanceLight}) affects the mean squared error of a picture, in displayed units (0..1),
 * mean of the components.
 *
 * @param shortfall by how much the error estimate from the samples is expected to fall short of the true mean squared error; at least 0
 * @param most the 97.5 % quantile of the mean squared error that such light alone causes
 */
public record ChanceError(double shortfall, double most) {
    /** Nothing is left to chance, as far as is known. */
    public static final ChanceError NONE = new ChanceError(0, 0);

    /** That of two kinds of such light, whose errors have nothing to do with each other: {@link #most} is too great rather than too small. */
    public ChanceError plus(ChanceError other) {
        return new ChanceError(shortfall + other.shortfall, most + other.most);
    }
}
