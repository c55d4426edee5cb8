package enlightenment.transport.state;

import enlightenment.emitter.LightSample;

/** A light sample at a vertex, before the BSDF of the surface there is applied. Mutable. */
public final class IncidentLight {
    /** The unit vector from the vertex towards the light. */
    public double dx;

    public double dy;
    public double dz;

    /**
     * The density per solid angle with which the direction was sampled; of a point light the squared distance instead; 0 if nothing
     * arrives.
     */
    public double density;

    /** Whether BSDF samples may hit the light as well: false for point lights. */
    public boolean hasExtent;

    /** The light's radiance as it arrives, by band; of a point light its intensity. */
    public double red;

    public double green;
    public double blue;

    public IncidentLight() {}

    /** Makes it a sample that brings nothing. */
    public void clear() {
        density = 0;
    }

    /**
     * Sets all of the sample.
     *
     * @param from has the direction
     * @param sampledWith its {@link #density}
     * @param isMet whether BSDF samples may hit the light as well
     * @param arriving the radiance, or of a point light the intensity
     */
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
