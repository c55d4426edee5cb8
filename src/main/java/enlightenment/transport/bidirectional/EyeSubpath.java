package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Reradiation;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.state.BandMixing;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.parts.RayCounters;

/** The part of a path that begins at the eye. */
final class EyeSubpath extends Subpath {
    private final EyeProjection eye;

    /** How many paths from lights are connected to the eye itself, per path from the eye. */
    private final double lightPaths;

    private double firstIndex;

    /** Radiance at the eye per radiance here, where the index of refraction is another one. */
    double compression;

    /** What fluorescent surfaces that have scattered the path make of light; and whether there were any. */
    final BandMixing mixing;

    boolean mixes;

    /** The dye of the surface that the path is at, and its colour; null if there is none. */
    private Reradiation dye;

    private final double[] dyed = new double[3];

    EyeSubpath(CompiledScene scene, RayCounters counters, double lightPaths) {
        super(
                scene,
                counters,
                Sampler.Purpose.CHOICE,
                Sampler.Purpose.DIRECTION,
                Sampler.Purpose.ROULETTE,
                Sampler.Purpose.FLIGHT);
        eye = EyeProjection.of(scene.camera);
        this.lightPaths = lightPaths;
        mixing = BandMixing.of(scene.physical);
        path.tracer.leaveVisibilityOpen();
    }

    /** Begins with a camera ray, and the wavelength that a part from a light has by the same sampler. */
    void begin(Ray camera, Sampler sampler) {
        begin(1, 1, 1, 1);
        mixes = false;
        dye = null;
        eye.startWith(camera);
        ray.set(camera.ox, camera.oy, camera.oz, camera.dx, camera.dy, camera.dz, camera.tMin);
        path.begin(ray, sampler);
        firstIndex = path.glass.indexOfRefraction();
        compression = 1;
    }

    /** Only what reaches the surface is worth something else, not what it emits by itself: {@link #passDye}. */
    @Override
    void reradiate(Reradiation by) {
        dye = by;
        System.arraycopy(color, 0, dyed, 0, dyed.length);
    }

    /** Before light is gathered at the surface that the path is at. */
    void passDye() {
        if (dye == null) {
            return;
        }
        if (!mixes) {
            mixing.clear();
            mixes = true;
        }
        mixing.filter(red, green, blue);
        mixing.scatter(dye, dyed);
        red = 1;
        green = 1;
        blue = 1;
        ultraviolet = 1;
        dye = null;
    }

    @Override
    void enter(double index) {
        compression = firstIndex * firstIndex / (index * index);
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
