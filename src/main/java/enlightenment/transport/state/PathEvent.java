package enlightenment.transport.state;

/** The kinds of scattering events of a path from the eye, as far as multiple importance sampling distinguishes them. */
public enum PathEvent {
    /** A delta lobe: a mirror, smooth glass, or such a lobe of another surface. No next-event estimation. */
    SPECULAR,
    /** Rough glass: next-event estimation on both sides; the caustic pass connects none of its vertices to the eye. */
    ROUGH_INTERFACE,
    /** A {@linkplain enlightenment.bsdf.Bsdf#isNarrow narrow} glossy lobe, in a scene whose caustic pass covers such lobes. */
    NARROW,
    /** Any other lobe. */
    WIDE,
    /** A medium with index of refraction 1: the caustic pass connects its vertices to the eye. */
    MEDIUM,
    /** A medium with another index of refraction: the caustic pass does not scatter its paths there. */
    REFRACTIVE_MEDIUM
}
