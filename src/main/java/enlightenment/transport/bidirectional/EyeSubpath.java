package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Reradiation;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.state.BandMixing;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.parts.RayCounters;

/** The subpath that begins at the eye. */
final class EyeSubpath extends Subpath {
    private final EyeProjection eye;

    /** The number of light paths connected to the eye per path from the eye. */
    private final double lightPaths;

    /** The radiance gathered so far, and the throughput. */
    final PathValue value;

    /** The dye of the current surface, if it is fluorescent, and its colour; null if it is not. */
    private Reradiation dye;

    private final double[] dyed = new double[3];

    EyeSubpath(CompiledScene scene, RayCounters counters, double lightPaths) {
        this(scene, counters, lightPaths, new PathValue(BandMixing.of(scene.physical)));
    }

    private EyeSubpath(CompiledScene scene, RayCounters counters, double lightPaths, PathValue value) {
        super(
                scene,
                counters,
                value.throughput,
                Sampler.Purpose.CHOICE,
                Sampler.Purpose.DIRECTION,
                Sampler.Purpose.ROULETTE,
                Sampler.Purpose.FLIGHT);
        eye = EyeProjection.of(scene.camera);
        this.lightPaths = lightPaths;
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
        Hit at = path.at.hit;
        double perArea = eye.importanceOf(at.px, at.py, at.pz) * physical.areaUnit;
        densities.begin(SubpathDensities.square(lightPaths / (perArea * cosine)), 0);
    }

    @Override
    void beginDensitiesOfDelta() {
        densities.begin(0, 0);
    }
}
