package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.ChanceLight;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;

/**
 * Finds out how much of a picture paths from the eye find by chance only: at surfaces that are seen in mirrors or through glass, how bright
 * light is there that mirrors or glass send to them, by {@link CausticArrivals}. Nothing of it is part of a picture.
 */
public final class ChanceProbe {
    private static final long SEED = 0x6368616e6365L;

    /** Paths in all. */
    private static final int PATHS = 1 << 13;

    /** Of each part of the picture at least. */
    private static final int LEAST = 8;

    private final CausticArrivals arrivals;

    /** What the last path has found: of such light, and how many directions find it. */
    private final double[] light = new double[3];

    private double chance;

    private ChanceProbe(CausticArrivals arrivals) {
        this.arrivals = arrivals;
    }

    /** What is left to chance in the picture of a scene of physical shading; null if nothing is known to be. */
    public static ChanceLight find(CompiledScene scene) {
        if (!scene.physical.hasCausticPass() || !scene.physical.showsMirrored) {
            return null;
        }
        CausticArrivals arrivals = CausticArrivals.of(scene);
        return arrivals == null ? null : new ChanceProbe(arrivals).look(scene);
    }

    /** The picture is cut into as many parts as there are enough paths for, of about the shape of pixels. */
    private ChanceLight look(CompiledScene scene) {
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
        ChanceLight.Builder parts = new ChanceLight.Builder(across * down);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        int paths = PATHS / (across * down);
        double white = Math.scalb(1.0, (int) Math.ceil(Math.max(-scene.display.exposure(), -1000)));
        for (int part = 0; part < across * down; part++) {
            double[] other = new double[3];
            double[] hidden = new double[3];
            double found = 0;
            sampler.pixel(SEED, part % across, part / across);
            for (int k = 0; k < paths; k++) {
                sampler.sample(k);
                scene.camera.ray(
                        (part % across + sampler.filmX()) / across, (part / across + sampler.filmY()) / down, ray);
                light[0] = 0;
                light[1] = 0;
                light[2] = 0;
                chance = 0;
                tracer.shade(ray, sampler, color);
                for (int c = 0; c < 3; c++) {
                    // What is whiter than white was found by chance, or shows nothing else.
                    other[c] += Math.min(Math.max(color[c], 0), white) / paths;
                    hidden[c] += light[c] / paths;
                }
                found += chance / paths;
            }
            parts.set(part, other, hidden, found);
        }
        return parts.build();
    }

    /** The path is at the first surface that the eye sees in mirrors or through glass. */
    void look(Bsdf bsdf, Scattering s, Hit at, PathValue value) {
        arrivals.look(bsdf, s, at, value);
        for (int c = 0; c < 3; c++) {
            light[c] += arrivals.light[c];
        }
        chance += arrivals.chance;
    }
}
