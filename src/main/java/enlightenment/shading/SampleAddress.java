package enlightenment.shading;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;

/**
 * Which sample is being taken: every random number of shading is a pure function of (seed, pixel, sample, dimension).
 */
public final class SampleAddress {
    private static final long FILM = 0;
    private static final long FIRST_LIGHT = 1;

    private long pixelHash;
    private long filmSeed;
    private int sample;

    /** Sets the pixel, by its column and row in the whole picture. */
    public void pixel(long seed, int x, int y) {
        pixelHash = Hash.of(seed, x, y);
        filmSeed = Hash.of(pixelHash, FILM);
    }

    /** Sets the sample of the pixel. */
    public void sample(int index) {
        sample = index;
    }

    /** Horizontal position within the pixel, 0..1. */
    public double filmX() {
        return Sobol.x(sample, filmSeed);
    }

    /** Vertical position within the pixel, 0..1. */
    public double filmY() {
        return Sobol.y(sample, filmSeed);
    }

    /** The scrambling of the light points of one light at one bounce. */
    long lightSeed(int light, int bounce) {
        return Hash.of(pixelHash, FIRST_LIGHT + light, bounce);
    }

    /** The index in the sequence of light points at which those of this sample begin, if it takes {@code count} of them. */
    int firstLightPoint(long lightSeed, int count) {
        return Sobol.shuffled(sample, Hash.mix(lightSeed)) * count;
    }
}
