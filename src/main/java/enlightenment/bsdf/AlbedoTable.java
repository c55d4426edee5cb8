package enlightenment.bsdf;

/**
 * What a rough surface of perfect mirrors loses because light that hits it more than once is not counted: 1 − E(μ) at cosines μ, and the
 * mean 1 − Ē over directions by their cosine, of the interpolated table itself, so that a white surface with the lost light reflects
 * exactly what arrives, up to the interpolation. Made by a fixed quadrature: the same everywhere.
 */
final class AlbedoTable {
    private static final int NODES = 64;
    /** Rings and sectors of a half disk, over which visible normals are spread evenly. */
    private static final int RINGS = 128;

    private static final int SECTORS = 64;
    /** Rings of the hemisphere, even in sqrt(μ), in which samples of lost light are spread by their cosine. */
    private static final int CELLS = 64;

    /** Parts of each of these in the mean. */
    private static final int PARTS = 32;

    /** 1 − Ē. */
    final double meanLoss;

    private final double[] loss = new double[NODES + 1];
    /** The share of lost light that is below each ring, and the density in it over the cosine. */
    private final double[] below = new double[CELLS + 1];

    private final double[] density = new double[CELLS];
    private final double alpha;

    AlbedoTable(Microfacets facets) {
        alpha = facets.alpha;
        double[] cosines = new double[SECTORS];
        for (int j = 0; j < SECTORS; j++) {
            cosines[j] = StrictMath.cos(Math.PI * (j + 0.5) / SECTORS);
        }
        for (int k = 0; k < NODES; k++) {
            loss[k] = loss(facets, cosine(k), cosines);
        }
        loss[NODES] = loss[NODES - 1];
        meanLoss = mean();
        spread();
    }

    /** Where the k-th node is. */
    private double cosine(int k) {
        double x = (double) k / (NODES - 1);
        double x2 = x * x;
        return alpha * x2 / Math.fma(1 - x, 1 + x, alpha);
    }

    /**
     * The loss 1 − E at a cosine, 0..1. Nodes are even in sqrt(μ(1 + α)/(μ + α)): the loss is steep at grazing directions, where it changes
     * with μ/α.
     */
    double loss(double cosine) {
        double x = (NODES - 1) * Math.sqrt(cosine * (1 + alpha) / (cosine + alpha));
        int k = Math.min((int) x, NODES - 1);
        return Math.fma(x - k, loss[k + 1] - loss[k], loss[k]);
    }

    /**
     * Over the visible normals of o, in polar coordinates of the disk: the mean of 1 − G2/G1, which is 1 where o is not reflected up. Rings
     * are dense at the edge of the disk, 1 − r² = w⁴ with w even: there are the few steep normals that a smooth surface loses light by.
     */
    private static double loss(Microfacets facets, double out, double[] cosines) {
        double sine = Math.sqrt((1 - out) * (1 + out));
        double x = facets.alpha * sine;
        double scale = 1 / Math.sqrt(Math.fma(x, x, out * out));
        double k = Math.fma(out, scale, 1);
        double total = 0;
        for (int i = 0; i < RINGS; i++) {
            double w = (i + 0.5) / RINGS;
            double edge = w * w * w * w;
            double q = Math.sqrt(k * Math.max(2 - (1 - edge) * k, 0) * (1 - edge));
            double ring = 0;
            for (double c : cosines) {
                double in = reflected(facets.alpha, out, sine, x * scale + q * c, q * q * (1 - c) * (1 + c), k * edge);
                ring += in > 0 ? facets.shadowed(Math.min(in, 1), out) : 1;
            }
            total += 4 * w * w * w * ring;
        }
        return Math.min(total / (RINGS * cosines.length), 1);
    }

    /** The cosine of o's mirror image at the normal of slopes αx and αy over z, with y squared. */
    private static double reflected(double alpha, double out, double sine, double x, double y2, double z) {
        double hx = alpha * x;
        double length2 = Math.fma(hx, hx, Math.fma(z, z, alpha * alpha * y2));
        return 2 * Math.fma(sine, hx, out * z) * z / length2 - out;
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

    /** The density per solid angle, at a cosine, of directions that {@link #sample} chooses; nearly (1 − E(μ))μ/(π(1 − Ē)). */
    double density(double cosine) {
        return density[Math.min((int) (CELLS * Math.sqrt(cosine)), CELLS - 1)] * cosine;
    }

    /** The cosine of a direction in which lost light leaves, from a number that is uniform in 0..1. */
    double sample(double number) {
        int low = 0;
        int high = CELLS;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (below[middle] <= number) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double part = (number - below[low]) / (below[high] - below[low]);
        double from = edge2(low);
        return Math.sqrt(Math.min(Math.fma(part, edge2(high) - from, from), 1));
    }
}
