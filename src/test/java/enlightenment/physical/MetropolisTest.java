package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Markov chains in blocks make the picture of evenly spaced rays, however long they are, and say what they did. */
class MetropolisTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.all();
    private static final Map<String, List<Image>> TRACED = new ConcurrentHashMap<>();
    private static final int[] LENGTHS = {1, 1000};
    private static final int COMPARISONS = 15;

    private static final List<String> SOME = List.of(
            "coated", "lights of all kinds", "metals", "nested glass", "pane", "rough glass", "sphere light in a wall");

    static Stream<Arguments> scenesAndLengths() {
        return SOME.stream().flatMap(scene -> Arrays.stream(LENGTHS).mapToObj(length -> Arguments.of(scene, length)));
    }

    static Stream<Arguments> allScenesAndLengths() {
        return SCENES.keySet().stream()
                .flatMap(scene -> Arrays.stream(LENGTHS).mapToObj(length -> Arguments.of(scene, length)));
    }

    private static RenderSettings chains(Scene scene, int largeSteps, int mutations, double samples) {
        return RenderSettings.of(scene)
                .using(new BuiltInMethod.MetropolisSettings(largeSteps, mutations))
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    private static List<Image> traced(String name, int seeds) {
        Scene scene = SCENES.get(name);
        return TRACED.computeIfAbsent(name + seeds, n -> Rendered.seeds(scene, 8, 1000, seeds));
    }

    /** Welch's test on means of quarters and of the whole in each band, at 1 % for all comparisons together by Šidák's formula. */
    private static void assertSame(String what, List<Image> ours, List<Image> others, int cases) {
        int width = ours.get(0).width();
        int height = ours.get(0).height();
        double level = Welch.sidak(0.01, COMPARISONS * cases);
        for (int band = 0; band < 3; band++) {
            for (int part = 0; part < 5; part++) {
                int left = part < 4 ? part % 2 * width / 2 : 0;
                int top = part < 4 ? part / 2 * height / 2 : 0;
                int right = part < 4 ? left + width / 2 : width;
                int bottom = part < 4 ? top + height / 2 : height;
                double[] a = Rendered.means(ours, left, top, right, bottom, band);
                double[] b = Rendered.means(others, left, top, right, bottom, band);
                String told = what + ", part " + part + ", band " + band + ": " + Statistics.of(a) + " instead of "
                        + Statistics.of(b);
                assertTrue(Welch.of(a, b).probability() >= level, told);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("scenesAndLengths")
    void chainsOfAnyLengthMeanThePictureOfEvenlySpacedRays(String name, int mutations) {
        Scene scene = SCENES.get(name);
        List<Image> ours = Rendered.seeds(scene, chains(scene, 5, mutations, 12), 1, 24);
        assertSame(name + ", length " + mutations, ours, traced(name, 8), LENGTHS.length * SOME.size());
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("allScenesAndLengths")
    void soTheyDoInManyPictures(String name, int mutations) {
        Scene scene = SCENES.get(name);
        List<Image> ours = Rendered.seeds(scene, chains(scene, 5, mutations, 16), 1, 256);
        assertSame(name + ", length " + mutations, ours, traced(name, 64), LENGTHS.length * SCENES.size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"metals", "window"})
    void theyMeanThePictureOfTheNaiveTracer(String name) {
        Scene scene = SCENES.get(name);
        NaivePartnerTest.compare(scene, chains(scene, 30, 100, 12), new NaiveTracer(scene), 24, 3_000);
    }

    @Test
    void withLargeStepsAloneChainsAreIndependentPathsAndMeanTheSame() {
        String name = "metals";
        Scene scene = SCENES.get(name);
        RenderSettings settings = chains(scene, 100, 50, 12);
        assertSame("large steps", Rendered.seeds(scene, settings, 1, 24), traced(name, 8), 1);
        for (RenderResult.PathChain chain : dump(scene, settings).chains()) {
            assertEquals(chain.steps(), chain.largeSteps());
            assertEquals(chain.accepted(), chain.largeAccepted());
        }
    }

    /** A picture of six blocks of which all but one are cut by its borders, so that some have a few columns only. */
    @Test
    void noBlockIsBrighterThanItShouldBe() {
        Scene scene = SCENES.get("panel to one side");
        RenderSettings settings = chains(scene, 5, 250, 8).withSize(131, 70);
        List<Image> ours = Rendered.seeds(scene, settings, 1, 24);
        List<Image> others =
                Rendered.seeds(scene, RenderSettings.of(scene).withSize(131, 70).withAntialias(3), 1000, 16);
        double level = Welch.sidak(0.01, 6);
        for (int block = 0; block < 6; block++) {
            int left = block % 3 * 64;
            int top = block / 3 * 64;
            int right = Math.min(left + 64, 131);
            int bottom = Math.min(top + 64, 70);
            double[] a = Rendered.means(ours, left, top, right, bottom, 1);
            double[] b = Rendered.means(others, left, top, right, bottom, 1);
            assertTrue(Welch.of(a, b).probability() >= level, "block " + block);
            for (double brightness : a) {
                // Where a block of three columns shows nothing but the dark outside, there is nothing to compare.
                assertEquals(
                        Statistics.of(b).mean(),
                        brightness,
                        0.3 * Statistics.of(b).mean(),
                        "block " + block);
            }
        }
    }

    @Test
    void aDarkPictureIsBlack() {
        Scene scene = PhysicalScenes.room().build();
        for (float v : Renderer.render(scene, chains(scene, 5, 250, 16)).toArray()) {
            assertEquals(0, v);
        }
    }

    private static RenderResult dump(Scene scene, RenderSettings settings) {
        return Renderer.render(RenderRequest.of(scene, settings).withChains(true));
    }

    @Test
    void whatIsToldOfChainsIsWhatTheReportCounts() {
        Scene scene = SCENES.get("metals");
        RenderSettings settings = chains(scene, 20, 40, 16).withSize(70, 20);
        RenderResult one = dump(scene, settings.withThreads(1));
        RenderResult three = dump(scene, settings.withThreads(3));
        assertEquals(one.chains(), three.chains());
        long steps = 0;
        long accepted = 0;
        long large = 0;
        Set<Integer> groups = new HashSet<>();
        for (RenderResult.PathChain chain : one.chains()) {
            steps += chain.steps();
            accepted += chain.accepted();
            large += chain.largeSteps();
            groups.add(chain.group());
            assertTrue(chain.blockX() == 0 || chain.blockX() == 64);
            assertEquals(chain.blockX(), chain.startX() / 64 * 64);
            assertEquals(chain.blockX(), chain.endX() / 64 * 64);
            assertTrue(chain.startBrightness() > 0 && chain.meanBrightness() > 0);
            assertTrue(chain.steps() >= 20 && chain.steps() <= 80, "steps " + chain.steps());
        }
        assertEquals(Set.of(0, 1, 2, 3, 4, 5, 6, 7), groups);
        assertEquals(one.chains().size(), one.report().sampling().clusters());
        assertEquals(steps, one.report().sampling().proposals());
        assertEquals(accepted, one.report().sampling().accepted());
        assertEquals(0.2 * steps, large, 4 * Math.sqrt(0.16 * steps));
        assertEquals(2, BuiltInMethod.MetropolisSettings.blocks(settings));
        assertEquals(
                List.of(), Renderer.render(RenderRequest.of(scene, settings)).chains());
    }

    @Test
    void samplesAreAllCameraPathsAndAboutAsManyAsPlanned() {
        Scene scene = SCENES.get("metals");
        for (double samples : new double[] {8, 20, 64}) {
            RenderResult result = dump(scene, chains(scene, 5, 250, samples).withSize(64, 40));
            assertEquals(Method.METROPOLIS, result.report().sampling().method());
            assertEquals(samples, result.report().sampling().samplesPerPixel(), 0.1 * samples);
        }
    }

    @Test
    void belowEightSamplesItIsRaytrace() {
        Scene scene = SCENES.get("metals");
        RenderResult few = dump(scene, chains(scene, 5, 250, 4));
        assertEquals(Method.RAYTRACE, few.report().sampling().method());
        assertEquals(List.of(), few.chains());
    }

    /** Quarters do not depend on each other: so what they tell is the squared error that pictures have, in the mean over pictures. */
    @Test
    void theErrorThatIsToldIsThatOfThePictures() {
        Scene scene = SceneReader.read(Path.of("scenes/cornell-box.json"));
        RenderSettings settings = chains(scene, 5, 250, 16).withSize(48, 48).withThreads(1);
        int seeds = 8;
        double told = 0;
        List<float[]> pictures = new ArrayList<>();
        for (int seed = 0; seed < seeds; seed++) {
            RenderResult result = Renderer.render(RenderRequest.of(scene, settings.withSeed(seed)));
            told += Math.pow(result.report().sampling().estimatedError(), 2) / seeds;
            pictures.add(shown(result.image()));
        }
        double squares = 0;
        int n = pictures.get(0).length;
        for (int i = 0; i < n; i++) {
            double mean = 0;
            for (float[] picture : pictures) {
                mean += picture[i] / (double) seeds;
            }
            for (float[] picture : pictures) {
                squares += (picture[i] - mean) * (picture[i] - mean) / (seeds - 1) / n;
            }
        }
        assertEquals(1, told / squares, 0.35);
        assertNotEquals(0, squares);
    }

    private static float[] shown(Image image) {
        float[] out = new float[3 * image.width() * image.height()];
        for (int i = 0; i < out.length; i++) {
            out[i] = image.displayed(i / 3 % image.width(), i / 3 / image.width(), i % 3);
        }
        return out;
    }
}
