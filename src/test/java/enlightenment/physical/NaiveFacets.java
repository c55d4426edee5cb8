package enlightenment.physical;

import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/** The distribution GGX of facets, isotropic, with Smith's masking correlated in height, as Walter (2007) and Heitz (2014) print it. */
final class NaiveFacets {
    private static final int NODES = 64;
    private static final int SIDE = 128;

    private final double alpha;
    private double[] albedo;
    private double mean;

    NaiveFacets(double alpha) {
        this.alpha = alpha;
    }

    double distribution(Vec3 m) {
        double t = m.z() * m.z() * (alpha * alpha - 1) + 1;
        return alpha * alpha / (Math.PI * t * t);
    }

    private double lambda(Vec3 w) {
        double tangent = Math.sqrt(Math.max(0, 1 - w.z() * w.z())) / w.z();
        return (Math.sqrt(1 + alpha * alpha * tangent * tangent) - 1) / 2;
    }

    /** G2 of two directions, on one side or on both. */
    double visible(Vec3 a, Vec3 b) {
        return 1 / (1 + lambda(a) + lambda(b));
    }

    /** A facet's normal with the density D·cos (Walter's equation 35). */
    Vec3 sample(SplittableRandom random) {
        return facet(random.nextDouble(), random.nextDouble());
    }

    /** The normal of that density for a point of the unit square. */
    Vec3 facet(double u, double v) {
        double theta = Math.atan(alpha * Math.sqrt(u / (1 - u)));
        double phi = 2 * Math.PI * v;
        return new Vec3(Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta));
    }

    /** The share of light from one direction that single scattering reflects if the facets reflect all; see {@link #meanAlbedo}. */
    double albedo(double mu) {
        table();
        double place = Math.sqrt(mu) * NODES;
        int k = Math.min(NODES - 1, (int) place);
        return albedo[k] + (place - k) * (albedo[k + 1] - albedo[k]);
    }

    /** Its mean over all directions by the cosine. */
    double meanAlbedo() {
        table();
        return mean;
    }

    private synchronized void table() {
        if (albedo != null) {
            return;
        }
        double[] e = new double[NODES + 1];
        for (int k = 0; k <= NODES; k++) {
            double root = Math.max(k, 0.02) / NODES;
            e[k] = reflected(root * root);
        }
        albedo = e;
        int n = 10_000;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double mu = (i + 0.5) / n;
            sum += 2 * mu * albedo(mu) / n;
        }
        mean = sum;
    }

    private double reflected(double mu) {
        Vec3 out = new Vec3(Math.sqrt(1 - mu * mu), 0, mu);
        double sum = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            Vec3 m = facet((i / SIDE + 0.5) / SIDE, (i % SIDE + 0.5) / SIDE);
            double c = out.dot(m);
            Vec3 in = m.times(2 * c).minus(out);
            if (c > 0 && in.z() > 0) {
                sum += visible(out, in) * c / (mu * m.z());
            }
        }
        return sum / (SIDE * SIDE);
    }
}
