package enlightenment.shading;

import enlightenment.primitive.Hit;

/** Observes every shadow ray of a shader, and one light sample where no ray is needed. */
public interface LightObserver {
    /**
     * Called with a ray from a hit to a light point.
     *
     * @param surface the id of the primitive that is shaded
     * @param light index of the light
     * @param bounce the number of mirrors and glass surfaces before it on the path
     * @param from where the ray starts
     * @param dx x component of its direction, of length 1
     * @param dy y component
     * @param dz z component
     * @param distance the distance to the light point, in the frame
     * @param blocked whether the point is occluded
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
