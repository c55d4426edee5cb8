package enlightenment.shading;

/**
 * Of what kinds the events of a path from the eye were: that decides which technique finds the light that it comes to. Surfaces that the
 * path passes straight are no events: connections pass them, too.
 */
final class PathHistory {
    /** How many scattering events there were. */
    int events;

    /** Whether a direction was sampled from a lobe that is not a delta lobe. */
    boolean scattered;

    /** Whether that was the first event of the path, and paths from lights that look for caustics are scattered by all that followed. */
    boolean scatteredFirst;

    /** Whether there were events of delta lobes before. */
    private boolean deltaFirst;

    /** Whether light was gathered at the last vertex, so that light that the path runs into is weighted. */
    boolean gathered;

    /** Whether a medium scattered the path that no lamp outside is sampled from, or whose light the pass of caustics leaves alone. */
    boolean behindBorder;

    /** Whether paths from both ends may meet between two events, the eye counted, neither of which is one of a delta lobe. */
    private boolean hasMet;

    /** Whether the last event, or the eye, could be the end of such a segment. */
    private boolean connects;

    /** Whether the path goes on to a surface in the same place, whose light only chance finds. */
    boolean isThere;

    void begin() {
        events = 0;
        scattered = false;
        scatteredFirst = false;
        deltaFirst = false;
        gathered = false;
        behindBorder = false;
        hasMet = false;
        connects = true;
        isThere = false;
    }

    /** Notes the kind of event that the path leaves behind. */
    void leave(boolean isDelta) {
        if (!isDelta && !scattered) {
            scattered = true;
            scatteredFirst = !deltaFirst;
        }
        deltaFirst |= !scattered;
        hasMet |= connects && !isDelta;
        connects = !isDelta;
        gathered = !isDelta;
        isThere = false;
    }

    /**
     * Notes that a medium scattered the path.
     *
     * @param hasGathered whether light was gathered there
     * @param leavesCaustics whether paths from lights that look for caustics are scattered there, too: otherwise this path leaves nothing to
     *     them from here on
     */
    void leaveInMedium(boolean hasGathered, boolean leavesCaustics) {
        scatteredFirst = leavesCaustics && (scattered ? scatteredFirst : !deltaFirst);
        scattered = true;
        hasMet |= connects;
        connects = true;
        gathered = hasGathered;
        behindBorder |= !leavesCaustics;
    }

    /** Whether the eye sees the surface that the path is at, or the first that it was scattered by, in a mirror or through glass. */
    boolean isSeenByMirrors() {
        return scattered ? !scatteredFirst : deltaFirst;
    }

    /** Whether a path from a light that is scattered where this one is could have met it there or before. */
    boolean meetsOtherEnd() {
        return hasMet || connects;
    }
}
