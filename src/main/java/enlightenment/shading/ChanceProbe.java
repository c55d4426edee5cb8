package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.ChanceLight;
import enlightenment.compiled.ChanceLights;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.HomogeneousMedium;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.RefractingMedia;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import java.util.Arrays;

/**
 * Finds out how much of a picture paths from the eye find by chance only: at surfaces that are seen in mirrors or through glass, and in
 * media behind borders that refract, how bright light is there that mirrors or glass send to them, by {@link CausticArrivals} and {@link
 * MediumBeams}. Nothing of it is part of a picture.
 */
public final class ChanceProbe {
    private static final long SEED = 0x6368616e6365L;

    /** Paths in all. */
    private static final int PATHS = 1 << 13;

    /** Of each part of the picture at least. */
    private static final int LEAST = 8;

    /** From this event on not all of a path's places in media are looked at: of twice as many every second one, and so on. */
    private static final int LONG = 16;

    /** The first group of what is found: light on surfaces; the others are those of {@link MediumBeams}. */
    private static final int SURFACES = 0;

    private static final int GROUPS = 1 + MediumBeams.GROUPS;

    /** Null if no such light comes to surfaces. */
    private final CausticArrivals arrivals;

    /** Null if none comes to media. */
    private final MediumBeams beams;

    /** What the last paths have found, by group: of such light, and how many directions find it. */
    private final double[][] light = new double[GROUPS][3];

    private final double[] chance = new double[GROUPS];

    private ChanceProbe(CausticArrivals arrivals, MediumBeams beams) {
        this.arrivals = arrivals;
        this.beams = beams;
    }

    /** What is left to chance in the picture of a scene of physical shading. */
    public static ChanceLights find(CompiledScene scene) {
        if (!scene.physical.hasCausticPass()) {
            return ChanceLights.NONE;
        }
        MediumBeams beams = RefractingMedia.areThere(scene) ? MediumBeams.of(scene) : null;
        boolean showsCaustics = scene.physical.showsMirrored || beams != null;
        CausticArrivals arrivals = showsCaustics ? CausticArrivals.of(scene) : null;
        return arrivals == null && beams == null ? ChanceLights.NONE : new ChanceProbe(arrivals, beams).look(scene);
    }

    /** The picture is cut into as many parts as there are enough paths for, of about the shape of pixels. */
    private ChanceLights look(CompiledScene scene) {
        int columns = (int) Math.ceil(scene.camera.columns);
        int rows = (int) Math.ceil(scene.camera.rows);
        int side = 1;
        while ((long) ((columns + side - 1) / side) * ((rows + side - 1) / side) > PATHS / LEAST) {
            side++;
        }
        int across = (columns + side - 1) / side;
        int down = (rows + side - 1) / side;
        PathTracer tracer = PathTracer.probing(scene, new RayCounters(scene.kindNames.size()), this);
        tracer.beginTile(0, 0, 1, 1);
        ChanceLight.Builder[] parts = new ChanceLight.Builder[GROUPS];
        Arrays.setAll(parts, k -> new ChanceLight.Builder(across, down));
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        int paths = PATHS / (across * down);
        double white = Math.scalb(1.0, (int) Math.ceil(Math.max(-scene.display.exposure(), -1000)));
        for (int part = 0; part < across * down; part++) {
            double[] other = new double[3];
            sampler.pixel(SEED, part % across, part / across);
            forget();
            for (int k = 0; k < paths; k++) {
                sampler.sample(k);
                scene.camera.ray(
                        (part % across + sampler.filmX()) / across, (part / across + sampler.filmY()) / down, ray);
                tracer.shade(ray, sampler, color);
                for (int c = 0; c < 3; c++) {
                    // What is whiter than white was found by chance, or shows nothing else.
                    other[c] += Math.min(Math.max(color[c], 0), white) / paths;
                }
            }
            set(parts, part, other, paths);
        }
        return gather(parts);
    }

    private void forget() {
        for (double[] bands : light) {
            Arrays.fill(bands, 0);
        }
        Arrays.fill(chance, 0);
        if (beams != null) {
            beams.forget();
        }
    }

    /** Sets what was found in a part of the picture by so many paths. Light that is easier to find is there where other light is sought. */
    private void set(ChanceLight.Builder[] parts, int part, double[] other, int paths) {
        for (int k = 0; beams != null && k < MediumBeams.GROUPS; k++) {
            light[1 + k] = beams.light[k];
            chance[1 + k] = beams.chance[k];
        }
        for (int k = GROUPS - 1; k >= 0; k--) {
            double[] hidden = new double[3];
            for (int c = 0; c < 3; c++) {
                hidden[c] = light[k][c] / paths;
            }
            parts[k].set(part, other, hidden, chance[k] / paths);
            for (int c = 0; k != SURFACES && c < 3; c++) {
                other[c] += hidden[c];
            }
        }
    }

    private static ChanceLights gather(ChanceLight.Builder[] parts) {
        ChanceLights all = ChanceLights.NONE.and(ChanceLights.Kind.SURFACES, parts[SURFACES].build());
        for (int k = 0; k < MediumBeams.GROUPS; k++) {
            all = all.and(MediumBeams.kind(k), parts[1 + k].build());
        }
        return all;
    }

    /** The path is at a surface that the eye sees in mirrors or through glass, or from media behind borders. */
    void look(Bsdf bsdf, Scattering s, Hit at, PathValue value) {
        if (arrivals == null) {
            return;
        }
        arrivals.look(bsdf, s, at, value);
        for (int c = 0; c < 3; c++) {
            light[SURFACES][c] += arrivals.light[c];
        }
        chance[SURFACES] += arrivals.chance;
    }

    /**
     * The path is where a medium scatters it.
     *
     * @param medium null if lamps are sampled from there
     * @param events how many it had before
     */
    void look(HomogeneousMedium medium, Scattering s, PathFollower path, PathValue value, int events) {
        if (beams == null || medium == null) {
            return;
        }
        int step = Math.max(Integer.highestOneBit(events / LONG), 1);
        if (events % step == 0) {
            beams.look(medium, s, path.hit, value, step, path.bounces());
        }
    }
}
