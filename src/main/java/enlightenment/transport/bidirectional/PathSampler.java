package enlightenment.transport.bidirectional;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.Sobol;

/**
 * The random numbers of numbered paths that belong to no pixel. Origin, direction and wavelength come from low-discrepancy sequences, all
 * else from a hash.
 */
public final class PathSampler implements Sampler {
    /** Mixed into the seed, so that these paths share no random numbers with others. */
    private static final long PURPOSE = 0x626964697265637aL;

    private final long seed;
    private long sequence;
    private int index;
    private long hash;

    public PathSampler(long seed) {
        this.seed = Hash.of(seed, PURPOSE);
    }

    /** Begins the path with this number. */
    public void path(long number) {
        hash = Hash.of(seed, number);
        sequence = Hash.of(seed, -1 - (number >>> Integer.SIZE));
        index = (int) number;
    }

    private long address(int bounce, Purpose purpose) {
        return (long) purpose.ordinal() << Integer.SIZE | bounce;
    }

    @Override
    public void pair(int bounce, Purpose purpose, double[] out) {
        if (purpose == Purpose.EMISSION || purpose == Purpose.WAVELENGTH) {
            long s = Hash.of(sequence, purpose == Purpose.EMISSION ? bounce : -1 - bounce);
            int at = Sobol.shuffled(index, Hash.mix(s));
            out[0] = Sobol.x(at, s);
            out[1] = Sobol.y(at, s);
            return;
        }
        long h = Hash.of(~hash, address(bounce, purpose));
        out[0] = (h >>> Integer.SIZE) * 0x1p-32;
        out[1] = (h & 0xFFFFFFFFL) * 0x1p-32;
    }

    @Override
    public double unit(int bounce, Purpose purpose) {
        return Hash.unit(Hash.of(hash, address(bounce, purpose)));
    }

    @Override
    public double filmX() {
        throw new UnsupportedOperationException("these paths begin at no place of the film");
    }

    @Override
    public double filmY() {
        return filmX();
    }

    @Override
    public void lightPoints(int light, int bounce, int count) {
        filmX();
    }

    @Override
    public double lightX(int k) {
        return filmX();
    }

    @Override
    public double lightY(int k) {
        return filmX();
    }
}
