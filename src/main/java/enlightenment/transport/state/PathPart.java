package enlightenment.transport.state;

/**
 * How much of each path a {@code PathIntegrator} follows, and what it makes of it. The first vertex is the first surface that scatters light
 * other than into single directions, or the first point of a medium that scatters it, seen straight or by way of mirrors and glass.
 */
public enum PathPart {
    /** All of it: the light that comes along the camera ray. */
    WHOLE,

    /**
     * What is seen of things that glow and of the surroundings, straight or by way of mirrors and glass, and light that comes to the
     * first vertex straight from them. With the same numbers of a sampler this is, to the bit, a part of the whole; the rest has been
     * scattered at least twice, or was reflected by a mirror or refracted on its way to the first vertex.
     */
    DIRECT,

    /** What the whole has beside {@link #DIRECT}, with the same numbers. */
    INDIRECT,

    /**
     * The reflectance of the first vertex: the surface's colour, of a metal times its reflectance at normal incidence; filtered by the
     * mirrors and the glass on the way. 0 where there is none, and where nothing but a delta lobe reflects. At a point of a
     * medium: the share of light that is scattered there.
     */
    ALBEDO
}
