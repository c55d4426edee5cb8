package enlightenment.engine;

import enlightenment.film.SplatSums;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;

/** A batch of paths: the bytes of {@link SplatSums}. */
final class BatchForm extends ResultForm {
    /** The most that a pixel takes: how far it is from the one before it, and three numbers of 63 bits. */
    private static final int PER_PIXEL = 5 + 3 * 9;

    private static final int NUMBERS = 9 + 5;

    private final int pixels;
    private final long brightest;

    BatchForm(WorkUnits units, int kinds, int pixels) {
        super(units, kinds);
        this.pixels = pixels;
        // Each of the four groups of units has a sum of its own.
        brightest = Long.MAX_VALUE / ((units.batches() + 3) / 4);
    }

    @Override
    int longest(int unit) {
        return (int) Math.min((long) start() + NUMBERS + (long) PER_PIXEL * pixels, Integer.MAX_VALUE);
    }

    @Override
    ByteBuffer make(int unit, UnitWork work, ResultHeader header) {
        byte[] sums = work.batch(unit).toBytes();
        return ByteBuffer.allocate(start() + sums.length).position(start()).put(sums);
    }

    @Override
    Optional<String> problem(int unit, byte[] bytes) {
        byte[] sums = sums(bytes);
        Optional<String> problem = SplatSums.problem(sums, units.paths(unit), pixels);
        // This bounds the sums of a film, whatever a worker sends.
        return problem.isPresent() || SplatSums.of(sums, pixels).largest() <= brightest
                ? problem
                : Optional.of("a pixel is brighter than the sums of all batches have room for");
    }

    private byte[] sums(byte[] bytes) {
        return Arrays.copyOfRange(bytes, start(), bytes.length);
    }

    @Override
    void put(PictureFilm film, int unit, byte[] bytes) {
        ((SplatPicture) film).put(unit, SplatSums.of(sums(bytes), pixels));
    }

    @Override
    void remove(PictureFilm film, int unit, ResultStore store) {
        ((SplatPicture) film).remove(unit, SplatSums.of(sums(store.get(unit)), pixels));
    }

    @Override
    boolean needsStore() {
        return true;
    }
}
