package enlightenment.physical;

import enlightenment.material.Coated;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/**
 * A dielectric coat over a matte base: what the coat does not reflect enters it, the base reflects it evenly, what the coat reflects back
 * from below comes to the base again, and the rest leaves. Under a smooth coat only what has entered is scattered here.
 */
final class NaiveCoat extends NaiveReflector {
    private static final int NODES = 96;
    private static final int SIDE = 160;
    private static final int STEPS = 20_000;

    private final double index;
    private final NaiveFacets facets;
    private final double[] entering = new double[NODES + 1];
    private final double[] again = new double[3];
    private final double mean;

    NaiveCoat(double[] color, Coated material) {
        index = material.indexOfRefraction();
        double alpha = NaiveAmount.squared(material.roughness());
        facets = alpha > 0 ? new NaiveFacets(alpha) : null;
        for (int k = 0; facets != null && k <= NODES; k++) {
            double root = Math.max(k, 0.02) / NODES;
            entering[k] = 1 - reflected(root * root);
        }
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double mu = (i + 0.5) / STEPS;
            sum += 2 * mu * through(mu) / STEPS;
        }
        mean = sum;
        // Of isotropic light below, what leaves is what enters from all sides, over the squared index.
        double back = 1 - mean / (index * index);
        for (int band = 0; band < 3; band++) {
            double reflectance = material.nonlinear() ? color[band] : 1;
            double first = material.nonlinear() ? 1 : color[band];
            for (int round = 0; round < 2_000; round++) {
                again[band] += first * reflectance * (1 - back) * Math.pow(reflectance * back, round);
            }
        }
    }

    boolean isSmooth() {
        return facets == null;
    }

    double fresnel(double cosine) {
        return NaiveFresnel.dielectric(cosine, 1, index);
    }

    /** The share of light that enters the coat. */
    double through(double mu) {
        if (facets == null) {
            return 1 - fresnel(mu);
        }
        double place = Math.sqrt(mu) * NODES;
        int k = Math.min(NODES - 1, (int) place);
        return entering[k] + (place - k) * (entering[k + 1] - entering[k]);
    }

    private double reflected(double mu) {
        Vec3 out = new Vec3(Math.sqrt(1 - mu * mu), 0, mu);
        double sum = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            Vec3 m = facets.facet((i / SIDE + 0.5) / SIDE, (i % SIDE + 0.5) / SIDE);
            double c = out.dot(m);
            Vec3 in = m.times(2 * c).minus(out);
            if (c > 0 && in.z() > 0) {
                sum += fresnel(Math.min(1, c)) * facets.visible(out, in) * c / (mu * m.z());
            }
        }
        return sum / (SIDE * SIDE);
    }

    @Override
    double value(int band, Vec3 out, Vec3 in) {
        double base = again[band] * through(in.z()) / (Math.PI * mean);
        if (facets == null) {
            return base;
        }
        return lobe(out, in) + through(out.z()) * base;
    }

    /** What a rough coat itself reflects. */
    double lobe(Vec3 out, Vec3 in) {
        Vec3 m = out.plus(in).normalized();
        return fresnel(Math.min(1, out.dot(m)))
                * facets.distribution(m)
                * facets.visible(out, in)
                / (4 * out.z() * in.z());
    }

    @Override
    Vec3 sample(Vec3 out, SplittableRandom random) {
        if (facets == null || random.nextBoolean()) {
            return byCosine(random);
        }
        Vec3 m = facets.sample(random);
        Vec3 in = m.times(2 * out.dot(m)).minus(out);
        return in.z() > 0 && out.dot(m) > 0 ? in : null;
    }

    @Override
    double density(Vec3 out, Vec3 in) {
        double even = in.z() / Math.PI;
        if (facets == null) {
            return even;
        }
        Vec3 m = out.plus(in).normalized();
        return 0.5 * even + 0.5 * facets.distribution(m) * m.z() / (4 * out.dot(m));
    }
}
