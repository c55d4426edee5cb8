package enlightenment.shading;

import enlightenment.primitive.Hit;

/** Sees every ray that a shader sends to a light, and one where it knows without a ray. */
public interface LightObserver {
    /**
     * A ray from a hit to a light point.
     *
     * @param surface the primitive that is lit
     * @param light index of the light
     * @param bounce how many mirrors and glass surfaces came before
     * @param from where it starts
     * @param dx its direction, of length 1
     * @param distance how far the light point is
     * @param blocked whether something stands in its way
     */
    void ray(
            int surface,
            int light,
            int bounce,
            Hit from,
            double dx,
            double dy,
            double dz,
            double distance,
            boolean blocked);
}
