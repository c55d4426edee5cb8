package enlightenment.transport.state;

/**
 * Of what kinds the events of a path from the eye were: that decides which technique finds the light that it comes to. Surfaces that the
 * path passes straight are no events: connections pass them, too.
 */
public final class PathHistory {
    /** How many scattering events there were. */
    public int events;

    /** Whether a direction was sampled from a lobe that is not a delta lobe. */
    public boolean scattered;

    /** Whether that was the first event of the path, and paths from lights that look for caustics are scattered by all that followed. */
    public boolean scatteredFirst;

    /** Whether a narrow lobe was the first that is not a delta lobe: paths from lights are not connected to the eye there. */
    private boolean narrowFirst;

    /** Whether there were events of delta lobes before. */
    private boolean deltaFirst;

    /** Whether light was gathered at the last vertex, so that light that the path runs into is weighted. */
    public boolean gathered;

    /** Whether the next hit coincides with the surface that the path left: next-event estimation cannot reach it. */
    public boolean atCoincidentSurface;

    public void begin() {
        events = 0;
        scattered = false;
        scatteredFirst = false;
        narrowFirst = false;
        deltaFirst = false;
        gathered = false;
        atCoincidentSurface = false;
    }

    /** Notes the kind of event that the path leaves behind. */
    public void leave(boolean isDelta) {
        if (!isDelta && !scattered) {
            scattered = true;
            scatteredFirst = !deltaFirst;
        }
        deltaFirst |= !scattered;
        gathered = !isDelta;
        atCoincidentSurface = false;
    }

    /** The same of a narrow lobe. */
    public void leaveNarrow() {
        narrowFirst |= !scattered;
        leave(false);
    }

    /** Whether light that narrow lobes send here is found by paths from small lights: they are connected to the eye where this began. */
    public boolean leavesNarrow() {
        return scattered && scatteredFirst && !narrowFirst;
    }

    /**
     * Notes that a medium scattered the path.
     *
     * @param hasGathered whether light was gathered there
     * @param leavesCaustics whether paths from lights that look for caustics are scattered there, too: otherwise this path leaves nothing to
     *     them from here on
     */
    public void leaveInMedium(boolean hasGathered, boolean leavesCaustics) {
        scatteredFirst = leavesCaustics && (scattered ? scatteredFirst : !deltaFirst);
        scattered = true;
        gathered = hasGathered;
    }

    /** Whether the eye sees the surface that the path is at, or the first that it was scattered by, in a mirror or through glass. */
    public boolean isSeenByMirrors() {
        return scattered ? !scatteredFirst : deltaFirst;
    }
}
