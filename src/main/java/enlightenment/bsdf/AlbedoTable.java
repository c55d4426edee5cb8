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
    /** Parts of each panel between two nodes, in the mean. */
    private static final int PARTS = 32;

    /** 1 − Ē. */
    final double meanLoss;

    private final double[] loss = new double[NODES + 1];
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

    /** Over the visible normals of o, in polar coordinates of the disk: the mean of 1 − G2/G1, which is 1 where o is not reflected up. */
    private static double loss(Microfacets facets, double out, double[] cosines) {
        double sine = Math.sqrt((1 - out) * (1 + out));
        double scale = 1 / Math.sqrt(Math.fma(facets.alpha * sine, facets.alpha * sine, out * out));
        double x = facets.alpha * sine * scale;
        double k = Math.fma(out, scale, 1);
        double total = 0;
        for (int i = 0; i < RINGS; i++) {
            double r2 = (i + 0.5) / RINGS;
            double q = Math.sqrt(k * Math.max(2 - r2 * k, 0) * r2);
            double hz = k * (1 - r2);
            for (double c : cosines) {
                double hx = facets.alpha * Math.fma(q, c, x);
                double hy2 = facets.alpha * facets.alpha * q * q * (1 - c) * (1 + c);
                double length2 = Math.fma(hx, hx, Math.fma(hz, hz, hy2));
                double in = 2 * Math.fma(sine, hx, out * hz) * hz / length2 - out;
                total += in > 0 ? facets.shadowed(Math.min(in, 1), out) : 1;
            }
        }
        return total / (RINGS * cosines.length);
    }

    /** 2∫(1 − E)μ dμ of the interpolated table, by Simpson's rule in sqrt(μ) between the nodes. */
    private double mean() {
        double total = 0;
        for (int k = 0; k + 1 < NODES; k++) {
            double from = Math.sqrt(cosine(k));
            double step = (Math.sqrt(cosine(k + 1)) - from) / PARTS;
            for (int j = 0; j < PARTS; j++) {
                double v = Math.fma(j, step, from);
                total += step / 6 * (integrand(v) + 4 * integrand(v + 0.5 * step) + integrand(v + step));
            }
        }
        return total;
    }

    private double integrand(double root) {
        return 4 * loss(Math.min(root * root, 1)) * root * root * root;
    }
}
