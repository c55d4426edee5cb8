package enlightenment.transport.state;

import enlightenment.bsdf.Scattering;

/**
 * The scattering events of a path, from the eye or from a light, and its last BSDF sample: all that the MIS weight of emission that the
 * path hits depends on ({@link PathStrategy#weightOfHit}). Surfaces that the path passes straight are no events, since shadow rays pass
 * them, too. Mutable, one per thread.
 */
public final class PathState {
    /** The number of scattering events. */
    public int events;

    /** The address of the next random numbers: the number of events and straight passages that have used some. */
    public int address;

    /** Whether direct light was sampled at the last event, so that emission that the path hits gets an MIS weight. */
    public boolean hasDirect;

    /** Whether the next hit coincides with the rough glass that the path left: next-event estimation cannot reach it. */
    public boolean nextIsCoincident;

    /**
     * Whether next-event estimation at the last event left out {@linkplain enlightenment.world.light.CausticPass#takesNarrow small lights}.
     */
    public boolean leftSmallLights;

    /** Density per solid angle of the BSDF sample at the last vertex with next-event estimation. */
    public double pdf;

    /** The direction of that sample, a unit vector in the frame. */
    public double dx;

    public double dy;
    public double dz;

    /** The id of the mirror at which the last event happened; -1 if it was no reflection at a mirror. */
    public int mirror;

    /** The number of events but those at mirrors and at interfaces of glass. */
    private int scatterings;

    private PathEvent first;
    private PathEvent firstScattering;
    private PathEvent last;
    private PathEvent beforeLast;
    private boolean wasInRefractiveMedium;

    /** Begins a path at the eye or at a light: no events yet. */
    public void begin() {
        events = 0;
        scatterings = 0;
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

    /**
     * Appends a delta event.
     *
     * @param atMirror id of the mirror; -1 for glass, and for delta lobes of other surfaces
     */
    public void extendSpecular(int atMirror) {
        append(PathEvent.SPECULAR);
        hasDirect = false;
        mirror = atMirror;
    }

    /**
     * Appends an event at which direct light was sampled, or which is connected to other subpaths.
     *
     * @param sampled the BSDF sample: its direction and density
     * @param leavesSmallLights whether next-event estimation left out small lights
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

    /** Appends an event in a medium, at a vertex without next-event estimation. */
    public void extendWithoutDirect() {
        append(PathEvent.REFRACTIVE_MEDIUM);
        hasDirect = false;
    }

    /**
     * Appends an event at rough glass.
     *
     * @param sampled the BSDF sample: its direction and density
     * @param leavesSmallLights whether next-event estimation left out small lights
     * @param toCoincident whether the next hit coincides with the glass
     */
    public void extendAtRoughGlass(Scattering sampled, boolean leavesSmallLights, boolean toCoincident) {
        extend(PathEvent.ROUGH_INTERFACE, sampled, leavesSmallLights);
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
        boolean scatters = scatters(event);
        scatterings += scatters ? 1 : 0;
        if (scatters && firstScattering == null) {
            firstScattering = event;
        }
        wasInRefractiveMedium |= event == PathEvent.REFRACTIVE_MEDIUM;
    }

    /** The event before the last; null if there is none. */
    public PathEvent beforeLast() {
        return beforeLast;
    }

    private static boolean scatters(PathEvent event) {
        return event != PathEvent.SPECULAR && event != PathEvent.ROUGH_INTERFACE;
    }

    /**
     * The number of events that count for Russian roulette after the last one. Mirrors and interfaces of glass take little of a path, and
     * only what is behind them tells what it is worth: at them all events count, elsewhere those at them do not.
     */
    public int eventsForRoulette() {
        return scatters(last) ? scatterings : events;
    }

    /** Whether anything but mirrors and interfaces of glass has scattered the path: light that it finds from then on is indirect. */
    public boolean hasScattered() {
        return firstScattering != null;
    }

    /**
     * Whether the eye sees the first vertex in a mirror or through glass, or a medium of another index of refraction has scattered the
     * path.
     */
    public boolean isSeenBySpecular() {
        return first == PathEvent.SPECULAR || first == PathEvent.ROUGH_INTERFACE || wasInRefractiveMedium;
    }

    /**
     * Whether the caustic pass samples this path if its last event is specular and it hits a light next: the pass follows it from the
     * light, by the specular event, to the first vertex, which it connects to the eye.
     */
    public boolean isSampledByCausticPass() {
        return firstScattering != null && !isSeenBySpecular();
    }

    /**
     * As {@link #isSampledByCausticPass}, for a last event at a narrow lobe: false if the first lobe that is not specular is narrow as
     * well.
     */
    public boolean isNarrowSampledByCausticPass() {
        return isSampledByCausticPass() && firstScattering != PathEvent.NARROW;
    }
}
