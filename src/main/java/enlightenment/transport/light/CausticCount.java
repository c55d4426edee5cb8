package enlightenment.transport.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.world.light.CausticPass;

/**
 * Decides which vertices of a light path belong to the caustic pass: those after a first event at a mirror or smooth glass; for small
 * lights, at wide lobes, also those after a first event at a narrow lobe (docs/notes/caustics.md). Mutable, one per thread.
 */
final class CausticCount {
    /** The caustic pass; null if all vertices of each path count. */
    private final CausticPass pass;

    /** Whether narrow lobes count as casters for small lights. */
    private final boolean takesNarrow;

    /** The index of the path's light in the pass. */
    private int light;

    private boolean counts;

    /** Whether the path counts at wide lobes only, because a narrow lobe scattered it first. */
    private boolean countsWide;

    /** The position of that first event, in the frame, and the density per solid angle of its BSDF sample. */
    private double x;

    private double y;
    private double z;
    private double pdf;

    CausticCount(CausticPass pass, boolean takesNarrow) {
        this.pass = pass;
        this.takesNarrow = takesNarrow;
    }

    /**
     * Begins a path.
     *
     * @param ofLight index of its light in the pass
     */
    void begin(int ofLight) {
        light = ofLight;
        counts = pass == null;
        countsWide = false;
        pdf = 0;
    }

    /** Whether the path belongs to the caustic pass from here on. */
    boolean counts() {
        return counts;
    }

    /** Whether it does because a narrow lobe scattered the path first. */
    boolean isNarrow() {
        return countsWide;
    }

    /** Whether the path may belong to the caustic pass after an event at this BSDF. */
    boolean continues(Bsdf bsdf) {
        return counts || bsdf.hasDelta() || takesNarrow && bsdf.isNarrow() && pass.takesNarrow(light);
    }

    /** Whether it belongs to the pass after the sampled lobe: of a BSDF with a delta lobe, other lobes start no caustic. */
    boolean countsBeyond(Bsdf bsdf, boolean isDelta) {
        return counts || isDelta || !bsdf.hasDelta();
    }

    /** Whether light arriving at this BSDF belongs to the caustic pass. */
    boolean countsAt(Bsdf bsdf) {
        return counts && !bsdf.isDelta() && !(countsWide && bsdf.isNarrow());
    }

    /**
     * Records a scattering event after which the path goes on.
     *
     * @param density per solid angle of the BSDF sample
     */
    void leave(boolean isDelta, Hit at, double density) {
        if (!counts && !isDelta) {
            countsWide = true;
            x = at.px;
            y = at.py;
            z = at.pz;
            pdf = density;
        }
        counts = true;
    }
}
