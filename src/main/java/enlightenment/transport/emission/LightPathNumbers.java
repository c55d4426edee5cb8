package enlightenment.transport.emission;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import enlightenment.transport.ray.PathSource;

/** The random numbers of paths of light: a function of the seed and the path's number. A mutable work object, one per thread. */
public final class LightPathNumbers {
    private final long seed;

    /** Those of the first ray: each two of them from a sequence that fills their square evenly. */
    public final double[] first = new double[PathSource.NUMBERS];

    /** Of each two of these: the seed of their sequence, and that of its order. */
    private final long[] seeds = new long[first.length];

    /** The upper half of the number of the paths whose seeds these are; none has this one. */
    private long sequences = -1;

    private long number;

    /** All numbers of the path after its first ray come from this. */
    private long hash;

    /** @param seed of all random numbers of these paths, and of no others */
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

    /** That of the path's wavelength. */
    public double wavelength() {
        long sequence = Hash.of(Hash.of(seed, -1 - era()), -1);
        return Sobol.x(Sobol.shuffled((int) number, Hash.mix(sequence)), sequence);
    }

    /**
     * A number of an event, 0..1.
     *
     * @param events how many came before
     * @param pieces how many surfaces the path passed straight
     * @param purpose what it is for
     */
    public double unit(int events, int pieces, long purpose) {
        return Hash.unit(Hash.of(hash, ((long) pieces << Integer.SIZE) + events, purpose));
    }
}
