package enlightenment.shading;

import enlightenment.compiled.ChanceLight;
import enlightenment.compiled.ChanceLights;
import enlightenment.compiled.CompiledScene;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Finds out how much of a picture paths from the eye find by chance only, part by part. Where the picture is the mean of several moments,
 * paths see them in turns: what a sample finds in the mean is what counts.
 */
public final class ChanceSearch {
    private static final long SEED = 0x6368616e6365L;

    /** Paths in all. */
    private static final int PATHS = 1 << 13;

    /** Of each part of the picture at least. */
    private static final int LEAST = 8;

    /** Of more moments than this so many are looked at, as far from each other. */
    private static final int MOMENTS = 16;

    private final CompiledScene scene;
    private final ChanceProbe[] probes;

    /** How many parts of the picture there are beside each other, and below each other. */
    private final int across;

    private final int down;

    /** Null if paths from the eye alone are asked for, or none from both ends could meet. */
    private final ConnectionProbe connected;

    private ChanceSearch(CompiledScene scene, ChanceProbe[] probes, boolean fromBothEnds, BooleanSupplier cancelled) {
        this.scene = scene;
        this.probes = probes;
        int columns = (int) Math.ceil(scene.camera.columns);
        int rows = (int) Math.ceil(scene.camera.rows);
        int side = 1;
        // As many parts as there are enough paths for, of about the shape of pixels.
        while ((long) ((columns + side - 1) / side) * ((rows + side - 1) / side) > PATHS / LEAST) {
            side++;
        }
        across = (columns + side - 1) / side;
        down = (rows + side - 1) / side;
        connected = fromBothEnds && Arrays.stream(probes).anyMatch(ChanceProbe::hasBeams)
                ? new ConnectionProbe(probes, across, down, cancelled)
                : null;
    }

    /**
     * What is left to chance by paths from the eye in the picture of a scene of physical shading.
     *
     * @param cancelled asked now and then
     * @throws java.util.concurrent.CancellationException soon after that has become true
     */
    public static ChanceLights byEye(CompiledScene scene, BooleanSupplier cancelled) {
        return find(scene, false, cancelled);
    }

    /** The same by paths from both ends. */
    public static ChanceLights byBothEnds(CompiledScene scene, BooleanSupplier cancelled) {
        return find(scene, true, cancelled);
    }

    private static ChanceLights find(CompiledScene scene, boolean fromBothEnds, BooleanSupplier cancelled) {
        if (!scene.hasCausticPass()) {
            return ChanceLights.NONE;
        }
        CompiledScene[] moments = scene.moments();
        ChanceProbe[] probes = new ChanceProbe[Math.min(moments.length, MOMENTS)];
        Arrays.setAll(
                probes, k -> new ChanceProbe(moments[(int) ((long) k * moments.length / probes.length)], cancelled));
        return Arrays.stream(probes).anyMatch(ChanceProbe::isOfUse)
                ? new ChanceSearch(scene, probes, fromBothEnds, cancelled).look()
                : ChanceLights.NONE;
    }

    /** Which moment the k-th of n paths of a part sees: with fewer paths than moments, other ones in the next part. */
    static int moment(int k, int n, int part, int moments) {
        return (int) (((long) k * moments / n + part) % moments);
    }

    private ChanceLights look() {
        ChanceLight.Builder[] parts = new ChanceLight.Builder[ChanceProbe.GROUPS];
        Arrays.setAll(parts, k -> new ChanceLight.Builder(across, down));
        int paths = PATHS / (across * down);
        for (int part = 0; part < across * down; part++) {
            set(parts, part, follow(part, paths), paths);
        }
        return gather(parts, paths);
    }

    /** Follows so many paths of a part; returns the other radiance that they find in the mean, by band. */
    private double[] follow(int part, int paths) {
        double[] other = new double[3];
        double white = Math.scalb(1.0, (int) Math.ceil(Math.max(-scene.display.exposure(), -1000)));
        SobolSampler sampler = new SobolSampler();
        sampler.pixel(SEED, part % across, part / across);
        Ray ray = new Ray();
        double[] color = new double[3];
        for (ChanceProbe probe : probes) {
            probe.forget();
        }
        for (int k = 0; k < paths; k++) {
            sampler.sample(k);
            probes[moment(k, paths, part, probes.length)].follow(
                    (part % across + sampler.filmX()) / across,
                    (part / across + sampler.filmY()) / down,
                    sampler,
                    ray,
                    color);
            for (int c = 0; c < 3; c++) {
                // What is whiter than white was found by chance, or shows nothing else.
                other[c] += Math.min(Math.max(color[c], 0), white) / paths;
            }
        }
        return other;
    }

    /** Sets what was found in a part of the picture by so many paths. Light that is easier to find is there where other light is sought. */
    private void set(ChanceLight.Builder[] parts, int part, double[] other, int paths) {
        for (ChanceProbe probe : probes) {
            probe.gatherBeams(connected != null);
        }
        if (connected != null) {
            connected.set(part, other, paths);
        }
        for (int k = ChanceProbe.GROUPS - 1; k >= 0; k--) {
            double[] hidden = new double[3];
            double chance = 0;
            for (ChanceProbe probe : probes) {
                for (int c = 0; c < 3; c++) {
                    hidden[c] += probe.light[k][c] / paths;
                }
                chance += probe.chance[k] / paths;
            }
            parts[k].set(part, other, hidden, chance);
            for (int c = 0; k != ChanceProbe.SURFACES && c < 3; c++) {
                other[c] += hidden[c];
            }
        }
    }

    private ChanceLights gather(ChanceLight.Builder[] parts, int paths) {
        ChanceLights all = ChanceLights.NONE.and(ChanceLights.Kind.SURFACES, parts[ChanceProbe.SURFACES].build());
        for (int k = 0; k < MediumBeams.GROUPS; k++) {
            boolean isAll = connected == null || k == MediumBeams.SUN;
            all = all.and(isAll ? MediumBeams.kind(k) : ChanceLights.Kind.UNCONNECTED_IN_MEDIA, parts[1 + k].build());
        }
        return connected == null ? all : all.and(ChanceLights.Kind.CONNECTED_IN_MEDIA, connected.find(paths));
    }
}
