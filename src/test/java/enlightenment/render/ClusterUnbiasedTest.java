package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.BlockMeans.Verdict;
import enlightenment.render.ManySeeds.Picture;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The methods mean the same picture: over independent seeds neither blocks nor the whole differ. */
class ClusterUnbiasedTest {
    private static final int SEEDS = 32;
    private static final int GUIDED_SEEDS = 8;
    private static final int FULL_SEEDS = 128;
    private static final int WIDTH = 48;
    private static final int HEIGHT = 24;
    private static final BlockMeans BLOCKS = new BlockMeans(WIDTH, HEIGHT);

    /** Seeds of raytrace must not be those of cluster: the two methods have their random numbers in common. */
    private static final long APART = 1000;

    private static RenderSettings settings(Scene scene, Method method, int width, int height) {
        return RenderSettings.of(scene).withMethod(method).withSize(width, height);
    }

    private static RenderSettings cluster(Scene scene, double samples) {
        return settings(scene, Method.CLUSTER, WIDTH, HEIGHT)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    private static List<double[]> rgb(List<Picture> pictures) {
        return pictures.stream().map(Picture::rgb).toList();
    }

    private static final Map<String, List<double[]>> TRACED = new ConcurrentHashMap<>();

    private static List<double[]> traced(Scene scene) {
        return TRACED.computeIfAbsent(scene.name(), name -> traced(scene, WIDTH, HEIGHT, SEEDS));
    }

    private static List<double[]> traced(Scene scene, int width, int height, int seeds) {
        RenderSettings s = settings(scene, Method.RAYTRACE, width, height);
        return rgb(
                ManySeeds.render(scene, s.withAntialias(4).with(new BuiltInMethod.RayTraceSettings(4)), APART, seeds));
    }

    private static final Map<String, List<double[]>> CLUSTERED = new ConcurrentHashMap<>();

    private static List<double[]> clustered(Scene scene, double samples, int seeds) {
        return CLUSTERED.computeIfAbsent(
                scene.name() + " " + samples + " " + seeds,
                key -> rgb(ManySeeds.render(scene, cluster(scene, samples), 0, seeds)));
    }

    private static List<double[]> brighter(List<double[]> pictures, double factor) {
        return pictures.stream()
                .map(rgb -> Arrays.stream(rgb).map(v -> factor * v).toArray())
                .toList();
    }

    private static void assertSame(Verdict v, String what) {
        assertFalse(v.isDifferent(), what + ": " + v);
        assertTrue(v.most() < 4, what + ": " + v);
    }

    @ParameterizedTest
    @CsvSource({"fire-and-ice, 2.5", "cone, 2.5", "cone, 12", "keyhole, 12"})
    void clusterAndRaytraceMeanTheSamePicture(String name, double samples) {
        Scene scene = ManySeeds.shipped(name);
        Verdict v = BLOCKS.compare(clustered(scene, samples, SEEDS), traced(scene));
        assertSame(v, name + " with " + samples + " samples");
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"fire-and-ice", "cylinders", "cone", "glass", "keyhole"})
    void soTheyDoWithFewSamplesInEveryScene(String name) {
        Scene scene = ManySeeds.shipped(name);
        List<double[]> expected = traced(scene);
        for (double samples : new double[] {2.5, 12}) {
            // Through a keyhole few samples see the light once in many pictures: far from a normal distribution, which
            // Welch's test assumes of means. More pictures make their means so.
            int seeds = name.equals("keyhole") && samples < 4 ? 16 * SEEDS : SEEDS;
            List<double[]> actual = clustered(scene, samples, seeds);
            assertSame(BLOCKS.compare(actual, expected), name + " with " + samples + " samples");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void guidedLightPointsMeanTheSamePictureWithEveryFamily(String family) {
        List<double[]> expected = traced(ManySeeds.shipped("keyhole"));
        List<double[]> guided = guided(family, GUIDED_SEEDS);
        // Four standard errors are nothing rare in means of so few pictures; Welch's test knows how few they are. Its
        // level
        // of 1 % is that of a right program's failure, for each family.
        Verdict v = BLOCKS.compare(guided, expected);
        assertFalse(v.isDifferent(), family + ": " + v);
        Verdict other = BLOCKS.compare(brighter(guided, 1.02), expected);
        assertTrue(other.isDifferent(), "a bias of two percent with " + family + ": " + other);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void guidedLightPointsOfMorePicturesMeanTheSameToo(String family) {
        assertSame(BLOCKS.compare(guided(family, SEEDS), traced(ManySeeds.shipped("keyhole"))), family);
    }

    private static List<double[]> guided(String family, int seeds) {
        Scene scene = ManySeeds.shipped("keyhole");
        RenderSettings s = cluster(scene, 40).with(new BuiltInMethod.ClusterSettings(family));
        List<Picture> pictures = ManySeeds.render(scene, s, 5000, seeds);
        double clusters = pictures.stream()
                .mapToLong(p -> p.sampling().clusters())
                .average()
                .orElseThrow();
        assertTrue(clusters > 4, "clusters that propose: " + clusters + " in 18 blocks");
        return rgb(pictures);
    }

    /** Without this, the tests above could be blind. */
    @Test
    void aBiasOfOnePercentWouldBeDetected() {
        Scene scene = ManySeeds.shipped("keyhole");
        List<double[]> expected = traced(scene);
        Verdict v = BLOCKS.compare(brighter(clustered(scene, 12, SEEDS), 1.01), expected);
        assertTrue(v.isDifferent(), v.toString());
    }

    /** Taking more samples only where the first ones differ loses the light that the first ones did not find. */
    @Test
    void stoppingWhereTheFirstSamplesAgreeWouldBeDetected() {
        Scene scene = ManySeeds.shipped("keyhole");
        List<double[]> expected = traced(scene);
        RenderSettings s = settings(scene, Method.RAYTRACE, WIDTH, HEIGHT).with(new BuiltInMethod.RayTraceSettings(1));
        List<Picture> few = ManySeeds.render(scene, s.withAntialias(2), 0, SEEDS);
        List<Picture> many = ManySeeds.render(scene, s.withAntialias(4), 0, SEEDS);
        List<double[]> stopped = new ArrayList<>();
        for (int i = 0; i < SEEDS; i++) {
            float[] variances = few.get(i).film().error().variances();
            double[] rgb = many.get(i).rgb().clone();
            for (int k = 0; k < rgb.length; k++) {
                rgb[k] = variances[k / 3] < 1e-5 ? few.get(i).rgb()[k] : rgb[k];
            }
            stopped.add(rgb);
        }
        assertFalse(BLOCKS.compare(rgb(many), expected).isDifferent(), "all samples");
        assertTrue(BLOCKS.compare(stopped, expected).isDifferent(), "stopped");
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({
        "fire-and-ice, 2.5",
        "fire-and-ice, 5",
        "fire-and-ice, 50",
        "cylinders, 5",
        "cylinders, 50",
        "cone, 5",
        "cone, 50",
        "glass, 5",
        "glass, 50",
        "keyhole, 3",
        "keyhole, 8",
        "keyhole, 100",
        "torus, 8",
        "cube, 8",
        "primitives, 8"
    })
    void largerPicturesAreTheSameToo(String name, double samples) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings s =
                settings(scene, Method.CLUSTER, 96, 48).withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        BlockMeans blocks = new BlockMeans(96, 48);
        Verdict v = blocks.compare(rgb(ManySeeds.render(scene, s, 0, FULL_SEEDS)), traced(scene, 96, 48, FULL_SEEDS));
        assertSame(v, name + " with " + samples + " samples");
    }
}
