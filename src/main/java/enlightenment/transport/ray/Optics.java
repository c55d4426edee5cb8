package enlightenment.transport.ray;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.surface.SurfaceInteraction;

/** From rays to the directions that a Bsdf scatters, and back. The outgoing ray starts at the hit, on the side that it leaves to. */
public final class Optics {
    private Optics() {}

    /** Sets direction and shading normal of the surface where the ray arrives. */
    public static void arrive(Scattering s, Ray ray, SurfaceInteraction at) {
        setOutgoing(s, ray);
        s.nx = at.nx;
        s.ny = at.ny;
        s.nz = at.nz;
        s.gx = at.hit.nx * at.hit.side;
        s.gy = at.hit.ny * at.hit.side;
        s.gz = at.hit.nz * at.hit.side;
    }

    /** Sets direction and geometric normal of the place where the ray arrives. */
    public static void arrive(Scattering s, Ray ray, Hit hit) {
        setOutgoing(s, ray);
        s.nx = hit.nx * hit.side;
        s.ny = hit.ny * hit.side;
        s.nz = hit.nz * hit.side;
        s.gx = s.nx;
        s.gy = s.ny;
        s.gz = s.nz;
    }

    /** Sets the shading normal to that of a hit; the geometric one stays. */
    static void shade(Scattering s, Hit hit) {
        s.nx = hit.sx * hit.side;
        s.ny = hit.sy * hit.side;
        s.nz = hit.sz * hit.side;
    }

    /** Sets the unit direction to where the ray came from. */
    private static void setOutgoing(Scattering s, Ray ray) {
        double scale = 1 / Math.sqrt(ray.dd);
        s.ox = -ray.dx * scale;
        s.oy = -ray.dy * scale;
        s.oz = -ray.dz * scale;
    }

    /**
     * Turns what a rough border of two media does to light into what it does to radiance, if the direction to the light passes the border.
     *
     * @param s the border; its value is changed
     * @param tint of what passes, by band
     * @return whether the direction passes the border
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

    /** Lets the ray leave in the direction that was sampled. */
    public static void leave(Ray ray, Hit hit, Scattering s) {
        ray.set(hit.px, hit.py, hit.pz, s.ix, s.iy, s.iz, 0).from(hit, s.transmitted ? -hit.side : hit.side);
    }

    /** Lets the ray pass straight through, to the other side. */
    public static void pass(Ray ray, Hit hit) {
        ray.set(hit.px, hit.py, hit.pz, ray.dx, ray.dy, ray.dz, 0).from(hit, -hit.side);
    }
}
