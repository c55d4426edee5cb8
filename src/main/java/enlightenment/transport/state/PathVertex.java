package enlightenment.transport.state;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;

/** A vertex at which a path from the eye is scattered, as a {@link PathStrategy} receives it. Mutable, one per thread. */
public final class PathVertex {
    /** The scattering function of a surface, of a rough interface of two media, or of a medium (its phase function). */
    public Bsdf bsdf;

    /** Directions, normal and colours, as {@link Bsdf} wants them; at a Lambertian surface null unless more than {@link #color} is needed. */
    public Scattering s;

    /** The colour of a Lambertian surface; at a rough interface the tint of what passes. */
    public double[] color;

    /** The kind of the scattering event here, unless a delta lobe is sampled. */
    public PathEvent event;

    /** Whether next-event estimation leaves out small lights, which the caustic pass covers here. */
    public boolean leavesSmallLights;

    /** Whether the vertex is on a Lambertian surface, where direct light has closed forms. */
    public boolean isMatte() {
        return bsdf == Lambert.INSTANCE;
    }

    /** Sets all fields. */
    public void set(Bsdf by, Scattering at, double[] ofColor, PathEvent how, boolean leaves) {
        bsdf = by;
        s = at;
        color = ofColor;
        event = how;
        leavesSmallLights = leaves;
    }
}
