package enlightenment.transport.image;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.Optics;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;

/** Traces rays by one reflection at a mirror to a light. A mutable work object, one per thread. */
final class MirroredLight {
    private final CompiledScene scene;
    private final RayCounters counters;
    private final Tracer tracer;
    private final Hit met = new Hit();
    private final Scattering event = new Scattering();
    private final double[] color = new double[3];

    /** The reflectance of the mirror for the last ray, by band. */
    double red;

    double green;
    double blue;

    /**
     * @param tracer of the thread; its last result is overwritten
     */
    MirroredLight(CompiledScene scene, RayCounters counters, Tracer tracer) {
        this.scene = scene;
        this.counters = counters;
        this.tracer = tracer;
    }

    /** Sets the colour of the surface that was hit; returns its material. */
    private SurfaceMaterial colored(int id) {
        SurfaceMaterial material = scene.material(id, met.face);
        if (material.isTextured()) {
            met.primitive.textureCoordinates(met);
        }
        material.color(met.u, met.v, met.primitive.repeatsTextures(), color);
        return material;
    }

    /**
     * Whether a ray hits this mirror and is reflected to this light.
     *
     * @param ray is overwritten
     * @param mirror the id of a primitive that coincides with no other
     */
    boolean isMetBy(Ray ray, int mirror, int light) {
        if (!tracer.trace(ray, met) || tracer.id != mirror) {
            return false;
        }
        Optics.arrive(event, ray, met);
        SurfaceMaterial material = colored(mirror);
        event.red = color[0];
        event.green = color[1];
        event.blue = color[2];
        if (!material.bsdf.sample(event, 0, 0, 0)) {
            return false;
        }
        red = event.valueR;
        green = event.valueG;
        blue = event.valueB;
        counters.mirrorRays++;
        Optics.leave(ray, met, event);
        return tracer.meetsLight(ray, met, light);
    }
}
