package enlightenment.compiled;

/**
 * What light that is left to chance ({@link ChanceLight}) does to the error of a picture, of what a screen shows, mean of components.
 *
 * @param shortfall how much smaller than it is the samples are expected to tell the mean squared error
 * @param most the mean squared error that such light alone makes in 39 of 40 pictures at most
 */
public record ChanceError(double shortfall, double most) {
    /** Nothing is left to chance, as far as is known. */
    public static final ChanceError NONE = new ChanceError(0, 0);
}
