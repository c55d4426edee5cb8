package enlightenment.bsdf;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * The energy loss of single scattering at a rough surface: 1 − E(μ) at cosines μ, with E the directional albedo, and the mean 1 − Ē over
 * cosine-weighted directions, computed from the interpolated table itself, so that a surface without absorption, with its compensating
 * lobe, reflects exactly all light up to the interpolation. Made by a fixed quadrature: the same on every machine.
 */
final class AlbedoTable {
    private static final int NODES = 64;

    /** Bisections that determine a cosine in 0..1 to the precision of a double. */
    private static final int BISECTIONS = 52;

    /** Rings of the hemisphere, uniform in sqrt(μ), by which directions of the compensating lobe are sampled. */
    private static final int CELLS = 64;

    /** Parts of each ring in the integral of the mean. */
    private static final int PARTS = 32;

    /** 1 − Ē, the cosine-weighted mean of the loss. */
    final double meanLoss;

    /** At each node the loss, or the ratio of the albedo to that of a smooth surface ({@link VisibleNormals#isRelative}). */
    private final double[] nodes = new double[NODES + 1];

    /** By ring, the share of the lobe's samples below it, and the density in it over the cosine. */
    private final double[] below = new double[CELLS + 1];

    private final double[] density = new double[CELLS];
    private final VisibleNormals normals;
    private final double alpha;

    /** {@link VisibleNormals#even}. */
    private final double even;

    /** Makes the table of the losses of single scattering at these normals. */
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

    /** The cosine of the k-th node. */
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

    /** The position of a cosine, 0..1, among the nodes, scaled to 0..1. */
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
     * The loss 1 − E at a cosine, 0..1. Nodes are uniform in sqrt(μ(1 + α)/(μ + α)), as the loss is steep at grazing directions, where it
     * changes with μ/α; or in a mean of that and μ.
     */
    double loss(double cosine) {
        double x = (NODES - 1) * node(cosine);
        int k = Math.min((int) x, NODES - 1);
        double value = Math.fma(x - k, nodes[k + 1] - nodes[k], nodes[k]);
        return normals.isRelative ? Math.max(1 - normals.keptBySmooth(cosine) * value, 0) : value;
    }

    /** 2∫(1 − E)μ dμ of the interpolated table, by Simpson's rule in sqrt(μ); stores the sums up to each ring. */
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
     * The share of the lost light that metal reflects after further reflections, 0..1: each of these multiplies by F̄, and 1 − Ē of the
     * rest is lost again.
     *
     * @param mean the metal's mean reflectance F̄
     */
    double multiple(double mean) {
        return mean * mean * (1 - meanLoss) / (1 - mean * meanLoss);
    }

    /** The density per solid angle, at a cosine, of {@link #sampleDirection}; nearly (1 − E(μ))μ/(π(1 − Ē)). */
    double density(double cosine) {
        return density[Math.min((int) (CELLS * Math.sqrt(cosine)), CELLS - 1)] * cosine;
    }

    /** Samples i with the {@link #density} of its cosine: at small α the loss is concentrated at grazing directions. */
    void sampleDirection(Scattering s, double u, double v) {
        s.toDisk(u, v);
        double z = sample(Math.min(s.disk2, 1));
        double across = s.disk2 > 0 ? Math.sqrt((1 - z) * (1 + z) / s.disk2) : 0;
        s.turn();
        s.directLocal(s.diskX * across, s.diskY * across, z);
    }

    /** Samples the cosine of a direction of the compensating lobe, by a number uniform in 0..1. */
    double sample(double number) {
        return sample(this, 1, number);
    }

    /**
     * Samples the cosine of a direction by a mixture of this table and another one; see {@link #sample(double)}.
     *
     * @param share of this table in the mixture, 0..1
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
