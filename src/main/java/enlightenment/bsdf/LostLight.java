package enlightenment.bsdf;

import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * Compensation of the energy loss at a rough interface of any two media: {@link LostAtInterface} for indices of refraction n that are uniform
 * in the square root of (n − 1)/(n + 1), interpolated in between. Tables are made at the first use, some milliseconds each; their content
 * does not depend on when.
 *
 * <p>A <i>place</i> is the position of an interface among these indices: the number of the lower one plus the fraction towards the next.
 */
final class LostLight {
    private static final int NODES = 64;

    private final Microfacets facets;
    private final AtomicReferenceArray<LostAtInterface> nodes = new AtomicReferenceArray<>(NODES + 1);

    LostLight(Microfacets facets) {
        this.facets = facets;
    }

    /** The place of an interface; {@code eta} is the index on one side over that on the other. */
    static double place(double eta) {
        double index = Math.max(eta, 1 / eta);
        double t = (index - 1) / (index + 1);
        return NODES * Math.sqrt(t < 1 ? t : 1);
    }

    private LostAtInterface node(int k) {
        LostAtInterface known = nodes.getAcquire(k);
        return known == null ? make(k) : known;
    }

    private synchronized LostAtInterface make(int k) {
        LostAtInterface node = nodes.get(k);
        if (node == null) {
            double root = (double) k / NODES;
            // At the last node one medium is infinitely dense, up to this.
            double t = Math.min(root * root, 1 - Math.ulp(1f));
            node = new LostAtInterface(facets, (1 + t) / (1 - t));
            nodes.setRelease(k, node);
        }
        return node;
    }

    private AlbedoTable table(int k, boolean isDense) {
        LostAtInterface node = node(k);
        return isDense ? node.dense : node.rare;
    }

    private static int low(double place) {
        return Math.min((int) place, NODES - 1);
    }

    private static double between(double part, double low, double high) {
        return Math.fma(part, high - low, low);
    }

    /** The loss 1 − E on one side at a cosine, 0..1. */
    double loss(double place, boolean isDense, double cosine) {
        int k = low(place);
        return between(
                place - k, table(k, isDense).loss(cosine), table(k + 1, isDense).loss(cosine));
    }

    /** The cosine-weighted mean of the loss on one side. */
    double meanLoss(double place, boolean isDense) {
        int k = low(place);
        return between(place - k, table(k, isDense).meanLoss, table(k + 1, isDense).meanLoss);
    }

    /**
     * The share of the light lost on one side that is transmitted to the other.
     *
     * @param eta the index on this side over that on the other
     */
    double through(double place, boolean isDense, double eta) {
        int k = low(place);
        double flux = between(place - k, node(k).through, node(k + 1).through);
        double square = isDense ? eta * eta : 1;
        return Math.min(flux / (meanLoss(place, isDense) * square), 1);
    }

    /** The density per solid angle, at a cosine, of directions that {@link #sample} selects on a side. */
    double density(double place, boolean isDense, double cosine) {
        int k = low(place);
        AlbedoTable a = table(k, isDense);
        AlbedoTable b = table(k + 1, isDense);
        double sum = between(place - k, a.meanLoss * a.density(cosine), b.meanLoss * b.density(cosine));
        return sum / between(place - k, a.meanLoss, b.meanLoss);
    }

    /** Samples the cosine of a direction in which lost light leaves on a side, by a number uniform in 0..1. */
    double sample(double place, boolean isDense, double number) {
        int k = low(place);
        AlbedoTable a = table(k, isDense);
        AlbedoTable b = table(k + 1, isDense);
        double share = (1 - (place - k)) * a.meanLoss;
        return a.sample(b, share / Math.fma(place - k, b.meanLoss, share), number);
    }
}
