package enlightenment.transport.direct;

import enlightenment.emitter.AreaLight;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.ParallelogramLight;
import enlightenment.emitter.SphereLight;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.world.light.LightCone;
import enlightenment.world.light.PhysicalLight;

/** A light as seen from a vertex: the cone of directions to it, and a sampled point of it. One per thread. */
public final class LightView {
    public final LightCone cone = new LightCone();

    /** The sampled direction to the light, with the point that it leads to and its density. */
    public final LightSample sample = new LightSample(cone);

    private final double[] pair = new double[2];

    /** Sets the cone of directions from a vertex to a light with extent. */
    public void aim(PhysicalLight l, double x, double y, double z) {
        if (l.form instanceof SphereLight ball) {
            ball.aim(sample, x, y, z);
        } else if (l.form instanceof ParallelogramLight p) {
            p.aim(sample, x, y, z);
        } else {
            l.form.aim(sample, x, y, z);
        }
        cone.around(l);
    }

    /** Sets {@link #sample} to the direction from a vertex to a point light. */
    public void aimAtPoint(PhysicalLight l, double x, double y, double z) {
        cone.aim(l, x, y, z);
        sample.dx = cone.wx;
        sample.dy = cone.wy;
        sample.dz = cone.wz;
        sample.length = cone.distance;
    }

    /**
     * Draws the random numbers of a point of the light.
     *
     * @param index of the light where several lights are sampled; at most 0 for the only one
     */
    public void draw(int index, Sampler sampler, int address) {
        if (index <= 0) {
            draw(Sampler.Purpose.LIGHT, sampler, address);
        } else {
            sampler.lightPoints(index, address, 1);
            pair[0] = sampler.lightX(0);
            pair[1] = sampler.lightY(0);
        }
    }

    /** Draws the random numbers of a point of the light, for this purpose. */
    public void draw(Sampler.Purpose purpose, Sampler sampler, int address) {
        sampler.pair(address, purpose, pair);
    }

    // Asking for the common form first lets the just-in-time compiler inline it.

    /** The closed form of the irradiance of a light of radiance 1; not a number if there is none. */
    double irradiance(AreaLight form, double nx, double ny, double nz) {
        return form instanceof ParallelogramLight p
                ? p.irradiance(sample, nx, ny, nz)
                : form.irradiance(sample, nx, ny, nz);
    }

    /** Whether light may reach a surface with this normal if nothing occludes it. */
    boolean reaches(AreaLight form, double nx, double ny, double nz) {
        return form instanceof ParallelogramLight p ? p.reaches(sample, nx, ny, nz) : form.reaches(sample, nx, ny, nz);
    }

    /** Samples the point of the light that the last random numbers select. */
    public void sample(AreaLight form) {
        if (form instanceof SphereLight ball) {
            ball.sample(sample, pair[0], pair[1]);
        } else if (form instanceof ParallelogramLight p) {
            p.sample(sample, pair[0], pair[1]);
        } else {
            form.sample(sample, pair[0], pair[1]);
        }
    }

    /**
     * Sets the cone from a vertex to a light, and samples a point of it by the last random numbers.
     *
     * @return its density per solid angle; of a point light the squared distance; 0 if there is none
     */
    double look(PhysicalLight l, double x, double y, double z) {
        if (l.isPoint) {
            aimAtPoint(l, x, y, z);
            return cone.distance * cone.distance;
        }
        aim(l, x, y, z);
        sample(l.form);
        return sample.pdf;
    }

    /**
     * The density per solid angle with which {@link #sample} at the vertex (x, y, z) would choose the point of the light that a ray has
     * hit.
     */
    double density(AreaLight form, Ray ray, Hit hit, double x, double y, double z) {
        double dx = hit.px - x;
        double dy = hit.py - y;
        double dz = hit.pz - z;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double scale = 1 / Math.sqrt(ray.dd);
        double cosine = -(hit.nx * ray.dx + hit.ny * ray.dy + hit.nz * ray.dz) * scale;
        return form.pdf(sample, ray.dx * scale, ray.dy * scale, ray.dz * scale, distance, cosine);
    }

    /**
     * Samples only direction and distance, with density proportional to the cosine at the vertex, where {@link SphereLight#samplesByCosine}
     * allows it.
     */
    void directByCosine(SphereLight ball, double nx, double ny, double nz) {
        ball.directByCosine(sample, nx, ny, nz, pair[0], pair[1]);
    }
}
