package enlightenment.method.cluster;

import enlightenment.film.SampleSpread;
import enlightenment.method.Moments;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.path.PathConnections;
import enlightenment.transport.path.PathCut;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * Traces one path for each pixel of a group that needs another sample; the paths may be connected for path reuse. Where objects move while
 * the shutter is open, all paths of a group see the same moment. One per thread.
 */
final class GroupPaths {
    private static final int NONE = -1;

    private final RenderSettings settings;

    /** The scene at each moment, and the path integrator of each. */
    private final CompiledScene[] moments;

    private final PathIntegrator[] tracers;

    /** All path integrators: those of moments, and that at the time of the frame. */
    private final Set<PathIntegrator> all;

    private final Moments lots;

    /** The hash from which the moments of the group's samples follow. */
    private long groupHash;

    private final PixelGroup group;
    private final Ray ray = new Ray();

    /** Samplers set to the pixels of the group; what a sampler computes once per pixel serves all its samples. */
    private final SobolSampler[] samplers = new SobolSampler[PixelGroup.MOST_MEMBERS];

    /** By member: the index of its sample, or {@link #NONE}. */
    private final int[] sampleOf = new int[PixelGroup.MOST_MEMBERS];

    private int size;

    /** By sample: its path, its value, and the deterministic part of that. */
    private final PathCut[] paths = new PathCut[PixelGroup.MOST_MEMBERS];

    private final double[][] colors = new double[PixelGroup.MOST_MEMBERS][3];
    private final double[][] certain = new double[PixelGroup.MOST_MEMBERS][3];
    private final long[] keys = new long[PixelGroup.MOST_MEMBERS];
    private final int[] events = new int[PixelGroup.MOST_MEMBERS];
    private final double[] placeX = new double[PixelGroup.MOST_MEMBERS];
    private final double[] placeY = new double[PixelGroup.MOST_MEMBERS];

    /**
     * @param counters of this thread
     * @param atFrame traces paths in the scene at the time of its frame
     */
    GroupPaths(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            PathIntegrator atFrame,
            PixelGroup group) {
        this.settings = settings;
        this.group = group;
        moments = scene.moments();
        lots = new Moments(moments.length);
        tracers = new PathIntegrator[moments.length];
        Arrays.setAll(
                tracers,
                i -> moments[i] == scene
                        ? atFrame
                        : tracer(moments[i], scene.countersOf(moments[i], counters), atFrame.reusesLight()));
        all = new LinkedHashSet<>(List.of(tracers));
        all.add(atFrame);
        Arrays.setAll(paths, k -> new PathCut());
        Arrays.setAll(samplers, m -> new SobolSampler());
    }

    /** Makes the path integrator of one thread. It reuses light subpaths, too, if that is asked for and possible in the scene. */
    static PathIntegrator tracer(CompiledScene scene, RayCounters counters, boolean reusesLight) {
        return reusesLight ? PathIntegrator.reusingLight(scene, counters) : new PathIntegrator(scene, counters);
    }

    void stopWhen(BooleanSupplier cancelled) {
        for (PathIntegrator tracer : all) {
            tracer.stopWhen(cancelled);
        }
    }

    /** Sets the rectangle of the picture, 0..1, that camera rays come from. */
    void beginTile(double x0, double y0, double x1, double y1) {
        for (PathIntegrator tracer : all) {
            tracer.beginTile(x0, y0, x1, y1);
        }
    }

    /** Sets the samplers to the pixels of the group. */
    void toPixels(long seed) {
        groupHash = group.hash(Hash.of(seed, Moments.PURPOSE));
        for (int m = 0; m < group.members; m++) {
            samplers[m].pixel(seed, group.x(m), group.y(m));
        }
    }

    /**
     * Makes the samples with this number black, in place of {@link #take}.
     *
     * @param counts the number of samples of each member
     */
    void clear(int number, int[] counts) {
        begin(number, counts);
        for (int k = 0; k < size; k++) {
            Arrays.fill(colors[k], 0);
        }
    }

    private void begin(int number, int[] counts) {
        size = 0;
        for (int m = 0; m < group.members; m++) {
            sampleOf[m] = number < counts[m] ? size++ : NONE;
        }
    }

    /** Whether a member has a sample. */
    boolean has(int m) {
        return sampleOf[m] != NONE;
    }

    /**
     * Takes the sample with this number for each member that needs it.
     *
     * @param counts the number of samples of each member
     */
    void take(int number, int[] counts, SharingGain sharing) {
        begin(number, counts);
        int moment = lots.of(groupHash, number);
        boolean reusesLight = tracers[moment].reusesLight();
        boolean shares = reusesLight || sharing.isWorthIt(group.field);
        for (int m = 0; m < group.members; m++) {
            if (has(m)) {
                shade(m, number, sampleOf[m], shares, moment);
            }
        }
        if (shares) {
            PathConnections connections = tracers[moment].connections();
            if (!reusesLight) {
                sharing.before(group.field, paths, colors, size);
            }
            connections.share(paths, size, colors);
            if (!reusesLight) {
                sharing.after(group.field, colors, events, size, connections);
            }
        }
    }

    private void shade(int m, int number, int k, boolean shares, int moment) {
        PathIntegrator tracer = tracers[moment];
        SobolSampler sampler = samplers[m];
        sampler.sample(number);
        placeX[k] = sampler.filmX();
        placeY[k] = sampler.filmY();
        moments[moment].camera.ray(
                (group.x(m) + placeX[k]) / settings.width(),
                (group.y(m) + placeY[k]) / settings.height(),
                sampler,
                ray);
        if (shares) {
            tracer.shade(ray, sampler, paths[k]);
            paths[k].own(colors[k]);
        } else {
            tracer.shade(ray, sampler, colors[k]);
        }
        keys[k] = tracer.certain(certain[k]);
        if (moments.length > 1 || moments[moment].camera.hasLens()) {
            // With a lens or several moments the deterministic part depends on more than the film position, so it is
            // not used.
            Arrays.fill(certain[k], 0);
        }
        events[k] = tracer.events();
    }

    /** Subtracts the interpolation of the pixel's corners, less its mean, from a member's sample: a control variate. */
    void subtract(Interpolation interpolation, int m) {
        int k = sampleOf[m];
        interpolation.subtract(placeX[k], placeY[k], colors[k]);
    }

    /** The value of a member's sample: red, green and blue. */
    double[] color(int m) {
        return colors[sampleOf[m]];
    }

    /** Records a member's sample, which has this number in its pixel, in the noise statistics. */
    void tell(PathNoise noise, int m, int number) {
        int i = group.column[m];
        int j = group.row[m];
        int k = sampleOf[m];
        double known = noise.isQuiet(i, j) ? 0 : 1;
        double[] color = colors[k];
        double[] c = certain[k];
        noise.tell(
                i,
                j,
                number,
                keys[k],
                2 + events[k],
                color[0] - known * c[0],
                color[1] - known * c[1],
                color[2] - known * c[2]);
    }

    /** Passes the position within its pixel of a member's sample to the spread, which receives that sample next. */
    void place(SampleSpread spread, int m, int number) {
        samplers[m].sample(number);
        spread.at(samplers[m].filmX(), samplers[m].filmY());
    }
}
