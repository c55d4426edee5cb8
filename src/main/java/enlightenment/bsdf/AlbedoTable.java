package enlightenment.bsdf;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * What a rough surface loses because light that hits it more than once is not counted: 1 − E(μ) at cosines μ, and the mean 1 − Ē over
 * directions by their cosine, of the interpolated table itself, so that a surface that absorbs nothing, with the lost light, gives back
 * exactly what arrives, up to the interpolation. Made by a fixed quadrature: the same everywhere.
 */
final class AlbedoTable {
    private static final int NODES = 64;

    /** Halvings until a place between 0 and 1 is known as well as a double can tell. */
    private static final int BISECTIONS = 52;

    /** Rings of the hemisphere, even in sqrt(μ), in which samples of lost light are spread by their cosine. */
    private static final int CELLS = 64;

    /** Parts of each of these in the mean. */
    private static final int PARTS = 32;

    /** 1 − Ē. */
    final double meanLoss;

    /** At each node the loss, or what is kept over what a smooth surface keeps ({@link VisibleNormals#isRelative}). */
    private final double[] nodes = new double[NODES + 1];

    /** The share of lost light that is below each ring, and the density in it over the cosine. */
    private final double[] below = new double[CELLS + 1];

    private final double[] density = new double[CELLS];
    private final VisibleNormals normals;
    private final double alpha;

    /** {@link VisibleNormals#even}. */
    private final double even;

    /** What facets lose by single scattering. */
    AlbedoTable(VisibleNormals normals) {
        this.normals = normals;
        alpha = normals.facets.alpha;
        even = normals.even;
        for (int k = 0; k < NODES; k++) {
            double cosine = cosine(k);
            double lost = normals.meanLoss(cosine);
            nodes[k] = normals.isRelative ? (1 - lost) / normals.keptBySmooth(cosine) : lost;
        }
        nodes[NODES] = nodes[NODES - 1];
        meanLoss = mean();
        spread();
    }

    /** Where the k-th node is. */
    private double cosine(int k) {
        double x = (double) k / (NODES - 1);
        double x2 = x * x;
        double low = alpha * x2 / Math.fma(1 - x, 1 + x, alpha);
        if (even == 0) {
            return low;
        }
        double high = 1;
        for (int step = 0; step < BISECTIONS; step++) {
            double middle = 0.5 * (low + high);
            if (node(middle) < x) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return k == NODES - 1 ? 1 : low;
    }

    /** Which node is at a cosine, 0..1. */
    private double node(double cosine) {
        double steep = Math.sqrt(cosine * (1 + alpha) / (cosine + alpha));
        return Math.fma(even, cosine - steep, steep);
    }

    /** For code on another device: what {@link #loss} and {@link #sampleDirection} go by. */
    double[] numbers() {
        double[] own = {meanLoss, normals.isRelative ? 1 : 0, even, alpha, normals.etaOfSmooth()};
        return Stream.of(own, nodes, below, density)
                .flatMapToDouble(Arrays::stream)
                .toArray();
    }

    /**
     * The loss 1 − E at a cosine, 0..1. Nodes are even in sqrt(μ(1 + α)/(μ + α)): the loss is steep at grazing directions, where it changes
     * with μ/α; or in a mean of that and μ.
     */
    double loss(double cosine) {
        double x = (NODES - 1) * node(cosine);
        int k = Math.min((int) x, NODES - 1);
        double value = Math.fma(x - k, nodes[k + 1] - nodes[k], nodes[k]);
        return normals.isRelative ? Math.max(1 - normals.keptBySmooth(cosine) * value, 0) : value;
    }

    /** 2∫(1 − E)μ dμ of the interpolated table, by Simpson's rule in sqrt(μ); leaves the sums up to each ring. */
    private double mean() {
        double total = 0;
        double step = 1.0 / (CELLS * PARTS);
        for (int k = 0; k < CELLS; k++) {
            for (int j = 0; j < PARTS; j++) {
                double v = (k * PARTS + j) * step;
                total += step / 6 * (integrand(v) + 4 * integrand(v + 0.5 * step) + integrand(v + step));
            }
            below[k + 1] = total;
        }
        return total;
    }

    private double integrand(double root) {
        return 4 * loss(Math.min(root * root, 1)) * root * root * root;
    }

    private void spread() {
        for (int k = 0; k < CELLS; k++) {
            density[k] = (below[k + 1] - below[k]) / (meanLoss * Math.PI * (edge2(k + 1) - edge2(k)));
        }
        for (int k = 0; k <= CELLS; k++) {
            below[k] /= meanLoss;
        }
    }

    /** The squared cosine at the lower edge of a ring. */
    private static double edge2(int k) {
        double root = (double) k / CELLS;
        return root * root * root * root;
    }

    /**
     * The share of the lost light that comes back from metal, 0..1: each further reflection takes F̄, and 1 − Ē of the rest goes on.
     *
     * @param mean the metal's mean reflectance F̄
     */
    double multiple(double mean) {
        return mean * mean * (1 - meanLoss) / (1 - mean * meanLoss);
    }

    /** The density per solid angle, at a cosine, of directions that {@link #sample} chooses; nearly (1 − E(μ))μ/(π(1 − Ē)). */
    double density(double cosine) {
        return density[Math.min((int) (CELLS * Math.sqrt(cosine)), CELLS - 1)] * cosine;
    }

    /** Samples i with the {@link #density} of its cosine: at small α what is lost is lost along the surface. */
    void sampleDirection(Scattering s, double u, double v) {
        s.toDisk(u, v);
        double z = sample(Math.min(s.disk2, 1));
        double across = s.disk2 > 0 ? Math.sqrt((1 - z) * (1 + z) / s.disk2) : 0;
        s.turn();
        s.directLocal(s.diskX * across, s.diskY * across, z);
    }

    /** The cosine of a direction in which lost light leaves, from a number that is uniform in 0..1. */
    double sample(double number) {
        return sample(this, 1, number);
    }

    /**
     * The same of a mixture of this table with another one.
     *
     * @param share of this one's light in it, 0..1
     */
    double sample(AlbedoTable other, double share, double number) {
        int low = 0;
        int high = CELLS;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (mixed(other, share, middle) <= number) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double before = mixed(other, share, low);
        double part = (number - before) / (mixed(other, share, high) - before);
        double from = edge2(low);
        return Math.sqrt(Math.min(Math.fma(part, edge2(high) - from, from), 1));
    }

    private double mixed(AlbedoTable other, double share, int cell) {
        return share * below[cell] + (1 - share) * other.below[cell];
    }
}
