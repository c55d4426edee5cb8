package enlightenment.film;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import java.util.Random;

/** A picture of a function of the plane, sampled as a render samples it, with its truth. */
final class SampledPicture {
    static final int CELL = 8;

    /** What a picture shows. */
    interface Function {
        /**
         * The colour of a point; noise is a number of deviation 1 that each sample has for itself.
         *
         * @param x columns from the left, with fractions
         * @param y rows from above
         */
        double at(double x, double y, double noise);
    }

    private SampledPicture() {}

    /** The mean of each pixel, by a grid of so many points in either direction; functions must be linear in their noise. */
    static double[] truth(Function function, int width, int height, int grid) {
        double[] truth = new double[width * height];
        for (int i = 0; i < truth.length; i++) {
            double sum = 0;
            for (int k = 0; k < grid * grid; k++) {
                double x = i % width + (k % grid + 0.5) / grid;
                double y = i / width + (k / grid + 0.5) / grid;
                sum += function.at(x, y, 0);
            }
            truth[i] = sum / (grid * grid);
        }
        return truth;
    }

    /** So many samples in the mean: the next power of two below in some pixels and that above in the others. */
    static Film sampled(Function function, int width, int height, double samples, long seed) {
        int fewer = Integer.highestOneBit((int) samples);
        return sampled(function, width, height, fewer, samples / fewer - 1, seed);
    }

    /** So many samples in each pixel, and twice as many in a share of them. */
    static Film sampled(Function function, int width, int height, int fewer, double doubled, long seed) {
        Film film = new Film(0, 0, width, height);
        Random random = new Random(seed);
        SampleSpread spread = new SampleSpread();
        for (int cell = 0; cell < width * height / (CELL * CELL); cell++) {
            int left = cell % (width / CELL) * CELL;
            int top = cell / (width / CELL) * CELL;
            FilmTile tile = new FilmTile(left, top, CELL, CELL);
            for (int k = 0; k < CELL * CELL; k++) {
                int n = random.nextDouble() < doubled ? 2 * fewer : fewer;
                sample(function, tile, left + k % CELL, top + k / CELL, n, seed, random, spread);
            }
            film.put(tile);
        }
        return film;
    }

    static void sample(
            Function function, FilmTile tile, int x, int y, int n, long seed, Random random, SampleSpread spread) {
        long pixelSeed = Hash.of(seed, x, y);
        spread.begin(n);
        for (int s = 0; s < n; s++) {
            double dx = Sobol.x(s, pixelSeed);
            double dy = Sobol.y(s, pixelSeed);
            double v = function.at(x + dx, y + dy, random.nextGaussian());
            tile.add(x, y, v, v, v);
            spread.at(dx, dy);
            spread.add(v, v, v);
        }
        tile.spread(x, y, spread);
    }

    /** The root mean square difference of a picture from the truth. */
    static double error(Film film, double[] truth) {
        double sum = 0;
        for (int i = 0; i < truth.length; i++) {
            double d = film.component(i % film.width, i / film.width, 0) - truth[i];
            sum += d * d;
        }
        return Math.sqrt(sum / truth.length);
    }
}
