package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.HomogeneousMedium;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.RefractingMedia;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Follows paths from the eye, and looks up what they find by chance only: at surfaces that are seen in mirrors or through glass, and in
 * media behind borders that refract, how bright light is there that mirrors or glass send to them, by {@link CausticArrivals} and {@link
 * MediumBeams}. Nothing of it is part of a picture. Of one moment of a scene of physical shading.
 */
final class ChanceProbe {
    /** The first group of what is found: light on surfaces; the others are those of {@link MediumBeams}. */
    static final int SURFACES = 0;

    static final int GROUPS = 1 + MediumBeams.GROUPS;

    /** From this event on not all of a path's places in media are looked at: of twice as many every second one, and so on. */
    private static final int LONG = 16;

    final CompiledScene scene;

    /** What was found since it was forgotten, by group: radiance of such light, and how many directions find it; both sums over paths. */
    final double[][] light = new double[GROUPS][3];

    final double[] chance = new double[GROUPS];

    /** Null if no such light comes to surfaces. */
    private final CausticArrivals arrivals;

    /** Null if none comes to media. */
    private final MediumBeams beams;

    private final PathTracer tracer;

    /**
     * Prepares for one thread what {@link #follow} looks up.
     *
     * @param cancelled asked now and then, by that as well
     * @throws java.util.concurrent.CancellationException soon after that has become true
     */
    ChanceProbe(CompiledScene scene, BooleanSupplier cancelled) {
        this.scene = scene;
        boolean hasCaustics = scene.physical.hasCausticPass();
        beams = hasCaustics && RefractingMedia.areThere(scene) ? MediumBeams.of(scene, cancelled) : null;
        boolean isSeen = scene.physical.showsMirrored || beams != null;
        boolean showsCaustics = hasCaustics && (isSeen || scene.physical.caustics.takesNarrow());
        arrivals = showsCaustics ? CausticArrivals.of(scene, cancelled) : null;
        tracer = PathTracer.probing(scene, new RayCounters(scene.kindNames.size()), this);
        tracer.stopWhen(cancelled);
        tracer.beginTile(0, 0, 1, 1);
    }

    /** Whether there is anything to find. */
    boolean isOfUse() {
        return arrivals != null || beams != null;
    }

    /** Whether some of it is in media. */
    boolean hasBeams() {
        return beams != null;
    }

    /**
     * Follows the path of a camera ray.
     *
     * @param x where it begins, as a share of the picture's width; and y, of its height
     * @param color receives the radiance that it finds
     */
    void follow(double x, double y, Sampler sampler, Ray ray, double[] color) {
        scene.camera.ray(x, y, ray);
        tracer.shade(ray, sampler, color);
    }

    void forget() {
        for (double[] bands : light) {
            Arrays.fill(bands, 0);
        }
        Arrays.fill(chance, 0);
        if (beams != null) {
            beams.forget();
        }
    }

    /**
     * Takes what was found in media over from the beams.
     *
     * @param fromBothEnds whether only what paths from both ends do not meet on is wanted, but for the sun's
     */
    void gatherBeams(boolean fromBothEnds) {
        for (int k = 0; beams != null && k < MediumBeams.GROUPS; k++) {
            boolean isApart = fromBothEnds && k != MediumBeams.SUN;
            System.arraycopy(isApart ? beams.lightApart[k] : beams.light[k], 0, light[1 + k], 0, 3);
            chance[1 + k] = isApart ? beams.chanceApart[k] : beams.chance[k];
        }
    }

    /** Adds what was found of light in media that paths from both ends meet on: a sum over paths, by band. */
    void addConnected(double[] bands) {
        for (int k = 0; beams != null && k < MediumBeams.GROUPS; k++) {
            for (int c = 0; c < 3 && k != MediumBeams.SUN; c++) {
                bands[c] += beams.light[k][c] - beams.lightApart[k][c];
            }
        }
    }

    /**
     * The path is at a surface that the eye sees in mirrors, through glass or by narrow lobes, or from media behind borders.
     *
     * @param onlyNarrow whether only what narrow lobes make is left to chance there
     */
    void look(Bsdf bsdf, Scattering s, Hit at, PathValue value, boolean onlyNarrow) {
        if (arrivals == null) {
            return;
        }
        arrivals.look(bsdf, s, at, value, onlyNarrow);
        for (int c = 0; c < 3; c++) {
            light[SURFACES][c] += arrivals.light[c];
        }
        chance[SURFACES] += arrivals.chance;
    }

    /**
     * The path is where a medium scatters it.
     *
     * @param medium null if lamps are sampled from there
     * @param history of what it had before
     */
    void look(HomogeneousMedium medium, Scattering s, PathFollower path, PathValue value, PathHistory history) {
        if (beams == null || medium == null) {
            return;
        }
        int step = Math.max(Integer.highestOneBit(history.events / LONG), 1);
        if (history.events % step == 0) {
            boolean isApart = !history.meetsOtherEnd();
            beams.look(medium, s, path.hit, value, step, path.bounces(), isApart);
        }
    }
}
