package enlightenment.bsdf;

import java.util.Arrays;

/**
 * A Bsdf as plain numbers, for code on another device that computes what the Bsdf does, operation by operation. Which number is what stands
 * beside that code.
 *
 * @param numbers those of its kind; not to be changed
 */
public record FlatBsdf(Kind kind, double... numbers) {
    /** What such code knows. */
    public enum Kind {
        MATTE,
        MIRROR,
        GLASS,
        SMOOTH_GLASS,
        METAL,
        ROUGH_METAL,
        ROUGH_MATTE,
        COAT,
        ROUGH_COAT
    }

    /** One with the numbers of some parts, one after the other. */
    static FlatBsdf of(Kind kind, double[]... parts) {
        return new FlatBsdf(
                kind, Arrays.stream(parts).flatMapToDouble(Arrays::stream).toArray());
    }
}
