package enlightenment.transport.state;

/**
 * Which part of a path's light a {@code PathIntegrator} estimates. The <i>first vertex</i> is the first point, seen directly or by way of
 * mirrors and glass, at which a surface scatters light by a lobe that is not a delta lobe, or a medium scatters it.
 */
public enum PathPart {
    /** The whole radiance along the camera ray. */
    WHOLE,

    /**
     * Emission and surroundings seen directly or by way of mirrors and glass, and direct lighting of the first vertex. With the same random
     * numbers this is, to the bit, a part of the whole; the rest was scattered at least twice, or was reflected by a mirror or refracted on
     * its way to the first vertex.
     */
    DIRECT,

    /** The difference between the whole and {@link #DIRECT}, with the same random numbers. */
    INDIRECT,

    /**
     * The reflectance of the first vertex, 0..1 by band, in place of radiance: the surface's colour, of a metal times its reflectance at
     * normal incidence; of a medium its albedo. It is filtered by the mirrors and the glass on the way. 0 where there is no first vertex.
     */
    ALBEDO
}
