package enlightenment.transport.ray;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.surface.SurfaceInteraction;

/** Converts between rays and the directions of a {@link Scattering}. An outgoing ray starts at the hit, on the side that it leaves to. */
public final class Optics {
    private Optics() {}

    /** Sets the direction that the ray comes from and the shading normal of the surface. */
    public static void arrive(Scattering s, Ray ray, SurfaceInteraction at) {
        setOutgoing(s, ray);
        s.nx = at.nx;
        s.ny = at.ny;
        s.nz = at.nz;
        s.gx = at.hit.nx * at.hit.side;
        s.gy = at.hit.ny * at.hit.side;
        s.gz = at.hit.nz * at.hit.side;
    }

    /** Sets the direction that the ray comes from and the geometric normal of the hit. */
    public static void arrive(Scattering s, Ray ray, Hit hit) {
        setOutgoing(s, ray);
        s.nx = hit.nx * hit.side;
        s.ny = hit.ny * hit.side;
        s.nz = hit.nz * hit.side;
        s.gx = s.nx;
        s.gy = s.ny;
        s.gz = s.nz;
    }

    /** Sets the shading normal of a hit; the geometric normal stays. */
    static void shade(Scattering s, Hit hit) {
        s.nx = hit.sx * hit.side;
        s.ny = hit.sy * hit.side;
        s.nz = hit.sz * hit.side;
    }

    /** Sets o, the unit direction that the ray comes from. */
    private static void setOutgoing(Scattering s, Ray ray) {
        double scale = 1 / Math.sqrt(ray.dd);
        s.ox = -ray.dx * scale;
        s.oy = -ray.dy * scale;
        s.oz = -ray.dz * scale;
    }

    /**
     * Converts the value of a rough interface from power to radiance if the sampled direction crosses it: times the tint and the squared
     * relative index of refraction.
     *
     * @param s the scattering at the interface; its value is changed
     * @param tint the colour of transmitted light, by band
     * @return whether the direction crosses the interface
     */
    public static boolean turn(Scattering s, double[] tint) {
        boolean passes = s.ix * s.nx + s.iy * s.ny + s.iz * s.nz < 0;
        if (passes) {
            double compression = s.eta * s.eta;
            s.valueR *= compression * tint[0];
            s.valueG *= compression * tint[1];
            s.valueB *= compression * tint[2];
        }
        return passes;
    }

    /** Sets the ray to leave the hit in the sampled direction. */
    public static void leave(Ray ray, Hit hit, Scattering s) {
        ray.set(hit.px, hit.py, hit.pz, s.ix, s.iy, s.iz, 0).from(hit, s.transmitted ? -hit.side : hit.side);
    }

    /** Sets the ray to continue straight on the far side of the hit. */
    public static void pass(Ray ray, Hit hit) {
        ray.set(hit.px, hit.py, hit.pz, ray.dx, ray.dy, ray.dz, 0).from(hit, -hit.side);
    }
}
