package enlightenment.transport.state;

/** The kinds of scattering events of a path from the eye, as far as multiple importance sampling distinguishes them. */
public enum PathEvent {
    /** A delta lobe: a mirror, smooth glass, or such a lobe of another surface. No next-event estimation. */
    SPECULAR,
    /** Rough glass: next-event estimation on both sides, but the caustic pass connects none of its vertices to the eye. */
    ROUGH_BORDER,
    /** A glossy lobe that is {@linkplain enlightenment.bsdf.Bsdf#isNarrow narrow}, where the caustic pass takes such. */
    NARROW,
    /** Any other lobe. */
    WIDE,
    /** A medium of index 1, which scatters the paths of the caustic pass, too. */
    MEDIUM,
    /** A medium of another index: the caustic pass follows no light there. */
    REFRACTIVE_MEDIUM
}
