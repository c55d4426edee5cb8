package enlightenment.shading;

import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.PhysicalScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * What the eye sees of things that glow and of the surroundings, straight or by way of mirrors and smooth glass: light that no path from
 * its source can be connected to the eye with ({@link LightTracer}). Paths end at the first surface that scatters light otherwise.
 */
public final class SeenLight implements Shader {
    private final PhysicalScene physical;
    private final PathFollower path;
    private final EyeImages images;
    private final PathValue value = new PathValue();
    private final double[] surface = new double[3];
    private final double[] pair = new double[2];
    private final Scattering border = new Scattering();

    /** How many events of glass have used random numbers: the address of the next ones. */
    private int address;

    private int events;

    /**
     * For one thread.
     *
     * @param scene whose shading is physical
     * @param counters what this thread counts
     */
    public SeenLight(CompiledScene scene, RayCounters counters) {
        physical = scene.physical;
        path = new PathFollower(scene, counters, physical.maxBounces);
        value.wavelength = path.glass.wavelength;
        images = new EyeImages(scene, counters, path, true);
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
        images.beginTile(x0, y0, x1, y1);
    }

    @Override
    public boolean seesNothing() {
        return path.tracer.seesNothing() && physical.isEvenBeyond();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        address = 0;
        events = 0;
        path.begin(ray, sampler);
        value.begin(path.glass.indexOfRefraction());
        images.begin(ray);
        images.gather(sampler, value);
        while (step(ray, sampler)) {
            events++;
        }
        value.get(out);
    }

    /** Follows the ray to the next event; returns whether the path goes on. */
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
        SurfaceMaterial material = path.material();
        if (material.glows && material.glowsTo(path.hit.side)) {
            double weight = images.weight();
            value.add(weight * material.glowR, weight * material.glowG, weight * material.glowB);
        }
        if (material.isBlack || !material.isDelta || !path.mayScatter()) {
            return false;
        }
        path.color(material, surface);
        images.reflected();
        path.scatter(ray, material, surface, 0, 0, 0);
        return survives(sampler) && path.goesOn();
    }

    private boolean glass(Ray ray, Sampler sampler) {
        sampler.pair(address++, Sampler.Purpose.CHOICE, pair);
        double choice = pair[0];
        if (physical.hasPartialGlass && path.glass.opaque(pair[1]) >= 0) {
            return false;
        }
        if (physical.hasRoughGlass && path.roughBorder(ray, border) != null) {
            return false;
        }
        path.glass.choose(choice, pair);
        boolean through = path.cross(ray);
        Arrays.fill(surface, path.glass.weight());
        if (through) {
            path.filter(surface);
        }
        value.enter(path.glass.indexOfRefraction());
        if (path.glass.passedStraight()) {
            events--;
            value.filter(surface[0], surface[1], surface[2]);
            return path.goesOn();
        }
        return survives(sampler) && path.goesOn();
    }

    /** Multiplies by the weight of an event, and plays roulette where it is due. */
    private boolean survives(Sampler sampler) {
        double r = surface[0];
        double g = surface[1];
        double b = surface[2];
        value.filter(r, g, b);
        return value.isSafe(events + 1) || value.survives(r, g, b, sampler, events);
    }
}
