package enlightenment.shading;

import enlightenment.compiled.ChanceLight;
import enlightenment.compiled.RareFinds;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Finds out how {@link BidirectionalTracer} finds light of points and small lamps that is scattered more than once behind borders that
 * refract: few paths from lights come into such a medium, and of those few come to where the path from the eye is, which then are worth
 * much. Some of these few are sought, and each is connected to some paths from the eye.
 */
final class ConnectionProbe {
    private static final long SEED = 0x636f6e6e656374L;

    private final ChanceProbe[] probes;

    /** The paths that come in, by moment. */
    private final EnteringPaths[] entering;

    private final ChanceLight.Builder parts;
    private final int across;

    /** By part, row by row: the radiance of that light, mean of the bands, and how much the finds there count. */
    private final double[] light;

    private final double[] weight;

    /**
     * Seeks paths that come in.
     *
     * @param probes what has looked for such light, a moment each
     * @param cancelled as of {@link EnteringPaths}
     */
    ConnectionProbe(ChanceProbe[] probes, int across, int down, BooleanSupplier cancelled) {
        this.probes = probes;
        this.across = across;
        parts = new ChanceLight.Builder(across, down);
        light = new double[across * down];
        weight = new double[across * down];
        entering = new EnteringPaths[probes.length];
        Arrays.setAll(entering, k -> new EnteringPaths(probes[k].scene, SEED, probes[k].hasBeams(), cancelled));
    }

    /**
     * Sets how much of that light there is in a part of the picture, by what so many paths found.
     *
     * @param other all other light by band; this light is added
     */
    void set(int part, double[] other, int paths) {
        double[] hidden = new double[3];
        for (ChanceProbe probe : probes) {
            probe.addConnected(hidden);
        }
        double effect = 0;
        for (int c = 0; c < 3; c++) {
            hidden[c] = Math.max(hidden[c] / paths, 0);
            light[part] += hidden[c] / 3;
            double shown =
                    probes[0].scene.display.nearly(other[c] + hidden[c]) - probes[0].scene.display.nearly(other[c]);
            effect += shown * shown;
        }
        weight[part] = effect;
        parts.set(part, other, hidden, 0);
        for (int c = 0; c < 3; c++) {
            other[c] += hidden[c];
        }
    }

    /** That light, and how samples find it; null if there is none. So many paths are followed in each part. */
    ChanceLight find(int paths) {
        double found = 0;
        int tried = 0;
        for (EnteringPaths some : entering) {
            found += some.probability() / entering.length;
            tried += some.tried();
        }
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        double[] worth = new double[light.length * paths];
        double[] counts = new double[worth.length];
        int size = 0;
        for (int part = 0; part < light.length; part++) {
            sampler.pixel(SEED, part % across, part / across);
            for (int k = 0; k < paths && weight[part] > 0 && light[part] > 0; k++) {
                EnteringPaths some = entering[ChanceSearch.moment(k, paths, part, entering.length)];
                if (some.probability() > 0) {
                    sampler.sample(k);
                    some.scene.camera.ray(
                            (part % across + sampler.filmX()) / across,
                            (part / across + sampler.filmY()) / (light.length / across),
                            ray);
                    some.connectNext(ray, sampler, color);
                    worth[size] = (color[0] + color[1] + color[2]) / (3 * light[part]);
                    // Paths come in at some moments more often than at others.
                    counts[size++] = weight[part] * (some.probability() / found);
                }
            }
        }
        RareFinds finds =
                size == 0 ? null : RareFinds.of(found, Arrays.copyOf(worth, size), Arrays.copyOf(counts, size));
        // What none has found the next one may.
        double[] one = {1};
        return parts.build(finds == null ? RareFinds.of(1.0 / tried, one, one) : finds);
    }
}
