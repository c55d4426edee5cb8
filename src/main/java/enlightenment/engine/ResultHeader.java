package enlightenment.engine;

import enlightenment.file.ContentHash;
import enlightenment.world.parts.RayCounters;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The header of every result. It has the number of survey rays, the counters, and twice the number of samples that were not finite, plus
 * one if samples are differences from known values (8 bytes each).
 */
final class ResultHeader {
    private static final int SCALARS = 12;

    /** Upper bound of each counter, summed over all results of a render. */
    private static final long MOST_COUNTED = 1L << 62;

    private long surveyRays;
    private boolean differences;
    private long lost;

    static int length(int kinds) {
        return (SCALARS + 2 * kinds) * Long.BYTES;
    }

    /** Adds the survey rays and the lost samples of some of the pixels, and whether their samples are differences. */
    void add(long moreSurveyRays, boolean areDifferences, long lostSamples) {
        lost += lostSamples;
        surveyRays += moreSurveyRays;
        differences |= areDifferences;
    }

    void write(ByteBuffer out, RayCounters c) {
        out.putLong(surveyRays)
                .putLong(c.cameraRays)
                .putLong(c.mirrorRays)
                .putLong(c.refractedRays)
                .putLong(c.shadowRays);
        out.putLong(c.lightSamples).putLong(c.lightSamplesWithoutRay).putLong(c.textureLookups);
        out.putLong(c.proposals).putLong(c.accepted).putLong(c.clusters);
        for (int i = 0; i < c.tests.length; i++) {
            out.putLong(c.tests[i]).putLong(c.hits[i]);
        }
        out.putLong(2 * lost + (differences ? 1 : 0));
    }

    /**
     * Why a result cannot have this header; empty if it can.
     *
     * @param units number of results of the render: it bounds each counter, so that no sum of counters overflows, whatever a worker sends
     */
    static Optional<String> problem(byte[] result, int kinds, int units) {
        if (result.length < length(kinds)) {
            return Optional.of("it has " + result.length + " bytes, fewer than its header");
        }
        long most = MOST_COUNTED / units;
        return outside(result, kinds, most).stream()
                .mapToObj(count -> "a counter is " + count + ", outside 0.." + most)
                .findFirst();
    }

    /**
     * Whether what more samples count can be added to the counters of a result without problems: at most half of what one may count is
     * there.
     */
    static boolean hasRoom(byte[] result, int kinds, int units) {
        return outside(result, kinds, MOST_COUNTED / units / 2).isEmpty();
    }

    private static OptionalLong outside(byte[] result, int kinds, long most) {
        ByteBuffer in = ByteBuffer.wrap(result);
        for (int i = 0; i < SCALARS + 2 * kinds; i++) {
            long count = in.getLong();
            if (count < 0 || count > most) {
                return OptionalLong.of(count);
            }
        }
        return OptionalLong.empty();
    }

    static RayCounters counters(byte[] result, int kinds) {
        ByteBuffer in = ByteBuffer.wrap(result).position(Long.BYTES);
        RayCounters c = new RayCounters(kinds);
        c.cameraRays = in.getLong();
        c.mirrorRays = in.getLong();
        c.refractedRays = in.getLong();
        c.shadowRays = in.getLong();
        c.lightSamples = in.getLong();
        c.lightSamplesWithoutRay = in.getLong();
        c.textureLookups = in.getLong();
        c.proposals = in.getLong();
        c.accepted = in.getLong();
        c.clusters = in.getLong();
        for (int i = 0; i < kinds; i++) {
            c.tests[i] = in.getLong();
            c.hits[i] = in.getLong();
        }
        return c;
    }

    /** The hash of a result without problems but for its counters: a device tests other primitives for the same pixels. */
    static ContentHash digest(byte[] result, int kinds) {
        MessageDigest digest = ContentHash.sha256();
        digest.update(result, 0, Long.BYTES);
        int end = length(kinds) - Long.BYTES;
        digest.update(result, end, result.length - end);
        return ContentHash.fromBytes(digest.digest());
    }

    static long surveyRays(byte[] result) {
        return ByteBuffer.wrap(result).getLong();
    }

    /** The number of camera rays in a result; 0 for bytes that are no result. */
    static long cameraRays(byte[] result) {
        return result.length < 2 * Long.BYTES ? 0 : ByteBuffer.wrap(result).getLong(Long.BYTES);
    }

    /** Whether the samples of a result are differences from something known. */
    static boolean samplesAreDifferences(byte[] result, int kinds) {
        return (ByteBuffer.wrap(result).getLong(length(kinds) - Long.BYTES) & 1) != 0;
    }

    /** The number of samples of a result that were not finite. */
    static long lostSamples(byte[] result, int kinds) {
        return ByteBuffer.wrap(result).getLong(length(kinds) - Long.BYTES) / 2;
    }
}
