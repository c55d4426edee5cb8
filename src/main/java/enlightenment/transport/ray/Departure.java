package enlightenment.transport.ray;

import enlightenment.primitive.Ray;

/** How rays leave the vertex that a path is at: towards lights, the eye, or other vertices. */
public final class Departure {
    private Departure() {}

    /**
     * Lets a ray whose origin is the vertex depart from all surfaces there.
     *
     * @param atBorder whether the vertex is on a rough border of two media
     * @param through whether the ray leaves it on the side that the path did not come from
     * @return whether a surface that coincides with the vertex is in its way, wherever rounding puts that; a walk may pass it
     */
    public static boolean from(PathFollower path, Ray ray, boolean atBorder, boolean through) {
        ray.from(path.at.hit, through ? -path.at.hit.side : path.at.hit.side);
        if (atBorder) {
            path.glass.startAtBorder(ray, through);
        } else if (path.glass.surfaces() > 1) {
            path.glass.startOnAll(ray);
        }
        return isStopped(path, atBorder, through);
    }

    /** Whether such a ray has a surface in its way that coincides with the vertex. */
    public static boolean isStopped(PathFollower path, boolean atBorder, boolean through) {
        return atBorder ? path.glass.comesToOpaque(through) : path.glass.entersAtOnce();
    }
}
