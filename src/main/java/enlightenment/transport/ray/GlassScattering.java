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
 * How one surface of glass turns a ray, by numbers that are given before: a border of two media refracts or reflects it, a pane lets it
 * pass or reflects it. Which surface it is, and which media are at it, is the business of {@link GlassTracer}.
 */
final class GlassScattering {
    /** What was sampled last. */
    final Scattering sampled = new Scattering();

    /** Takes part of what has a wavelength; null if no glass of the scene disperses. */
    private final PathWavelength wavelength;

    /** Which lobe is chosen, 0..1. */
    private double choice;

    /** A point of the unit square: the direction within a lobe. */
    private double u;

    private double v;

    GlassScattering(PathWavelength wavelength) {
        this.wavelength = wavelength;
    }

    /** Sets the number that chooses between reflection and refraction next, and those that choose a direction within these. */
    void choose(double number, double[] pair) {
        choice = number;
        u = pair[0];
        v = pair[1];
    }

    /**
     * Lets a ray leave the border of two media. Classic glass needs no random numbers.
     *
     * @param at the hit on the surface that is the border
     * @param eta the index of refraction before the border over that behind it
     * @return false if the light is lost there
     */
    boolean atBorder(Ray ray, Hit hit, Bsdf border, Hit at, double eta) {
        Optics.arrive(sampled, ray, hit);
        if (border == SmoothRefraction.INSTANCE && at.primitive.shadingNormal(at)) {
            Optics.shade(sampled, at);
        }
        sampled.eta = eta;
        boolean scatters = border.sample(sampled, u, v, choice);
        Optics.leave(ray, hit, sampled);
        if (wavelength != null) {
            wavelength.scattered(sampled, Hash.unit(Hash.mix(~Double.doubleToRawLongBits(choice))));
        }
        return scatters;
    }

    /**
     * Lets a ray come to a pane.
     *
     * @param eta the index of refraction of the medium around it over that of the pane
     * @return whether it was reflected, and leaves; else nothing has happened to it
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
