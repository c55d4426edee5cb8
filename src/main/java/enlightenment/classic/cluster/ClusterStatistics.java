package enlightenment.classic.cluster;

import enlightenment.method.Block;
import enlightenment.sampling.RunningStatistics;

/**
 * The statistics of a ray cluster as the paper describes it: of rays through one block of the picture that end on the same
 * surface and light, the distribution of each coordinate of their three points. Only valid rays count: those whose light point is visible.
 */
public final class ClusterStatistics {
    /** Film point, surface point and light point have three coordinates each. */
    public static final int COORDINATES = 9;

    public final int blockX;
    public final int blockY;
    public final int surface;
    public final int light;
    public final int bounces;
    private final RunningStatistics[] coordinates = new RunningStatistics[COORDINATES];
    private long tried;
    private double gain = 1;

    ClusterStatistics(Block block, int surface, int light, int bounces) {
        blockX = block.x();
        blockY = block.y();
        this.surface = surface;
        this.light = light;
        this.bounces = bounces;
        for (int k = 0; k < COORDINATES; k++) {
            coordinates[k] = new RunningStatistics();
        }
    }

    boolean is(int surfaceId, int lightIndex, int bounce) {
        return surface == surfaceId && light == lightIndex && bounces == bounce;
    }

    void reject() {
        tried++;
    }

    void accept(double[] points) {
        tried++;
        for (int k = 0; k < COORDINATES; k++) {
            coordinates[k].add(points[k]);
        }
    }

    void gain(double judged) {
        gain = judged;
    }

    /** Rays that were tried, valid or not. */
    public long tried() {
        return tried;
    }

    /** How many times smaller proposals were expected to make the variance of a light point; 1 where none were used. */
    public double gain() {
        return gain;
    }

    /**
     * The distribution of a coordinate over the valid rays, in the scene's compiled frame: 0..2 of the point on the window, 3..5
     * of that on the surface, 6..8 of that on the light.
     */
    public RunningStatistics coordinate(int k) {
        return coordinates[k];
    }
}
