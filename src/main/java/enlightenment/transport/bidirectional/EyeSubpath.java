package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Reradiation;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.BandMixing;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.CausticPass;
import enlightenment.world.parts.RayCounters;

/** The subpath that begins at the eye, or that continues a path from there. */
final class EyeSubpath extends Subpath {
    private final EyeProjection eye;

    /** The number of light paths connected to the eye per path from the eye. */
    private final double lightPaths;

    /** The caustic pass that paths of some light are left to; null for none. */
    private final CausticPass caustics;

    /**
     * Of a subpath that continues another, the number of its first vertices per area and per light subpath that is connected to the vertex
     * before; 0 if none is.
     */
    private double density;

    /** The radiance gathered so far, and the throughput. */
    final PathValue value;

    /** The dye of the current surface, if it is fluorescent, and its colour; null if it is not. */
    private Reradiation dye;

    private final double[] dyed = new double[3];

    /** Makes subpaths that begin at the eye. */
    EyeSubpath(CompiledScene scene, RayCounters counters, double lightPaths) {
        this(
                scene,
                counters,
                new PathFollower(scene, counters, scene.physical.maxBounces),
                lightPaths,
                null,
                new PathValue(BandMixing.of(scene.physical)));
    }

    /**
     * Makes subpaths that continue paths from the eye.
     *
     * @param path has followed them
     * @param caustics the caustic pass that paths of some light are left to; null if the scene has none
     */
    EyeSubpath(CompiledScene scene, RayCounters counters, PathFollower path, CausticPass caustics) {
        this(scene, counters, path, 0, caustics, new PathValue(BandMixing.of(scene.physical)));
    }

    private EyeSubpath(
            CompiledScene scene,
            RayCounters counters,
            PathFollower path,
            double lightPaths,
            CausticPass caustics,
            PathValue value) {
        super(
                scene,
                counters,
                path,
                value.throughput,
                Sampler.Purpose.CHOICE,
                Sampler.Purpose.DIRECTION,
                Sampler.Purpose.ROULETTE,
                Sampler.Purpose.FLIGHT);
        eye = EyeProjection.of(scene.camera);
        this.lightPaths = lightPaths;
        this.caustics = caustics;
        this.value = value;
        path.tracer.leaveVisibilityOpen();
    }

    /** Begins at a camera ray, with the wavelength that the light subpath of the same sampler has. */
    void begin(Ray camera, Sampler sampler) {
        begin();
        dye = null;
        eye.startWith(camera);
        ray.set(camera.ox, camera.oy, camera.oz, camera.dx, camera.dy, camera.dz, camera.tMin);
        path.begin(ray, sampler);
        value.begin(path.glass.indexOfRefraction());
    }

    /**
     * Begins at the opaque surface that the follower is at, as the continuation of another path.
     *
     * @param arrived the ray by which it came
     * @param address of the next random numbers
     * @param density see {@link #density}
     */
    void beginAt(Ray arrived, int address, double density) {
        begin();
        dye = null;
        state.address = address;
        this.density = density;
        ray.set(arrived.ox, arrived.oy, arrived.oz, arrived.dx, arrived.dy, arrived.dz, arrived.tMin);
        value.begin(path.glass.indexOfRefraction());
        surface();
        passDye();
    }

    @Override
    boolean leavesSmallLights() {
        return caustics != null && caustics.takesNarrow(bsdf);
    }

    /** Whether the caustic pass samples paths that hit a light next. */
    boolean leavesHit(int light) {
        if (caustics == null || light < 0) {
            return false;
        }
        return !state.hasDirect || state.leftSmallLights && caustics.takesNarrow(light);
    }

    /** Whether next-event estimation at the current vertex leaves a light to the caustic pass. */
    boolean leavesLight(int light) {
        return leavesSmallLights() && caustics.takesNarrow(light);
    }

    /** Keeps the dye until {@link #passDye}: it changes the light that reaches the surface, not the surface's own emission. */
    @Override
    void reradiate(Reradiation by) {
        dye = by;
        System.arraycopy(color, 0, dyed, 0, dyed.length);
    }

    /** Applies the dye of the current surface, before light is gathered there. */
    void passDye() {
        if (dye != null) {
            value.reradiate(dye, dyed);
            dye = null;
        }
    }

    @Override
    void enter(double index) {
        value.enter(index);
    }

    @Override
    void beginDensities(double cosine) {
        if (lightPaths == 0) {
            double perUnit = density * physical.areaUnit;
            densities.begin(perUnit > 0 ? SubpathDensities.square(1 / perUnit) : 0, 0);
            return;
        }
        Hit at = path.at.hit;
        double perArea = eye.importanceOf(at.px, at.py, at.pz) * physical.areaUnit;
        densities.begin(SubpathDensities.square(lightPaths / (perArea * cosine)), 0);
    }

    @Override
    void beginDensitiesOfDelta() {
        densities.begin(0, 0);
    }
}
