package enlightenment.shading;

import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.LightStarts;
import enlightenment.compiled.RayCounters;
import enlightenment.film.SplatBatch;
import java.util.function.BooleanSupplier;

/**
 * What paths from lights bring to the eye straight: of all strategies of {@link BidirectionalTracer} the one whose light may fall
 * anywhere. The paths are others than those that tiles follow, with the same densities.
 */
public final class BidirectionalLightTracer {
    /** How many of these paths there are for each path from the eye. */
    public static final double PATHS_PER_SAMPLE = 1;

    private final LightSubpath light;
    private final EyeConnection eye;
    private final ReverseDensity reverse = new ReverseDensity();
    private final PathSampler sampler;
    private final int width;
    private final int height;

    /** Null but in tests. */
    private Strategies strategies;

    /** Where light is put; null if only its sum is wanted. */
    private SplatBatch out;

    private double brought;

    /**
     * For one thread.
     *
     * @param scene whose shading is physical
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     */
    public BidirectionalLightTracer(CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        this.width = width;
        this.height = height;
        light = new LightSubpath(scene, new LightStarts(scene, false), counters);
        eye = new EyeConnection(scene, counters, light.path, true);
        sampler = new PathSampler(seed);
    }

    /** Lets somebody look at what is found. */
    void watch(Strategies by) {
        strategies = by;
    }

    /** The path that was followed last. */
    LightSubpath light() {
        return light;
    }

    /** Ends {@link #trace} by a {@link java.util.concurrent.CancellationException} soon after this becomes true. */
    public void stopWhen(BooleanSupplier condition) {
        light.path.poll.stopWhen(condition);
    }

    /** Follows the path with this number and adds what it brings to the picture. */
    public void trace(long number, SplatBatch to) {
        out = to;
        follow(number);
    }

    /**
     * What a path contributes to the picture in the mean ({@link SplatBatch#add}), by some paths with numbers of their own; positive, even
     * if none of them reaches the eye, unless nothing shines.
     */
    public double meanContribution(int paths) {
        out = null;
        brought = 0;
        double power = 0;
        for (int i = 1; i <= paths; i++) {
            power += follow(-i) ? light.power() : 0;
        }
        // In the frame lengths are about 1, and so is the importance of what the eye sees.
        double least = power / (paths * (double) paths);
        return Math.min(Math.max(brought / paths, least), Double.MAX_VALUE);
    }

    private boolean follow(long number) {
        sampler.path(number);
        boolean begins = light.begin(sampler);
        boolean goes = begins;
        while (goes) {
            goes = switch (light.next(sampler)) {
                case SURFACE, BORDER -> light.mayScatter() && scatter();
                case PASSED -> true;
                case NOTHING, ENDED -> false;
            };
        }
        return begins;
    }

    private boolean scatter() {
        if (!light.bsdf.isDelta()) {
            connect();
        }
        return light.leave(sampler);
    }

    /** Adds what the eye sees of the path's light at the surface that it is at. */
    private void connect() {
        if (!eye.project() || out != null && !out.covers(eye.x() * width, eye.y() * height)) {
            return;
        }
        Scattering s = light.s;
        if (!eye.sees(light.bsdf, s, light.isBorder ? light.color : null)) {
            return;
        }
        double weight = weight(Math.abs(s.ix * s.nx + s.iy * s.ny + s.iz * s.nz));
        int vertices = light.vertices.size() + 1;
        double f = eye.importance() * (strategies == null ? weight : strategies.weight(vertices, 1, weight));
        PathWavelength wavelength = light.path.glass.wavelength;
        if (wavelength != null) {
            double common = wavelength.common(s, light.isBorder);
            s.valueR *= wavelength.red(common);
            s.valueG *= wavelength.green(common);
            s.valueB *= wavelength.blue(common);
        }
        add(
                f * eye.through[0] * s.valueR * light.red,
                f * eye.through[1] * s.valueG * light.green,
                f * eye.through[2] * s.valueB * light.blue);
    }

    private double weight(double cosine) {
        double seen = eye.importance() * cosine / PATHS_PER_SAMPLE;
        double back = light.survival * reverse.of(light.bsdf, light.s);
        return SubpathDensities.weight(SubpathDensities.square(seen) * light.densities.behind(back), 0);
    }

    private void add(double r, double g, double b) {
        if (out == null) {
            brought += (Math.abs(r) + Math.abs(g) + Math.abs(b)) / 3;
        } else {
            out.add(eye.x() * width, eye.y() * height, r, g, b);
        }
    }
}
