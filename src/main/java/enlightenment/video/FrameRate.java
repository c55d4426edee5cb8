package enlightenment.video;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * Frames per second, as a fraction in its lowest terms.
 *
 * @param frames 1..65535
 * @param seconds 1..65535
 */
public record FrameRate(int frames, int seconds) {
    /** What files of films have room for: 16 bits. */
    public static final int MOST = 65_535;

    /** Seconds in hundredths, the unit of GIF files. */
    private static final int HUNDRED = 100;

    /**
     * The rate, exactly if the number has few enough digits; otherwise the continued fraction of it as far as there is room.
     *
     * @param perSecond 1/65535..65535
     */
    public static FrameRate of(double perSecond) {
        if (!(perSecond >= 1.0 / MOST && perSecond <= MOST)) {
            throw new IllegalArgumentException("the frames of a film last 1/" + MOST + " to " + MOST
                    + " seconds; framesPerSecond is " + perSecond);
        }
        BigDecimal decimal = new BigDecimal(Double.toString(perSecond));
        BigInteger scale = BigInteger.TEN.pow(Math.max(decimal.scale(), 0));
        BigInteger a = decimal.multiply(new BigDecimal(scale)).toBigIntegerExact();
        BigInteger b = scale;
        // Convergents p/q of a/b: p2/q2 is the one before.
        long p = 1;
        long q = 0;
        long p2 = 0;
        long q2 = 1;
        while (b.signum() > 0) {
            BigInteger[] division = a.divideAndRemainder(b);
            // The first is at most 65535; where a later one is larger, there is no room for it either.
            long digit = division[0].min(BigInteger.valueOf(MOST + 1L)).longValueExact();
            long nextP = digit * p + p2;
            long nextQ = digit * q + q2;
            if (nextP > MOST || nextQ > MOST) {
                break;
            }
            p2 = p;
            q2 = q;
            p = nextP;
            q = nextQ;
            a = b;
            b = division[1];
        }
        return p == 0 ? new FrameRate(1, MOST) : new FrameRate((int) p, (int) q);
    }

    /**
     * How long a frame is shown by a clock of hundredths of a second, such that after any number of frames the film is less than one of
     * them early or late; 2 at least, since players take less for nothing said.
     *
     * @param frame counted from 0
     */
    int hundredths(int frame) {
        long begin = Math.floorDiv((long) HUNDRED * seconds * frame, (long) frames);
        long end = Math.floorDiv((long) HUNDRED * seconds * (frame + 1L), (long) frames);
        return (int) Math.min(Math.max(end - begin, 2), MOST);
    }

    /** As ffmpeg reads it. */
    @Override
    public String toString() {
        return frames + "/" + seconds;
    }
}
