package enlightenment.classic.cluster;

import enlightenment.sampling.Distribution;
import enlightenment.sampling.Warp;
import java.util.Arrays;

/**
 * Rays that pass close to each other on the film and share the last surface and the light: where on the light they end
 * decides whether they are valid. The cluster proposes light points from a mixture
 *
 * <p>q = α · even + (1 − α) · Σ share_k · lobe_k,
 *
 * <p>whose lobes are fitted to the rarer kind of point, be that the visible or the hidden ones: a shadow's share of the light
 * is one minus the light's. The even part (defensive sampling) keeps every weight at most 1/α, whatever the lobes miss.
 */
final class ClusterProposal {
    private static final int MOST_LOBES = 2;

    /** With fewer points than this nothing is fitted. */
    private static final int ENOUGH = 6;

    /** Each of two lobes must have this many points to be told from chance. */
    private static final int ENOUGH_FOR_TWO = 16;

    /** Rounds of assigning points to the nearer lobe and fitting again. */
    private static final int ROUNDS = 6;

    /** Points on which the gain of a fit is judged. */
    private static final int JUDGES = 64;

    /** A proposal must be expected to divide the variance by this: sampling it costs, and stratification is lost. */
    private static final double WORTHWHILE = 3;

    private static final double EVEN_DENSITY = 1 / Math.PI;
    private static final double[] EVEN_SHARES = {0.125, 0.25, 0.5};

    private int surface;
    private int light;
    private int bounce;

    /** What was watched: film x and y, place p and q, four numbers each; hidden ones and visible ones apart. */
    private final Points[] watched = {new Points(), new Points()};

    private final Lobe[] lobes = new Lobe[MOST_LOBES];
    private int lobeCount;
    private boolean wantsBlocked;
    private double even;
    private double judgedGain;
    private final double[] disk = new double[3];

    /** The proposed place. */
    double p;

    double q;

    ClusterProposal(Distribution family) {
        for (int k = 0; k < MOST_LOBES; k++) {
            lobes[k] = new Lobe(family);
        }
    }

    void begin(int surfaceId, int lightIndex, int bounces) {
        surface = surfaceId;
        light = lightIndex;
        bounce = bounces;
        watched[0].clear();
        watched[1].clear();
        lobeCount = 0;
    }

    boolean is(int surfaceId, int lightIndex, int bounces) {
        return surface == surfaceId && light == lightIndex && bounce == bounces;
    }

    boolean wantsBlocked() {
        return wantsBlocked;
    }

    /** How many times smaller the variance of a light point was expected to become; 1 without proposals. */
    double judgedGain() {
        return lobeCount == 0 ? 1 : judgedGain;
    }

    /** How many points of the rarer kind were watched. */
    int rare() {
        return Math.min(watched[0].size, watched[1].size);
    }

    /** How many light points were watched. */
    int watched() {
        return watched[0].size + watched[1].size;
    }

    /** The variance that its watched points show, times their number. */
    double doubt() {
        return (double) watched[0].size * watched[1].size / Math.max(watched(), 1);
    }

    void watch(double x, double y, double pp, double qq, boolean blocked) {
        watched[blocked ? 1 : 0].add(x, y, pp, qq);
    }

    /** Fits lobes to the rarer kind of points; returns whether they are worth using. */
    boolean fit() {
        wantsBlocked = watched[1].size < watched[0].size;
        Points points = watched[wantsBlocked ? 1 : 0];
        int all = watched[0].size + watched[1].size;
        lobeCount = 0;
        if (points.size < ENOUGH) {
            return false;
        }
        // Half the mean distance between the watched places: nothing finer can have been seen.
        double finest = Math.sqrt(Math.PI / all) / 2;
        double best = WORTHWHILE;
        int chosen = 0;
        double share = 0;
        for (int count = 1; count <= MOST_LOBES; count++) {
            if (!place(points, count, finest)) {
                break;
            }
            for (double candidate : EVEN_SHARES) {
                double gain = gain(points, all, candidate);
                if (gain > best) {
                    best = gain;
                    chosen = count;
                    share = candidate;
                }
            }
        }
        if (chosen > 0) {
            place(points, chosen, finest);
        }
        lobeCount = chosen;
        even = share;
        judgedGain = best;
        return chosen > 0;
    }

