package enlightenment.transport.emission;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import enlightenment.transport.ray.PathSource;

/** The random numbers of light paths: a pure function of the seed and the path's number. A mutable work object, one per thread. */
public final class LightPathNumbers {
    private final long seed;

    /** The numbers of the first ray; each pair is from a low-discrepancy sequence over its square. */
    public final double[] first = new double[PathSource.NUMBERS];

    /** For each pair, the seed of its sequence and that of the sequence's order. */
    private final long[] seeds = new long[first.length];

    /** The upper half of the number of the paths that {@link #seeds} belong to; -1 before the first path. */
    private long sequences = -1;

    private long number;

    /** The hash of the path, from which all numbers after the first ray follow. */
    private long hash;

    /**
     * @param seed of all random numbers of these paths, used for nothing else
     */
    public LightPathNumbers(long seed) {
        this.seed = seed;
    }

    /** Begins the path with this number. */
    public void begin(long path) {
        number = path;
        hash = Hash.of(seed, path);
        long era = era();
        if (era != sequences) {
            sequences = era;
            long sequence = Hash.of(seed, -1 - era);
            for (int k = 0; k < first.length; k += 2) {
                seeds[k] = Hash.of(sequence, k);
                seeds[k + 1] = Hash.mix(seeds[k]);
            }
        }
        for (int k = 0; k < first.length; k += 2) {
            int index = Sobol.shuffled((int) path, seeds[k + 1]);
            first[k] = Sobol.x(index, seeds[k]);
            first[k + 1] = Sobol.y(index, seeds[k]);
        }
    }

    private long era() {
        return number >>> Integer.SIZE;
    }

    /** The random number of the path's wavelength. */
    public double wavelength() {
        long sequence = Hash.of(Hash.of(seed, -1 - era()), -1);
        return Sobol.x(Sobol.shuffled((int) number, Hash.mix(sequence)), sequence);
    }

    /**
     * A random number of an event, in [0, 1).
     *
     * @param events the number of scattering events before
     * @param pieces the number of surfaces that the path passed straight
     * @param purpose distinguishes the numbers of one event
     */
    public double unit(int events, int pieces, long purpose) {
        return Hash.unit(Hash.of(hash, ((long) pieces << Integer.SIZE) + events, purpose));
    }
}
