package enlightenment.sampling;

/**
 * The random numbers of pixel samples: pure functions of (seed, pixel, sample, address). Early dimensions are points of an Owen-scrambled
 * Sobol sequence over the samples of the pixel; each address has its own scrambling and order, so that addresses are independent (T. Kollig
 * and A. Keller, "Efficient multidimensional sampling", 2002).
 */
public final class SobolSampler implements Sampler {
    private static final long FILM = 0;
    private static final long FIRST_LIGHT = 1;

    /** The number of stratified bounces: later ones gain little, and a hash costs less (docs/notes/path-tracing.md). */
    private static final int STRATIFIED_BOUNCES = 2;

    private static final int SEQUENCES = STRATIFIED_BOUNCES * Purpose.values().length;

    /** Distinguishes a single number from a pair with the same address. */
    private static final long SINGLE = 1L << 40;

    private int column;
    private int row;
    private long pixelHash;
    private long filmSeed;
    private int sample;

    /** By bounce and purpose: the seed of a sequence, and that of its order. */
    private final long[] seeds = new long[2 * SEQUENCES];

    /** By bounce and purpose: the number of the pixel that {@link #seeds} belong to. */
    private final int[] seedsOf = new int[SEQUENCES];

    private int pixels;

    /** The common part of the sample's hashes. */
    private long sampleHash;

    private long lightSeed;
    private int firstLightPoint;

    /** Sets the pixel, by its column and row in the whole picture. */
    public void pixel(long seed, int x, int y) {
        column = x;
        row = y;
        pixelHash = Hash.of(seed, x, y);
        filmSeed = Hash.of(pixelHash, FILM);
        pixels++;
        sample(sample);
    }

    /** The column of the current pixel in the whole picture. */
    public int column() {
        return column;
    }

    /** The row of the current pixel in the whole picture. */
    public int row() {
        return row;
    }

    /** The index of the current sample, counted from 0 in each pixel. */
    public int sample() {
        return sample;
    }

    /** Sets the sample of the current pixel. */
    public void sample(int index) {
        sample = index;
        sampleHash = Hash.of(~pixelHash, index);
    }

    @Override
    public double filmX() {
        return Sobol.x(sample, filmSeed);
    }

    @Override
    public double filmY() {
        return Sobol.y(sample, filmSeed);
    }

    @Override
    public double unit(int bounce, Purpose purpose) {
        return Hash.unit(late(address(bounce, purpose) | SINGLE));
    }

    @Override
    public void pair(int bounce, Purpose purpose, double[] out) {
        if (bounce >= STRATIFIED_BOUNCES) {
            long h = late(address(bounce, purpose));
            out[0] = (h >>> Integer.SIZE) * 0x1p-32;
            out[1] = (h & 0xFFFFFFFFL) * 0x1p-32;
            return;
        }
        int k = STRATIFIED_BOUNCES * purpose.ordinal() + bounce;
        if (seedsOf[k] != pixels) {
            prepare(k, address(bounce, purpose));
        }
        int index = Sobol.shuffled(sample, seeds[2 * k + 1]);
        out[0] = Sobol.x(index, seeds[2 * k]);
        out[1] = Sobol.y(index, seeds[2 * k]);
    }

    private void prepare(int k, long address) {
        long seed = Hash.of(pixelHash, address);
        seeds[2 * k] = seed;
        seeds[2 * k + 1] = Hash.mix(seed);
        seedsOf[k] = pixels;
    }

    /** The address of a purpose at a bounce: from 2³² on, so that it is not that of the film. */
    private static long address(int bounce, Purpose purpose) {
        return (purpose.ordinal() + 1L) << Integer.SIZE | bounce;
    }

    /** The hash of the current sample and an address: one step of SplitMix64 from a state of the sample's own. */
    private long late(long address) {
        return Hash.next(sampleHash, address);
    }

    @Override
    public void lightPoints(int light, int bounce, int count) {
        lightSeed = Hash.of(pixelHash, FIRST_LIGHT + light, bounce);
        firstLightPoint = Sobol.shuffled(sample, Hash.mix(lightSeed)) * count;
    }

    @Override
    public double lightX(int k) {
        return Sobol.x(firstLightPoint + k, lightSeed);
    }

    @Override
    public double lightY(int k) {
        return Sobol.y(firstLightPoint + k, lightSeed);
    }
}
