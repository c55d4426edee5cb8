package enlightenment.film;

import enlightenment.color.DisplayCurve;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import java.util.Random;

/** A picture of linear light as paths make it: smooth light, noise of many kinds around it, edges; with its truth. */
final class PathPicture {
    static final int SIDE = 64;
    private static final int CELL = FilmTile.BLOCK_SIDE;

    /** The noise of a path: numbers of mean 1. */
    interface Noise {
        double next(Random random);
    }

    /** What light it is, of mean m in a pixel. */
    enum Kind implements Noise {
        /** As of diffuse light from everywhere. */
        EXPONENTIAL {
            @Override
            public double next(Random random) {
                return -StrictMath.log(1 - random.nextDouble());
            }
        },
        /** Nothing in three of four cases, as of a light that is half hidden. */
        RARE {
            @Override
            public double next(Random random) {
                return random.nextInt(4) == 0 ? 4 : 0;
            }
        },
        /** One of 300 is two hundred times as bright as the rest: what it brings a screen cannot show. */
        SPARKS {
            @Override
            public double next(Random random) {
                return (random.nextInt(300) == 0 ? 200 : 1) / (1 + 199 / 300.0);
            }
        },
        /** Deviation 1.3 of the logarithm: squares have a kurtosis of hundreds. */
        HEAVY {
            @Override
            public double next(Random random) {
                return StrictMath.exp(1.3 * random.nextGaussian() - 0.845);
            }
        },
        /** Hardly any. */
        SLIGHT {
            @Override
            public double next(Random random) {
                return 1 + 0.05 * random.nextGaussian();
            }
        };

        @Override
        public abstract double next(Random random);
    }

    final Film film;
    final double[] truth = new double[SIDE * SIDE];
    private final DisplayCurve curve;

    private PathPicture(DisplayCurve curve) {
        this.curve = curve;
        film = new Film(0, 0, SIDE, SIDE, curve);
    }

    /**
     * Samples a picture whose light grows from 0 on the left to {@code brightest} on the right, and is a quarter of that in the lower
     * half, beyond a slanting edge.
     */
    static PathPicture of(Noise noise, double brightest, int samples, DisplayCurve curve, long seed) {
        PathPicture picture = new PathPicture(curve);
        Random random = new Random(seed);
        SampleSpread spread = new SampleSpread();
        for (int cell = 0; cell < SIDE * SIDE / (CELL * CELL); cell++) {
            FilmTile tile = new FilmTile(cell % (SIDE / CELL) * CELL, cell / (SIDE / CELL) * CELL, CELL, CELL, curve);
            for (int k = 0; k < CELL * CELL; k++) {
                int x = tile.x + k % CELL;
                int y = tile.y + k / CELL;
                long pixelSeed = Hash.of(seed, x, y);
                spread.begin(samples);
                for (int s = 0; s < samples; s++) {
                    double dx = Sobol.x(s, pixelSeed);
                    double dy = Sobol.y(s, pixelSeed);
                    double v = light(x + dx, y + dy, brightest) * noise.next(random);
                    tile.add(x, y, v, v, v);
                    spread.at(dx, dy);
                    spread.add(v, v, v);
                }
                tile.spread(x, y, spread);
                picture.truth[y * SIDE + x] = mean(x, y, brightest);
            }
            picture.film.put(tile);
        }
        return picture;
    }

    private static double light(double x, double y, double brightest) {
        return brightest * x / SIDE * (y + 0.3 * x > 0.6 * SIDE ? 0.25 : 1);
    }

    private static double mean(int x, int y, double brightest) {
        double sum = 0;
        int grid = 16;
        for (int k = 0; k < grid * grid; k++) {
            sum += light(x + (k % grid + 0.5) / grid, y + (k / grid + 0.5) / grid, brightest);
        }
        return sum / (grid * grid);
    }

    /** The root mean square error of what is shown. */
    double error() {
        return error(film);
    }

    double error(Film of) {
        double sum = 0;
        for (int i = 0; i < truth.length; i++) {
            double d = curve.of(of.component(i % SIDE, i / SIDE, 0)) - curve.of(truth[i]);
            sum += d * d;
        }
        return Math.sqrt(sum / truth.length);
    }

    /** The relative error of light, as {@link LinearError} defines it. */
    double relative() {
        double mean = 0;
        for (double t : truth) {
            mean += t / truth.length;
        }
        double sum = 0;
        for (int i = 0; i < truth.length; i++) {
            double d = film.component(i % SIDE, i / SIDE, 0) - truth[i];
            sum += d * d / (truth[i] * truth[i] + 0.0025 * mean * mean);
        }
        return Math.sqrt(sum / truth.length);
    }
}
