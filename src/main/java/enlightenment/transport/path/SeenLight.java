package enlightenment.transport.path;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;

/**
 * Emission and surroundings that the eye sees directly or by way of mirrors and smooth glass: light of no path that {@code LightTracer} can
 * connect to the eye. Paths end at the first surface with another kind of lobe.
 */
public final class SeenLight extends EyePathTracer {
    /**
     * For one thread.
     *
     * @param scene whose shading is physical
     * @param counters of this thread
     */
    public SeenLight(CompiledScene scene, RayCounters counters) {
        super(scene, counters, new PathValue(), true);
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        beginPath(ray, sampler);
        images.gather(sampler, value);
        while (step(ray, sampler)) {}
        value.get(out);
    }

    /** Traces the ray to its next event; returns whether the path goes on. */
    private boolean step(Ray ray, Sampler sampler) {
        value.disperse();
        SurfaceMaterial medium = physical.hasAbsorption ? path.medium() : null;
        PathFollower.Event event = path.next(ray);
        if (event == PathFollower.Event.NOTHING) {
            if (physical.surroundings == null) {
                value.add(physical.backgroundR, physical.backgroundG, physical.backgroundB);
            } else {
                double scale = 1 / Math.sqrt(ray.dd);
                physical.surroundings.all(scale * ray.dx, scale * ray.dy, scale * ray.dz, surface);
                value.add(surface[0], surface[1], surface[2]);
            }
            return false;
        }
        if (medium != null && medium.absorbs) {
            value.absorb(medium, path.distance(ray));
        }
        return event == PathFollower.Event.SURFACE ? surface(ray, sampler) : glass(ray, sampler);
    }

    private boolean surface(Ray ray, Sampler sampler) {
        SurfaceMaterial material = path.at.material;
        if (path.at.emits()) {
            double weight = images.weight();
            path.at.findEmission();
            value.add(weight * path.at.emittedR, weight * path.at.emittedG, weight * path.at.emittedB);
        }
        if (material.isBlack || !material.bsdf.hasDelta() || !path.mayScatter()) {
            return false;
        }
        path.color(material, surface);
        double choice = material.isDelta ? 0 : sampler.unit(state.address++, Sampler.Purpose.CHOICE);
        return path.scatter(ray, material, surface, 0, 0, choice)
                && path.isSpecular()
                && survives(sampler)
                && path.continues();
    }

    private boolean glass(Ray ray, Sampler sampler) {
        sampler.pair(state.address++, Sampler.Purpose.CHOICE, pair);
        double choice = pair[0];
        int opaque = physical.hasPartialGlass ? path.glass.opaque(pair[1]) : -1;
        if (opaque >= 0) {
            path.turnToOpaque(opaque);
            return surface(ray, sampler);
        }
        if (physical.hasRoughGlass && path.roughInterface(ray, atInterface) != null) {
            return false;
        }
        cross(ray, choice);
        if (path.glass.passedStraight()) {
            value.filter(surface[0], surface[1], surface[2]);
            return path.continues();
        }
        return survives(sampler) && path.continues();
    }

    /** Multiplies the throughput by the weight of an event, and plays Russian roulette where that is due. */
    private boolean survives(Sampler sampler) {
        double r = surface[0];
        double g = surface[1];
        double b = surface[2];
        state.extendSpecular(-1);
        value.filter(r, g, b);
        return value.isSafe(state) || value.survives(r, g, b, sampler, state);
    }
}
