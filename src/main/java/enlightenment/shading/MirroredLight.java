package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.ThinDielectric;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.compiled.Tracer;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;

/** Follows rays that are to meet a light straight or by way of one mirror. A mutable work object, one per thread. */
final class MirroredLight {
    private final CompiledScene scene;
    private final RayCounters counters;
    private final Tracer tracer;
    private final Hit met = new Hit();
    private final Scattering event = new Scattering();
    private final double[] color = new double[3];

    /** What the mirror that the last ray met reflects, by band. */
    double red;

    double green;
    double blue;

    /** @param tracer of the thread, whose last result is overwritten */
    MirroredLight(CompiledScene scene, RayCounters counters, Tracer tracer) {
        this.scene = scene;
        this.counters = counters;
        this.tracer = tracer;
    }

    /** Whether a ray meets a light, by its index, and what of it glows towards where the ray comes from. */
    boolean isMetBy(Ray ray, int light) {
        return tracer.trace(ray, met)
                && scene.physical.lightOf(tracer.id, met.face) == light
                && scene.material(tracer.id, met.face).glowsTo(met.side);
    }

    /**
     * Whether a ray meets a mirror, a pane, or glass from empty space, which reflects it to a light, and something of it is left.
     *
     * @param ray is overwritten
     * @param mirror the id of a primitive whose face coincides with none of another
     * @param face of the mirror; -1 for any
     */
    boolean isMetBy(Ray ray, int mirror, int face, int light) {
        if (!tracer.trace(ray, met) || tracer.id != mirror || face >= 0 && met.face != face) {
            return false;
        }
        SurfaceMaterial material = scene.material(mirror, met.face);
        Optics.arrive(event, ray, met);
        if (material.isTextured()) {
            met.primitive.textureCoordinates(met);
        }
        material.color(met.u, met.v, met.primitive instanceof SpherePrimitive, color);
        event.red = color[0];
        event.green = color[1];
        event.blue = color[2];
        if (material.isGlass) {
            event.eta = 1 / material.indexOfRefraction;
        }
        // Of glass this choice is what is reflected, and its probability the share of what is clear.
        Bsdf bsdf = material.isGlass && !met.primitive.isSolid() ? ThinDielectric.INSTANCE : material.bsdf;
        if (!bsdf.sample(event, 0, 0, 0) || event.transmitted) {
            return false;
        }
        double share = material.isGlass ? material.transparency * event.pdf : 1;
        red = share * event.valueR;
        green = share * event.valueG;
        blue = share * event.valueB;
        counters.mirrorRays++;
        Optics.leave(ray, met, event);
        return isMetBy(ray, light);
    }
}
