package enlightenment.transport.state;

import enlightenment.bsdf.Scattering;

/**
 * The scattering events of a path, from the eye or from a light, and the last direction that its BSDFs sampled: what multiple importance
 * sampling of the light that the path hits depends on ({@link PathStrategy#weightOfHit}). Surfaces that the path passes straight are no events: shadow rays pass them,
 * too. Mutable, one per thread.
 */
public final class PathState {
    /** How many scattering events there were. */
    public int events;

    /** The address of the next random numbers: how many events and passages have used some. */
    public int address;

    /** Whether direct light was sampled at the last event, so that emission that the path hits is weighted. */
    public boolean hasDirect;

    /** Whether the next hit coincides with the rough glass that the path left: next-event estimation cannot reach it. */
    public boolean nextIsCoincident;

    /** Whether direct light of {@linkplain enlightenment.world.light.CausticPass#takesNarrow small lights} was left out there. */
    public boolean leftSmallLights;

    /** Density per solid angle of the BSDF sample at the last vertex with next-event estimation. */
    public double pdf;

    /** Its direction. */
    public double dx;

    public double dy;
    public double dz;

    /** The mirror that reflected the path last, by its id; -1 where the last event was none at a mirror. */
    public int mirror;

    private PathEvent first;
    private PathEvent firstScattering;
    private PathEvent last;
    private PathEvent beforeLast;
    private boolean wasInRefractiveMedium;

    /** Begins at the eye, or at a light. */
    public void begin() {
        events = 0;
        address = 0;
        hasDirect = false;
        nextIsCoincident = false;
        leftSmallLights = false;
        first = null;
        firstScattering = null;
        last = null;
        beforeLast = null;
        mirror = -1;
        wasInRefractiveMedium = false;
    }

    /** Appends an event in a single direction, at the mirror of this id; -1 for glass, and for such lobes of other surfaces. */
    public void extendSpecular(int atMirror) {
        append(PathEvent.SPECULAR);
        hasDirect = false;
        mirror = atMirror;
    }

    /**
     * Appends an event at which direct light was sampled, or that connections may end at, by the direction and density that were sampled.
     *
     * @param leavesSmallLights whether direct light of small lights was left out
     */
    public void extend(PathEvent event, Scattering sampled, boolean leavesSmallLights) {
        append(event);
        hasDirect = true;
        leftSmallLights = leavesSmallLights;
        pdf = sampled.pdf;
        dx = sampled.ix;
        dy = sampled.iy;
        dz = sampled.iz;
    }

    /** Appends scattering in a medium, at a vertex without next-event estimation. */
    public void extendWithoutDirect() {
        append(PathEvent.REFRACTIVE_MEDIUM);
        hasDirect = false;
    }

    /**
     * Appends an event at rough glass.
     *
     * @param toCoincident whether the next hit coincides with it
     */
    public void extendAtRoughGlass(Scattering sampled, boolean leavesSmallLights, boolean toCoincident) {
        extend(PathEvent.ROUGH_BORDER, sampled, leavesSmallLights);
        nextIsCoincident = toCoincident;
        hasDirect = !toCoincident;
    }

    private void append(PathEvent event) {
        events++;
        beforeLast = last;
        last = event;
        mirror = -1;
        nextIsCoincident = false;
        if (first == null) {
            first = event;
        }
        boolean scatters = event != PathEvent.SPECULAR && event != PathEvent.ROUGH_BORDER;
        if (scatters && firstScattering == null) {
            firstScattering = event;
        }
        wasInRefractiveMedium |= event == PathEvent.REFRACTIVE_MEDIUM;
    }

    /** The event before the last; null if there is none. */
    public PathEvent beforeLast() {
        return beforeLast;
    }

    /** Whether anything but mirrors and borders of glass has scattered the path: light that comes to it then is indirect. */
    public boolean hasScattered() {
        return firstScattering != null;
    }

    /** Whether the eye sees the vertex that the path is at, or the first that scattered it, in a mirror or through glass. */
    public boolean isSeenBySpecular() {
        return first == PathEvent.SPECULAR || first == PathEvent.ROUGH_BORDER || wasInRefractiveMedium;
    }

    /**
     * Whether the caustic pass samples such paths if their last event is specular and a light comes next: from the light, over that, to the
     * first vertex, which it connects to the eye.
     */
    public boolean isSampledByCausticPass() {
        return firstScattering != null && !isSeenBySpecular();
    }

    /** As {@link #isSampledByCausticPass} for a narrow lobe as the last event: false if the first lobe that is not specular is narrow, too. */
    public boolean isNarrowSampledByCausticPass() {
        return isSampledByCausticPass() && firstScattering != PathEvent.NARROW;
    }
}