    private boolean place(Points points, int count, double finest) {
        Lobe whole = lobes[0];
        whole.clear(finest);
        for (int k = 0; k < points.size; k++) {
            whole.add(points.x(k), points.y(k), points.p(k), points.q(k), 1);
        }
        whole.fit();
        lobeCount = count;
        if (count == 1) {
            whole.share = 1;
            return true;
        }
        lobes[1].clear(finest);
        lobes[1].copyShape(whole);
        double apart = whole.deviation();
        lobes[0].move(apart);
        lobes[1].move(-apart);
        for (int round = 0; round < ROUNDS; round++) {
            assign(points);
            if (lobes[0].weight() < ENOUGH_FOR_TWO || lobes[1].weight() < ENOUGH_FOR_TWO) {
                return false;
            }
            lobes[0].fit();
            lobes[1].fit();
        }
        shares();
        return true;
    }

    private void assign(Points points) {
        lobes[0].forget();
        lobes[1].forget();
        for (int k = 0; k < points.size; k++) {
            nearest(points.x(k), points.y(k), points.p(k), points.q(k), 2)
                    .add(points.x(k), points.y(k), points.p(k), points.q(k), 1);
        }
    }

    private Lobe nearest(double x, double y, double pp, double qq, int count) {
        Lobe best = lobes[0];
        if (count > 1 && lobes[1].distance(x, y, pp, qq) < best.distance(x, y, pp, qq)) {
            best = lobes[1];
        }
        return best;
    }

    private void shares() {
        double sum = 0;
        for (int k = 0; k < lobeCount; k++) {
            sum += lobes[k].weight();
        }
        for (int k = 0; k < lobeCount; k++) {
            lobes[k].share = lobes[k].weight() / sum;
        }
    }

    /** The variance with even points over that with proposals, estimated from the points themselves. */
    private double gain(Points points, int all, double candidate) {
        even = candidate;
        double f = (double) points.size / all;
        int step = Math.max(points.size / JUDGES, 1);
        double second = 0;
        int judges = 0;
        for (int k = 0; k < points.size; k += step) {
            aim(points.x(k), points.y(k));
            second += weight(points.p(k), points.q(k));
            judges++;
        }
        // Laplace's rule of succession: the next point may be one that only the even part finds.
        second = (second + 1 / candidate) * f / (judges + 1);
        double variance = Math.max(second - f * f, 0);
        return f * (1 - f) / variance;
    }

    /** Whether it has proposals; if not, points are to be spread evenly. */
    boolean proposes() {
        return lobeCount > 0;
    }

    /** Prepares proposals for a film position. */
    void aim(double x, double y) {
        for (int k = 0; k < lobeCount; k++) {
            lobes[k].aim(x, y);
        }
    }

    /** Chooses p and q; returns the weight, 0 outside the disk. */
    double propose(double u, double v) {
        if (u < even) {
            Warp.toDisk(u / even, v, disk);
            p = disk[0];
            q = disk[1];
            return weight(p, q);
        }
        double rest = (u - even) / (1 - even);
        Lobe lobe = lobes[0];
        if (lobeCount > 1 && rest >= lobe.share) {
            rest = (rest - lobe.share) / (1 - lobe.share);
            lobe = lobes[1];
        } else {
            rest /= lobe.share;
        }
        lobe.propose(rest, v);
        p = lobe.p;
        q = lobe.q;
        return p * p + q * q > 1 ? 0 : weight(p, q);
    }

    /** Even density over the mixture's, within the disk. */
    private double weight(double pp, double qq) {
        double guided = 0;
        for (int k = 0; k < lobeCount; k++) {
            guided += lobes[k].share * lobes[k].density(pp, qq);
        }
        return EVEN_DENSITY / (even * EVEN_DENSITY + (1 - even) * guided);
    }

    /** A valid ray joins the cluster; it counts as many times as its like are missing among the proposals. */
    void accept(double x, double y, double pp, double qq, double weight) {
        nearest(x, y, pp, qq, lobeCount).add(x, y, pp, qq, weight);
    }

    /** Fits the lobes again, with all that was accepted. */
    void learn() {
        for (int k = 0; k < lobeCount; k++) {
            lobes[k].fit();
        }
        if (lobeCount > 1) {
            shares();
        }
    }

    /** Points as one growing array. */
    private static final class Points {
        private double[] values = new double[256];
        private int size;

        void clear() {
            size = 0;
        }

        void add(double x, double y, double p, double q) {
            if (4 * size == values.length) {
                values = Arrays.copyOf(values, 2 * values.length);
            }
            int k = 4 * size++;
            values[k] = x;
            values[k + 1] = y;
            values[k + 2] = p;
            values[k + 3] = q;
        }

        double x(int k) {
            return values[4 * k];
        }

        double y(int k) {
            return values[4 * k + 1];
        }

        double p(int k) {
            return values[4 * k + 2];
        }

        double q(int k) {
            return values[4 * k + 3];
        }
    }
}
