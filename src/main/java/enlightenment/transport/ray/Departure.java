package enlightenment.transport.ray;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/** Starts rays at the current vertex of a path: towards lights, the eye, or other vertices. */
public final class Departure {
    private Departure() {}

    /**
     * Starts a ray, whose origin is the vertex, on all surfaces that coincide there.
     *
     * @param atInterface whether the vertex is on a rough interface of two media
     * @param through whether the ray leaves on the far side of the interface, as the path came
     * @return whether a surface that coincides with the vertex occludes the ray, on whichever side rounding puts it; a {@link ShadowWalk}
     *     may still pass it
     */
    public static boolean from(PathFollower path, Ray ray, boolean atInterface, boolean through) {
        ray.from(path.at.hit, through ? -path.at.hit.side : path.at.hit.side);
        if (atInterface) {
            path.glass.startAtInterface(ray, through);
        } else if (path.glass.surfaces() > 1) {
            path.glass.startOnAll(ray);
        }
        return isStopped(path, atInterface, through);
    }

    /** Whether rays that leave the current surface, in empty space, cannot hit it again, or only other elements of it. */
    public static boolean isOpen(PathFollower path) {
        Primitive p = path.at.hit.primitive;
        return path.glass.isPlain()
                && path.medium() == null
                && (p.hasElements() || p.isFlat() || p.isConvex() && path.at.hit.side == Ray.OUTSIDE);
    }

    /** Whether a surface that coincides with the vertex occludes a ray from there. The parameters are those of {@link #from}. */
    public static boolean isStopped(PathFollower path, boolean atInterface, boolean through) {
        return atInterface ? path.glass.comesToOpaque(through) : path.glass.entersAtOnce();
    }
}
