package enlightenment.transport.state;

import enlightenment.emitter.LightSample;

/** Light that was sampled at a vertex, before the surface there does anything to it. Mutable. */
public final class IncidentLight {
    /** The unit vector towards where it comes from. */
    public double dx;

    public double dy;
    public double dz;

    /** The density per solid angle with which it was sampled; of a point light with respect to squared distance; 0 if nothing arrives. */
    public double density;

    /** Whether directions that the surface samples may meet it, too. */
    public boolean hasExtent;

    /** Its radiance, of a point light its intensity: what arrives of it. */
    public double red;

    public double green;
    public double blue;

    public IncidentLight() {}

    /** Nothing arrives. */
    public void clear() {
        density = 0;
    }

    /** Sets all of it; the direction is that of a sample. */
    public void set(LightSample from, double sampledWith, boolean isMet, GatheredLight arriving) {
        dx = from.dx;
        dy = from.dy;
        dz = from.dz;
        density = sampledWith;
        hasExtent = isMet;
        red = arriving.red;
        green = arriving.green;
        blue = arriving.blue;
    }
}
