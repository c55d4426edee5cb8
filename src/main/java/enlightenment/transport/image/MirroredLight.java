package enlightenment.transport.image;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.ThinDielectric;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.transport.ray.Optics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;

/** Follows rays that are to meet a light straight, through panes, or by way of one mirror. A mutable work object, one per thread. */
final class MirroredLight {
    private final CompiledScene scene;
    private final RayCounters counters;
    private final Tracer tracer;
    private final Hit met = new Hit();
    private final Scattering event = new Scattering();
    private final double[] color = new double[3];

    /** What the mirror that the last ray met reflects, or the panes let pass, by band. */
    double red;

    double green;
    double blue;

    /** @param tracer of the thread, whose last result is overwritten */
    MirroredLight(CompiledScene scene, RayCounters counters, Tracer tracer) {
        this.scene = scene;
        this.counters = counters;
        this.tracer = tracer;
    }

    /**
     * Whether a ray meets a light, by its index, by way of nothing but {@linkplain #isPane panes} that it passes, and what of it glows towards
     * where the ray comes from.
     *
     * @param ray is overwritten
     */
    boolean isSeenBy(Ray ray, int light) {
        red = 1;
        green = 1;
        blue = 1;
        int most = PathFollower.MAX_CROSSINGS * scene.primitives.length;
        // No line meets more surfaces: one that does is caught in a loop by rounding.
        for (int left = most; left >= 0 && tracer.trace(ray, met); left--) {
            if (!isPane(tracer.id, met.face)) {
                return isLight(light);
            }
            Optics.arrive(event, ray, met);
            SurfaceMaterial pane = colored(tracer.id);
            double cosine = event.ox * event.nx + event.oy * event.ny + event.oz * event.nz;
            double share = pane.transparency * ThinDielectric.transmittance(cosine, 1 / pane.indexOfRefraction);
            red *= share * color[0];
            green *= share * color[1];
            blue *= share * color[2];
            Optics.pass(ray, met);
        }
        return false;
    }

    /**
     * Whether a face is a smooth pane that rays from empty space pass as they are, and that nothing coincides with: of each the light is
     * dimmed by one share.
     */
    boolean isPane(int id, int face) {
        SurfaceMaterial m = scene.material(id, face);
        return m.isGlass
                && m.isDelta
                && !scene.primitives[id].isSolid()
                && !scene.physical.hasDispersion
                && !scene.coincident.concerns(id, face);
    }

    private boolean isLight(int light) {
        return scene.physical.lightOf(tracer.id, met.face) == light
                && scene.material(tracer.id, met.face).glowsTo(met.side);
    }

    /** Sets the colour of the surface of a primitive that was met; returns its material. */
    private SurfaceMaterial colored(int id) {
        SurfaceMaterial material = scene.material(id, met.face);
        if (material.isTextured()) {
            met.primitive.textureCoordinates(met);
        }
        material.color(met.u, met.v, met.primitive instanceof SpherePrimitive, color);
        return material;
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
        Optics.arrive(event, ray, met);
        SurfaceMaterial material = colored(mirror);
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
        return tracer.trace(ray, met) && isLight(light);
    }
}
