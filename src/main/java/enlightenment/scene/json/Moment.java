package enlightenment.scene.json;

import enlightenment.scene.Animation;
import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * An exact time of an animation, as a fraction in frames.
 *
 * @param over numerator of the time in frames, at least 0
 * @param under denominator of the time in frames, at least 1
 */
record Moment(BigInteger over, BigInteger under) {
    /** The time at which a frame begins. */
    static Moment of(int frame) {
        return new Moment(BigInteger.valueOf(frame), BigInteger.ONE);
    }

    /**
     * A shutter instant of a frame: the middle of one of the equal parts of the exposure time.
     *
     * @param index 0 to instants − 1
     */
    static Moment instant(Animation animation, int frame, int index) {
        // The decimal that was written, if it had no more digits than a double distinguishes.
        BigDecimal shutter = BigDecimal.valueOf(animation.shutter());
        BigInteger scale = BigInteger.TEN.pow(Math.max(shutter.scale(), 0));
        BigInteger open = shutter.multiply(new BigDecimal(scale)).toBigIntegerExact();
        BigInteger under = scale.multiply(BigInteger.valueOf(2L * animation.instants()));
        return new Moment(
                BigInteger.valueOf(frame).multiply(under).add(open.multiply(BigInteger.valueOf(2L * index + 1))),
                under);
    }

    /** The last frame that begins at or before this time. */
    int frame() {
        return over.divide(under).intValueExact();
    }
}
