package enlightenment.transport.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.world.light.CausticPass;

/**
 * Which part of a light path is a caustic: what comes after a first event at a mirror or smooth glass; of small lights, and where lobes are
 * wide, after one at a narrow lobe as well (docs/notes/caustics.md). Mutable, one per thread.
 */
final class CausticCount {
    /** Null if all of each path counts. */
    private final CausticPass pass;

    /** Whether narrow lobes make caustics of small lights. */
    private final boolean takesNarrow;

    /** The light that the path began at. */
    private int light;

    private boolean counts;

    /** Whether it does so at wide lobes only: a narrow one has scattered it first. */
    private boolean countsWide;

    /** Where that was, and with which density per solid angle the path left it. */
    private double x;

    private double y;
    private double z;
    private double pdf;

    CausticCount(CausticPass pass, boolean takesNarrow) {
        this.pass = pass;
        this.takesNarrow = takesNarrow;
    }

    /** Begins with a path that leaves a light, by its index in the pass. */
    void begin(int ofLight) {
        light = ofLight;
        counts = pass == null;
        countsWide = false;
        pdf = 0;
    }

    /** Whether the path counts now. */
    boolean counts() {
        return counts;
    }

    /** Whether it does so since a narrow lobe scattered it first. */
    boolean isNarrow() {
        return countsWide;
    }

    /** Whether it counts where it goes on to from lobes that it has come to. */
    boolean goesOn(Bsdf bsdf) {
        return counts || bsdf.hasDelta() || takesNarrow && bsdf.isNarrow() && pass.takesNarrow(light);
    }

    /** Whether it counts beyond the lobe that was sampled: beside a delta lobe others make no caustic. */
    boolean countsBeyond(Bsdf bsdf, boolean isDelta) {
        return counts || isDelta || !bsdf.hasDelta();
    }

    /** Whether it counts at these lobes already: others are what makes it count. */
    boolean countsAt(Bsdf bsdf) {
        return counts && !bsdf.isDelta() && !(countsWide && bsdf.isNarrow());
    }

    /** The path has been scattered, by a delta lobe or not, where it goes on. */
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
