package enlightenment.transport.ray;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.bsdf.SmoothRefraction;
import enlightenment.bsdf.ThinDielectric;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.transport.state.PathWavelength;

/**
 * Scatters a ray at one surface of glass, by random numbers set before: the interface of two media refracts or reflects it, a thin slab
 * transmits or reflects it. {@link GlassTracer} determines the surface and the media on both sides.
 */
final class GlassScattering {
    /** The last scattering event. */
    final Scattering sampled = new Scattering();

    /** The path's wavelength, which receives each scattering event; null if no glass of the scene disperses. */
    private final PathWavelength wavelength;

    /** The number in [0, 1) that selects the lobe. */
    private double choice;

    /** A point of the unit square that selects the direction within a lobe. */
    private double u;

    private double v;

    GlassScattering(PathWavelength wavelength) {
        this.wavelength = wavelength;
    }

    /** Sets the random numbers of the next event: one selects reflection or refraction, the pair a direction within the lobe. */
    void choose(double number, double[] pair) {
        choice = number;
        u = pair[0];
        v = pair[1];
    }

    /**
     * Scatters a ray at the interface of two media. Glass of classic shading uses no random numbers.
     *
     * @param at the hit on the surface that is the interface
     * @param eta the index of refraction before the interface over that behind it
     * @return false if the light is lost
     */
    boolean atInterface(Ray ray, Hit hit, Bsdf dielectric, Hit at, double eta) {
        Optics.arrive(sampled, ray, hit);
        if (dielectric == SmoothRefraction.INSTANCE && at.primitive.shadingNormal(at)) {
            Optics.shade(sampled, at);
        }
        sampled.eta = eta;
        boolean scatters = dielectric.sample(sampled, u, v, choice);
        Optics.leave(ray, hit, sampled);
        if (wavelength != null) {
            wavelength.scattered(sampled, Hash.unit(Hash.mix(~Double.doubleToRawLongBits(choice))));
        }
        return scatters;
    }

    /**
     * Scatters a ray at a thin slab.
     *
     * @param eta the index of refraction of the surrounding medium over that of the slab
     * @return whether the ray was reflected, and leaves; otherwise the ray is unchanged
     */
    boolean isReflectedByPane(Ray ray, Hit hit, double eta) {
        Optics.arrive(sampled, ray, hit);
        sampled.eta = eta;
        ThinDielectric.INSTANCE.sample(sampled, 0, 0, choice);
        if (sampled.transmitted) {
            return false;
        }
        Optics.leave(ray, hit, sampled);
        return true;
    }
}
