package enlightenment.transport.state;

import enlightenment.bsdf.Scattering;

/**
 * What a path from the eye has behind it: of which kinds its events were, and how it left the last one. Every strategy's share of the light
 * that the path hits is a function of this and of what it hits ({@link PathStrategy#weightOfHit}). Surfaces that the path passes straight are
 * no events: connections pass them, too. Mutable, one per thread.
 */
public final class PathState {
    /** How many scattering events there were. */
    public int events;

    /** How many of them, and of passages, have used random numbers: the address of the next ones. */
    public int address;

    /** Whether direct light was sampled at the last event, so that emission that the path hits is weighted. */
    public boolean hasDirect;

    /** Whether the next hit coincides with the rough border that the path left: direct light is not sampled towards it. */
    public boolean isAtCoincident;

    /** Whether direct light of {@linkplain enlightenment.world.light.CausticPass#takesNarrow small lights} was left out there. */
    public boolean leftSmallLights;

    /** Density per solid angle with which the path left the last vertex where direct light was sampled. */
    public double pdf;

    /** The direction in which the path left it. */
    public double dx;

    public double dy;
    public double dz;

    /** The mirror that reflected the path last, by its id; -1 where the last event was none at a mirror. */
    public int mirror;

    private PathEvent first;
    private PathEvent firstScattering;
    private PathEvent last;
    private PathEvent beforeLast;
    private boolean wasEnclosed;

    /** Begins at the eye. */
    public void begin() {
        events = 0;
        address = 0;
        hasDirect = false;
        isAtCoincident = false;
        leftSmallLights = false;
        first = null;
        firstScattering = null;
        last = null;
        beforeLast = null;
        mirror = -1;
        wasEnclosed = false;
    }

    /** Appends an event in a single direction, at the mirror of this id; -1 for glass, and for such lobes of other surfaces. */
    public void extendSpecular(int atMirror) {
        append(PathEvent.SPECULAR);
        hasDirect = false;
        mirror = atMirror;
    }

    /**
     * Appends an event at which direct light was sampled, by the direction and density that were sampled.
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

    /** Appends that a medium scattered the path where no light was sampled. */
    public void extendInTheDark() {
        append(PathEvent.ENCLOSED_MEDIUM);
        hasDirect = false;
    }

    private void append(PathEvent event) {
        beforeLast = last;
        last = event;
        mirror = -1;
        isAtCoincident = false;
        if (first == null) {
            first = event;
        }
        boolean scatters = event != PathEvent.SPECULAR && event != PathEvent.ROUGH_BORDER;
        if (scatters && firstScattering == null) {
            firstScattering = event;
        }
        wasEnclosed |= event == PathEvent.ENCLOSED_MEDIUM;
    }

    /** How the path left the last vertex; null at the eye. */
    public PathEvent last() {
        return last;
    }

    /** How it left the one before; null if there is none. */
    public PathEvent beforeLast() {
        return beforeLast;
    }

    /** Whether anything but mirrors and borders of glass has scattered the path: light that comes to it then is indirect. */
    public boolean hasScattered() {
        return firstScattering != null;
    }

    /** Whether the eye sees the vertex that the path is at, or the first that scattered it, in a mirror or through glass. */
    public boolean isSeenBySpecular() {
        return first == PathEvent.SPECULAR || first == PathEvent.ROUGH_BORDER || wasEnclosed;
    }

    /**
     * Whether the caustic pass makes such paths if they go on from a mirror or smooth glass to a light: from the light, over that, to the
     * first vertex, which is connected to the eye.
     */
    public boolean isConnectible() {
        return firstScattering != null && !isSeenBySpecular();
    }

    /** The same of those that go on from a narrow lobe: the first vertex must have none. */
    public boolean isConnectibleOverNarrow() {
        return isConnectible() && firstScattering != PathEvent.NARROW;
    }
}
