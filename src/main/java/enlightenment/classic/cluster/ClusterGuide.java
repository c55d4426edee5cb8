package enlightenment.classic.cluster;

import enlightenment.classic.shading.LightGuide;
import enlightenment.classic.shading.LightSamples;
import enlightenment.classic.shading.PathReport;
import enlightenment.film.FilmTile;
import enlightenment.sampling.Distribution;
import enlightenment.sampling.Warp;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;

/**
 * The ray clusters of one block: its paths grouped by last surface, light and number of bounces before. First it only
 * watches where the light is hidden and where not; then it proposes light points and learns from what becomes of them.
 */
final class ClusterGuide implements LightGuide {
    private final Distribution family;
    private final RayCounters counters;
    private final List<ClusterProposal> pool = new ArrayList<>();
    private int size;
    private ClusterProposal current;
    private boolean proposing;
    private double gain;

    /** The film position that is being sampled, in pixels from the block's middle. */
    private double x;

    private double y;
    /** The middle of the pixel, and which cluster's proposals are made for it. */
    private double middleX;

    private double middleY;
    private ClusterProposal aimed;
    private double p;
    private double q;
    private final double[] disk = new double[3];

    ClusterGuide(Distribution family, RayCounters counters) {
        this.family = family;
        this.counters = counters;
    }

    /** Forgets everything and starts to watch. */
    void reset() {
        size = 0;
        proposing = false;
    }

    /** Sets the film position, in pixels from the block's upper left corner. */
    void at(double i, double j) {
        x = i - FilmTile.BLOCK_SIDE / 2.0;
        y = j - FilmTile.BLOCK_SIDE / 2.0;
    }

    /**
     * Turns to a pixel: until the next one, proposals are those for its middle, since preparing them costs more than they change
     * within it.
     */
    void pixel(int i, int j) {
        middleX = i + 0.5 - FilmTile.BLOCK_SIDE / 2.0;
        middleY = j + 0.5 - FilmTile.BLOCK_SIDE / 2.0;
        aimed = null;
    }

    /** Ends the watching: fits proposals. Returns whether any cluster has some worth using. */
    boolean fit() {
        proposing = true;
        boolean any = false;
        double before = 0;
        double after = 0;
        for (int k = 0; k < size; k++) {
            ClusterProposal c = pool.get(k);
            if (c.fit()) {
                any = true;
                counters.clusters++;
            }
            before += c.doubt();
            after += c.doubt() / c.judgedGain();
        }
        gain = after > 0 ? before / after : 1;
        return any;
    }

    /** The gain that one cluster's proposals are judged to have; 1 if it proposes nothing. */
    double gain(int surface, int light, int bounce) {
        ClusterProposal c = find(surface, light, bounce);
        return c == null ? 1 : c.judgedGain();
    }

    /** The points of the rarer kind in the cluster that has most of them. */
    int rarePoints() {
        int most = 0;
        for (int k = 0; k < size; k++) {
            most = Math.max(most, pool.get(k).rare());
        }
        return most;
    }

    /**
     * How many times smaller the variance of the light points of all clusters together is expected to become: one light that is
     * well proposed does not make the others' noise smaller.
     */
    double gain() {
        return gain;
    }

    /** Lets what was accepted since the last time change the proposals. */
    void learn() {
        for (int k = 0; k < size; k++) {
            pool.get(k).learn();
        }
    }

    @Override
    public boolean begin(int surface, int light, int bounce) {
        current = find(surface, light, bounce);
        if (!proposing) {
            if (current == null) {
                current = add(surface, light, bounce);
            }
            return true;
        }
        if (current == null || !current.proposes()) {
            return false;
        }
        if (current != aimed) {
            current.aim(middleX, middleY);
            aimed = current;
        }
        return true;
    }

    private ClusterProposal find(int surface, int light, int bounce) {
        for (int k = 0; k < size; k++) {
            ClusterProposal c = pool.get(k);
            if (c.is(surface, light, bounce)) {
                return c;
            }
        }
        return null;
    }

    private ClusterProposal add(int surface, int light, int bounce) {
        if (size == pool.size()) {
            pool.add(new ClusterProposal(family));
        }
        ClusterProposal c = pool.get(size++);
        c.begin(surface, light, bounce);
        return c;
    }

    @Override
    public double propose(double u, double v) {
        if (!proposing) {
            Warp.toDisk(u, v, disk);
            p = disk[0];
            q = disk[1];
            return 1;
        }
        counters.proposals++;
        double weight = current.propose(u, v);
        p = current.p;
        q = current.q;
        return weight;
    }

    @Override
    public double p() {
        return p;
    }

    @Override
    public double q() {
        return q;
    }

    @Override
    public boolean wantsBlocked() {
        return current.wantsBlocked();
    }

    /** Takes in what became of the light points that it proposed for the last path. */
    void read(PathReport report) {
        LightSamples samples = report.guided;
        for (int k = 0; k < samples.size(); k++) {
            double weight = samples.number(k, PathReport.WEIGHT);
            double pp = samples.number(k, PathReport.P);
            double qq = samples.number(k, PathReport.Q);
            tell(samples.surface(k), samples.light(k), samples.bounce(k), pp, qq, weight, samples.isBlocked(k));
        }
    }

    /** Takes in whether a light point was hidden. */
    void tell(int surface, int light, int bounce, double pp, double qq, double weight, boolean blocked) {
        ClusterProposal cluster = find(surface, light, bounce);
        if (!proposing) {
            cluster.watch(x, y, pp, qq, blocked);
        } else if (blocked == cluster.wantsBlocked()) {
            counters.accepted++;
            cluster.accept(x, y, pp, qq, weight);
        }
    }
}
