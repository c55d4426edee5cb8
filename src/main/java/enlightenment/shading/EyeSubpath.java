package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.EyeProjection;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/** The part of a path that begins at the eye. */
final class EyeSubpath extends Subpath {
    private final EyeProjection eye;

    /** How many paths from lights are connected to the eye itself, per path from the eye. */
    private final double lightPaths;

    private double firstIndex;

    /** Radiance at the eye per radiance here, where the index of refraction is another one. */
    double compression;

    EyeSubpath(CompiledScene scene, RayCounters counters, double lightPaths) {
        super(scene, counters, Sampler.Purpose.CHOICE, Sampler.Purpose.DIRECTION, Sampler.Purpose.ROULETTE);
        eye = new EyeProjection(scene.camera);
        this.lightPaths = lightPaths;
        path.tracer.leaveVisibilityOpen();
    }

    /** Begins with a camera ray. */
    void begin(Ray camera) {
        begin(1, 1, 1);
        ray.set(camera.ox, camera.oy, camera.oz, camera.dx, camera.dy, camera.dz, camera.tMin);
        path.begin(ray);
        firstIndex = path.glass.indexOfRefraction();
        compression = 1;
    }

    @Override
    void enter(double index) {
        compression = firstIndex * firstIndex / (index * index);
    }

    @Override
    void beginDensities(double cosine) {
        Hit at = path.hit;
        densities.begin(SubpathDensities.square(lightPaths / (eye.importanceOf(at.px, at.py, at.pz) * cosine)), 0);
    }

    @Override
    void beginDensitiesOfDelta() {
        densities.begin(0, 0);
    }
}
