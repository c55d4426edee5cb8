package enlightenment.physical;

import enlightenment.math.Vec3;

/** What becomes of light that rough glass loses by single scattering (docs/notes/bsdfs.md), by brute force. */
final class NaiveInterface {
    private static final int NODES = 64;
    private static final int SIDE = 128;

    private final NaiveFacets facets;
    /** What is lost of light that comes to the surface on the side of {@code from}, and on the other one, over sqrt(μ). */
    private final double[] here;

    private final double[] there;

    private final double meanHere;
    private final double meanThere;

    /** The share of what is lost here that comes through. */
    private final double through;

    NaiveInterface(double alpha, double from, double to) {
        facets = new NaiveFacets(alpha);
        here = table(from, to);
        there = table(to, from);
        meanHere = mean(here);
        meanThere = mean(there);
        double smooth = 0;
        int n = 2000;
        for (int i = 0; i < n; i++) {
            double mu = (i + 0.5) / n;
            smooth += 2 * mu * NaiveFresnel.dielectric(mu, Math.min(from, to), Math.max(from, to)) / n;
        }
        double flux = (from < to ? meanHere : meanThere)
                * (1 - smooth * (1 - 0.75 * alpha))
                * Math.min(from, to)
                * Math.min(from, to);
        through = flux / (meanHere * from * from);
    }

    /** What single scattering loses of light that comes on the side of {@code from} with this cosine: about 0 to 1. */
    double lost(double mu) {
        return loss(here, mu);
    }

    /** The share of what is lost there that comes through. */
    double through() {
        return through;
    }

    /** The value for importance of two directions with these cosines, not negative. */
    double value(double out, double in, boolean isThrough) {
        double[] other = isThrough ? there : here;
        double part = isThrough ? through : 1 - through;
        return part * loss(here, out) * loss(other, in) / (Math.PI * (isThrough ? meanThere : meanHere));
    }

    private static double loss(double[] table, double mu) {
        double place = Math.sqrt(mu) * NODES;
        int k = Math.min(NODES - 1, (int) place);
        return table[k] + (place - k) * (table[k + 1] - table[k]);
    }

    private static double mean(double[] table) {
        int n = 2000;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double mu = (i + 0.5) / n;
            sum += 2 * mu * loss(table, mu) / n;
        }
        return sum;
    }

    private double[] table(double one, double other) {
        double[] losses = new double[NODES + 1];
        for (int k = 0; k <= NODES; k++) {
            double root = Math.max(k, 0.02) / NODES;
            losses[k] = 1 - kept(root * root, one, other);
        }
        return losses;
    }

    private double kept(double mu, double one, double other) {
        Vec3 out = new Vec3(Math.sqrt(1 - mu * mu), 0, mu);
        double sum = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            Vec3 m = facets.facet((i / SIDE + 0.5) / SIDE, (i % SIDE + 0.5) / SIDE);
            double c = out.dot(m);
            if (c <= 0) {
                continue;
            }
            double reflected = NaiveFresnel.dielectric(c, one, other);
            double weight = c / (mu * m.z());
            Vec3 back = m.times(2 * c).minus(out);
            if (back.z() > 0) {
                sum += reflected * weight * facets.visible(out, back);
            }
            double beyond = NaiveFresnel.refracted(Math.min(1, c), one, other);
            if (!Double.isNaN(beyond)) {
                Vec3 on = m.times(one / other * c - beyond).minus(out.times(one / other));
                if (on.z() < 0) {
                    sum += (1 - reflected) * weight * facets.visible(out, on.negated());
                }
            }
        }
        return sum / (SIDE * SIDE);
    }
}
