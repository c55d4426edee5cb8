package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayRgb;
import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders that somebody may look at: a coarse whole picture comes first, and changes nothing of what is returned. */
class WatchedRequestTest {
    /** Everything in it is lit, at least by ambient light, and beyond it there is grey: no pixel of a whole picture is black. */
    private static final Scene SMALL = TestScenes.whiteFireAndIce()
            .size(80, 40)
            .shading(new Shading.Classic(0.1, 0.5, new DisplayRgb(0.5, 0.5, 0.5), 10))
            .build();

    private static final RenderSettings QUICK =
            RenderSettings.of(SMALL).with(new BuiltInMethod.RayTraceSettings(1)).withThreads(2);

    /** Keeps what it is shown. */
    private static final class Looking implements RenderProgress {
        final List<String> heard = new ArrayList<>();
        final List<Image> pictures = new ArrayList<>();

        @Override
        public void coarse(Supplier<Image> soFar) {
            heard.add("coarse");
            pictures.add(soFar.get());
        }

        @Override
        public void planned(double samples, String decidedBy) {
            heard.add("planned");
        }

        @Override
        public void progress(long done, long total, Supplier<Image> soFar) {
            pictures.add(soFar.get());
        }
    }

    private static int black(Image image) {
        int black = 0;
        for (int k = 0; k < image.width() * image.height(); k++) {
            black += image.component(k % image.width(), k / image.width(), 0) == 0 ? 1 : 0;
        }
        return black;
    }

    private static double distance(Image a, Image b) {
        float[] p = a.toArray();
        float[] q = b.toArray();
        double sum = 0;
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (p[i] - q[i]);
        }
        return Math.sqrt(sum / p.length);
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE,1", "RAYTRACE,16", "RAYTRACE,100", "CLUSTER,4", "METROPOLIS,4"})
    void everyPictureFromTheFirstOnIsWholeAndTheLastIsThatOfAnUnwatchedRender(BuiltInMethod method, double samples) {
        RenderSettings settings = QUICK.withMethod(method)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples))
                .withCrop(new RenderSettings.Crop(3, 5, 61, 30));
        RenderResult plain = Renderer.render(RenderRequest.of(SMALL, settings));
        Looking looking = new Looking();
        RenderResult watched = Renderer.render(
                RenderRequest.of(SMALL, settings).withWatched(true).withProgress(looking));
        assertArrayEquals(plain.image().toArray(), watched.image().toArray());
        assertEquals(plain.report().raysByKind(), watched.report().raysByKind());
        assertEquals(plain.report().sampling(), watched.report().sampling());
        assertEquals(List.of("coarse", "planned"), looking.heard);
        for (Image picture : looking.pictures) {
            assertEquals(0, black(picture));
        }
        Image last = looking.pictures.get(looking.pictures.size() - 1);
        assertArrayEquals(plain.image().toArray(), last.toArray());
        // It shows the scene: a picture of one grey is further from it than the first.
        double first = distance(looking.pictures.get(0), last);
        float[] grey = new float[3 * 61 * 30];
        Arrays.fill(grey, mean(last));
        assertTrue(first < distance(new Image(61, 30, grey), last), "the first is off by " + first);
    }

    private static float mean(Image image) {
        double sum = 0;
        for (float f : image.toArray()) {
            sum += f;
        }
        return (float) (sum / image.toArray().length);
    }

    @ParameterizedTest
    @ValueSource(strings = {"caustics.json", "glass-physical.json", "cornell-box.json"})
    void physicalPicturesHaveTheSameBitsToo(String name) throws Exception {
        Scene scene = SceneReader.read(Path.of("scenes", name));
        RenderSettings settings = RenderSettings.of(scene)
                .withSize(40, 24)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(5));
        Looking looking = new Looking();
        RenderResult watched = Renderer.render(
                RenderRequest.of(scene, settings).withWatched(true).withProgress(looking));
        assertArrayEquals(
                Renderer.render(RenderRequest.of(scene, settings)).image().toArray(),
                watched.image().toArray());
        Image last = looking.pictures.get(looking.pictures.size() - 1);
        assertTrue(black(looking.pictures.get(0)) <= black(last) + 40 * 24 / 4, "much is black at first");
    }

    @Test
    void whatIsReturnedOfAStoppedRenderKnowsNothingOfCoarsePasses() {
        AtomicBoolean stop = new AtomicBoolean();
        RenderResult result = Renderer.render(RenderRequest.of(SMALL, QUICK.withAntialias(4))
                .withWatched(true)
                .withCancelled(stop::get)
                .withProgress((done, total, soFar) -> stop.set(done > 0)));
        assertFalse(result.complete());
        assertTrue(result.shownPixels() > 0 && result.shownPixels() < 3200);
        assertEquals(3200 - result.shownPixels(), black(result.image()));
    }

    @Test
    void aRenderThatIsCancelledInTheCoarsePassShowsNothing() {
        Looking looking = new Looking();
        RenderResult result = Renderer.render(RenderRequest.of(SMALL, QUICK)
                .withWatched(true)
                .withCancelled(() -> true)
                .withProgress(looking));
        assertEquals(0, result.shownPixels());
        assertEquals(List.of(), looking.heard);
    }

    @Test
    void aPictureWithAnErrorIsWholeInEveryRound() {
        Looking looking = new Looking();
        RenderSettings settings = QUICK.withBudget(RenderSettings.Budget.NONE.withError(0.01));
        RenderResult result = Renderer.render(
                RenderRequest.of(SMALL, settings).withWatched(true).withProgress(looking));
        assertTrue(result.report().isErrorMet());
        for (Image picture : looking.pictures) {
            assertEquals(0, black(picture));
        }
    }
}
