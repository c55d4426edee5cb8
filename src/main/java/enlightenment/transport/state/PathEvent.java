package enlightenment.transport.state;

/** How a path from the eye left a vertex, of which it matters here which strategies could have found the light that comes next. */
public enum PathEvent {
    /** In a single direction: by a mirror, by smooth glass, or by such a lobe of a surface. Nothing else is sampled there. */
    SPECULAR,
    /** Through or off a rough border of glass: direct light is sampled there, but no light path is connected to the eye. */
    ROUGH_BORDER,
    /** By a lobe that is {@linkplain enlightenment.bsdf.Bsdf#isNarrow narrow}. */
    NARROW,
    /** By any other lobe. */
    WIDE,
    /** Scattered by a medium of index 1, which paths from lights are scattered by as well. */
    MEDIUM,
    /** Scattered by a medium within a border that refracts: the caustic pass follows no light there. */
    ENCLOSED_MEDIUM
}
