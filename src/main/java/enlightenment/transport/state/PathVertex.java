package enlightenment.transport.state;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;

/** A vertex at which a path from the eye is scattered, as strategies see it. Mutable, one per thread. */
public final class PathVertex {
    /** What scatters light there: a surface, a rough border, or a medium's phase function. */
    public Bsdf bsdf;

    /** Directions, normal and colours, as {@link Bsdf} wants them; at a Lambertian surface null unless more than {@link #color} is needed. */
    public Scattering s;

    /** The colour of a Lambertian surface; at a rough border the tint of what passes. */
    public double[] color;

    /** How the path leaves it, if not in a single direction. */
    public PathEvent event;

    /** Whether direct light of small lights is left to the caustic pass. */
    public boolean leavesSmallLights;

    /** Whether it is a Lambertian surface, at which direct light has closed forms. */
    public boolean isMatte() {
        return bsdf == Lambert.INSTANCE;
    }

    /** Sets the vertex. */
    public void set(Bsdf by, Scattering at, double[] ofColor, PathEvent how, boolean leaves) {
        bsdf = by;
        s = at;
        color = ofColor;
        event = how;
        leavesSmallLights = leaves;
    }
}
