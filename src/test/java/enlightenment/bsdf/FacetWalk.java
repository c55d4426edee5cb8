package enlightenment.bsdf;

import enlightenment.math.Vec3;
import java.util.SplittableRandom;

/**
 * Light that goes from facet to facet of a rough interface of two media until it leaves: E. Heitz, J. Hanika, E. d'Eon and C. Dachsbacher,
 * "Multiple-scattering microfacet BSDFs with the Smith model" (2016). Facets have GGX's normals, and heights uniform in 0..1 that are
 * independent of each other.
 */
final class FacetWalk {
    private final double alpha;
    private final SplittableRandom random;

    FacetWalk(double alpha, SplittableRandom random) {
        this.alpha = alpha;
        this.random = random;
    }

    /**
     * Whether light passes the surface.
     *
     * @param out towards where it comes from
     * @param eta the index there over that on the other side
     */
    boolean passes(Vec3 out, double eta) {
        // The frame is turned over whenever light is on the other side: it is always above the facets, in its own
        // frame.
        Vec3 w = out.negated();
        double height = 1;
        boolean isBeyond = false;
        while (true) {
            height = nextHeight(w.z(), height);
            if (height > 1) {
                return isBeyond;
            }
            Vec3 o = w.negated();
            Vec3 m = visible(o);
            double c = Math.min(Math.max(o.dot(m), 0), 1);
            double ratio = isBeyond ? 1 / eta : eta;
            if (random.nextDouble() < DielectricFresnel.reflectance(c, ratio)) {
                w = m.times(2 * c).minus(o).normalized();
            } else {
                double beyond = Math.sqrt(DielectricFresnel.refracted2(c, ratio));
                Vec3 t = m.times(ratio * c - beyond).minus(o.times(ratio)).normalized();
                w = new Vec3(t.x(), t.y(), -t.z());
                height = 1 - height;
                isBeyond = !isBeyond;
            }
        }
    }

    /** Where light that goes with this slope meets the next facet; above 1 if nowhere. */
    private double nextHeight(double z, double height) {
        double number = random.nextDouble();
        double tan2 = (1 - z * z) / (z * z);
        double lambda = 0.5 * (Math.signum(z) * Math.sqrt(1 + alpha * alpha * tan2) - 1);
        if (z > 0 && number >= 1 - Math.pow(height, lambda)) {
            return 2;
        }
        double next = lambda == 0 ? 2 : height / Math.pow(1 - number, 1 / lambda);
        return lambda == -1 ? height * (1 - number) : next;
    }

    /** A normal that is visible from a direction, be that above or below the horizon. */
    private Vec3 visible(Vec3 o) {
        Vec3 s = new Vec3(alpha * o.x(), alpha * o.y(), o.z()).normalized();
        double z = (1 - random.nextDouble()) * (1 + s.z()) - s.z();
        double sine = Math.sqrt(Math.max(0, 1 - z * z));
        double turn = 2 * Math.PI * random.nextDouble();
        Vec3 h = new Vec3(sine * Math.cos(turn), sine * Math.sin(turn), z).plus(s);
        return new Vec3(alpha * h.x(), alpha * h.y(), h.z()).normalized();
    }
}
