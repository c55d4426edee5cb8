package enlightenment.sampling;

/**
 * The samples of pixels: numbers as pure functions of (seed, pixel, sample, address). Where they have to be well distributed, they
 * are points of an Owen-scrambled Sobol sequence that runs through the samples of the pixel; each address has a scrambling and an
 * order of its own, so that addresses are independent (T. Kollig and A. Keller, "Efficient multidimensional sampling", 2002).
 */
public final class SobolSampler implements Sampler {
    private static final long FILM = 0;
    private static final long FIRST_LIGHT = 1;

    /** Later bounces gain little by being stratified, and a hash costs less (measured: docs/physical-light.md). */
    private static final int STRATIFIED_BOUNCES = 2;

    private long pixelHash;
    private long filmSeed;
    private int sample;

    private long lightSeed;
    private int firstLightPoint;

    /** Sets the pixel, by its column and row in the whole picture. */
    public void pixel(long seed, int x, int y) {
        pixelHash = Hash.of(seed, x, y);
        filmSeed = Hash.of(pixelHash, FILM);
    }

    /** Sets the sample of the pixel. */
    public void sample(int index) {
        sample = index;
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
        return Hash.unit(Hash.of(seed(bounce, purpose), sample));
    }

    @Override
    public void pair(int bounce, Purpose purpose, double[] out) {
        long seed = seed(bounce, purpose);
        if (bounce >= STRATIFIED_BOUNCES) {
            long h = Hash.of(~seed, sample);
            out[0] = (h >>> Integer.SIZE) * 0x1p-32;
            out[1] = (h & 0xFFFFFFFFL) * 0x1p-32;
            return;
        }
        int index = Sobol.shuffled(sample, Hash.mix(seed));
        out[0] = Sobol.x(index, seed);
        out[1] = Sobol.y(index, seed);
    }

    /** From 2³² on, so that it is not that of the film. */
    private long seed(int bounce, Purpose purpose) {
        return Hash.of(pixelHash, (purpose.ordinal() + 1L) << Integer.SIZE | bounce);
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
