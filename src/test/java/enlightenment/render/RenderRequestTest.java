package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ClassicMethods;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RenderRequestTest {
    private static final Set<RenderResult.Auxiliary> ALL =
            EnumSet.range(RenderResult.Auxiliary.ERROR, RenderResult.Auxiliary.OBJECT);
    private static final Scene SMALL = TestScenes.whiteFireAndIce()
            .size(80, 40)
            .shading(new Shading.Classic(0.1, 0.5, new DisplayRgb(0.5, 0.5, 0.5), 10))
            .build();
    private static final RenderSettings QUICK = RenderSettings.of(SMALL)
            .withAntialias(4)
            .with(new BuiltInMethod.RayTraceSettings(4))
            .withThreads(2);

    /** A ball of radius 1 straight ahead, 5 before the eye, a wall beside it, a light beyond, and nothing elsewhere. */
    private static Scene ballAndLight() {
        return Scene.builder()
                .size(41, 21)
                .camera(new Camera.Perspective(ExactPoint.of(10, 20, 30), ExactPoint.of(10, 20, 35), Vec3.Y, 40))
                .object(Sphere.of(ExactPoint.of(1000, 0, 0), 1), TestScenes.matte(1, 1, 1))
                .object(Sphere.of(ExactPoint.of(10, 20, 35), 1), TestScenes.matte(1, 1, 1))
                .light(new Light.Sphere(ExactPoint.of(13, 20, 40), 0.5, DisplayRgb.WHITE))
                .build();
    }

    @Test
    void aRayThroughThePixelsMiddleTellsWhatItMeets() {
        Scene scene = ballAndLight();
        RenderResult result =
                Renderer.render(RenderRequest.of(scene, RenderSettings.of(scene).withAntialias(1))
                        .withAuxiliary(ALL));
        // The picture's middle is the middle of a pixel: there the ball is met after 5 - 1.
        assertEquals(4, result.auxiliary().get(RenderResult.Auxiliary.DEPTH).component(20, 10, 0));
        Image normal = result.auxiliary().get(RenderResult.Auxiliary.NORMAL);
        assertEquals(0, normal.component(20, 10, 0), 1e-15);
        assertEquals(0, normal.component(20, 10, 1), 1e-15);
        assertEquals(-1, normal.component(20, 10, 2));
        Image position = result.auxiliary().get(RenderResult.Auxiliary.POSITION);
        assertArrayEquals(new float[] {10, 20, 34}, pixel(position, 20, 10), 1e-6f);
        assertArrayEquals(new float[3], pixel(position, 0, 0));
        Image object = result.auxiliary().get(RenderResult.Auxiliary.OBJECT);
        assertEquals(1, object.component(20, 10, 0));
        // In the corner there is nothing.
        assertEquals(
                Float.POSITIVE_INFINITY,
                result.auxiliary().get(RenderResult.Auxiliary.DEPTH).component(0, 0, 1));
        assertEquals(-1, object.component(0, 0, 2));
        assertEquals(0, normal.component(0, 0, 2));
        // The light stands at x/z = 0.3; the picture is 2 tan 20 degrees high for 21 pixels. It counts as object 2.
        int column = (int) (20.5 + 0.3 / (2 * Math.tan(Math.toRadians(20))) * 21);
        assertEquals(2, object.component(column, 10, 0));
        float depth = result.auxiliary().get(RenderResult.Auxiliary.DEPTH).component(column, 10, 0);
        assertEquals(Math.sqrt(109) - 0.5, depth, 0.1);
    }

    private static float[] pixel(Image image, int x, int y) {
        return new float[] {image.component(x, y, 0), image.component(x, y, 1), image.component(x, y, 2)};
    }

    /** The position is where the depth is, on the ray from the eye: for a sphere, on the sphere. */
    @Test
    void positionsLieOnWhatIsSeen() {
        RenderResult result = Renderer.render(RenderRequest.of(ballAndLight(), RenderSettings.of(ballAndLight()))
                .withAuxiliary(
                        RenderResult.Auxiliary.POSITION, RenderResult.Auxiliary.DEPTH, RenderResult.Auxiliary.OBJECT));
        int seen = 0;
        for (int y = 0; y < 21; y++) {
            for (int x = 0; x < 41; x++) {
                if (result.auxiliary().get(RenderResult.Auxiliary.OBJECT).component(x, y, 0) == 1) {
                    float[] p = pixel(result.auxiliary().get(RenderResult.Auxiliary.POSITION), x, y);
                    float depth =
                            result.auxiliary().get(RenderResult.Auxiliary.DEPTH).component(x, y, 0);
                    assertEquals(1, distance(p, 10, 20, 35), 1e-5);
                    assertEquals(depth, distance(p, 10, 20, 30), 1e-5);
                    seen++;
                }
            }
        }
        assertTrue(seen > 50);
    }

    private static double distance(float[] p, double x, double y, double z) {
        return Math.sqrt((p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y) + (p[2] - z) * (p[2] - z));
    }

    @Test
    void insideABallTheNormalFacesTheViewer() {
        Scene scene = Scene.builder()
                .size(3, 3)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0, 1), Vec3.Y, 20))
                .object(Sphere.of(ExactPoint.of(0, 0, 0), 7), TestScenes.matte(1, 1, 1))
                .build();
        RenderResult result = Renderer.render(
                RenderRequest.of(scene, RenderSettings.of(scene)).withAuxiliary(ALL));
        assertEquals(-1, result.auxiliary().get(RenderResult.Auxiliary.NORMAL).component(1, 1, 2));
        for (int x = 0; x < 3; x++) {
            // Along each ray the same: it is no depth along the axis.
            assertEquals(7, result.auxiliary().get(RenderResult.Auxiliary.DEPTH).component(x, 0, 0), 1e-6);
        }
    }

    @ParameterizedTest
    @ClassicMethods
    void countsAndErrorsAgreeWithTheReport(Method method) {
        RenderSettings settings = QUICK.withMethod(method).withBudget(RenderSettings.Budget.NONE.withSamples(12));
        RenderResult result = Renderer.render(RenderRequest.of(SMALL, settings)
                .withAuxiliary(Set.of(RenderResult.Auxiliary.ERROR, RenderResult.Auxiliary.SAMPLES)));
        assertEquals(
                Set.of(RenderResult.Auxiliary.ERROR, RenderResult.Auxiliary.SAMPLES),
                result.auxiliary().keySet());
        Image counts = result.auxiliary().get(RenderResult.Auxiliary.SAMPLES);
        Image errors = result.auxiliary().get(RenderResult.Auxiliary.ERROR);
        double sum = 0;
        double squares = 0;
        for (int y = 0; y < 40; y++) {
            for (int x = 0; x < 80; x++) {
                assertTrue(counts.component(x, y, 0) >= 1);
                sum += counts.component(x, y, 0);
                squares += errors.component(x, y, 1) * errors.component(x, y, 1);
            }
        }
        double perPixel = sum / 3200;
        // The survey of the clusters asks for rays that are no samples of pixels.
        assertTrue(perPixel <= result.report().sampling().samplesPerPixel() + 1e-9);
        // Of chains, which belong to no single pixel, as much again as of the pixels' own samples.
        double least = method == Method.named("metropolis") ? 0.25 : 0.5;
        assertTrue(perPixel > least * result.report().sampling().samplesPerPixel());
        // Smoothing keeps the mean square but for the border, whose pixels count for less.
        double rmse = result.report().sampling().estimatedError();
        assertEquals(1, Math.sqrt(squares / 3200) / rmse, 0.05);
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE,4", "RAYTRACE,1", "CLUSTER,2", "CLUSTER,4"})
    void thePassesDoNotChangeABit(BuiltInMethod method, int antialias) {
        RenderSettings settings =
                QUICK.withMethod(method).withAntialias(antialias).with(new BuiltInMethod.RayTraceSettings(1));
        RenderResult plain = Renderer.render(RenderRequest.of(SMALL, settings));
        RenderResult passes = Renderer.render(
                RenderRequest.of(SMALL, settings).withProgressive(true).withAuxiliary(ALL));
        assertArrayEquals(plain.image().toArray(), passes.image().toArray());
        assertEquals(plain.report().raysByKind(), passes.report().raysByKind());
        assertEquals(plain.report().sampling(), passes.report().sampling());
        assertTrue(passes.report().phases().stream().anyMatch(p -> p.name().equals("preview")));
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"RAYTRACE,16", "CLUSTER,8"})
    void norDoThePassesWithManySamples(BuiltInMethod method, int antialias) {
        thePassesDoNotChangeABit(method, antialias);
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE,4", "RAYTRACE,1", "CLUSTER,4"})
    void everyPictureOfAProgressiveRenderIsWholeAndTheLastIsBetterThanTheFirst(BuiltInMethod method, int antialias) {
        RenderSettings settings =
                QUICK.withMethod(method).withAntialias(antialias).withCrop(new RenderSettings.Crop(3, 5, 61, 30));
        List<Image> seen = new ArrayList<>();
        RenderResult result = Renderer.render(
                RenderRequest.of(SMALL, settings).withProgressive(true).withProgress((done, total, soFar) -> {
                    assertEquals(61 * 30, total);
                    if (seen.isEmpty() || done == 0 || done > total / 2) {
                        seen.add(soFar.get());
                    }
                }));
        assertTrue(seen.size() > 10);
        for (Image image : seen) {
            for (int k = 0; k < 61 * 30; k++) {
                // Everything in this scene is lit, at least by ambient light, and beyond it there is grey.
                assertTrue(image.component(k % 61, k / 61, 0) > 0);
            }
        }
        double first = distance(seen.get(0), result.image());
        double middle = distance(seen.get(seen.size() / 2), result.image());
        assertTrue(first > 0 && middle < first, first + " " + middle);
        assertEquals(0, distance(seen.get(seen.size() - 1), result.image()));
    }

    @Test
    @Tag("full")
    void everyPictureOfALongProgressiveRenderIsWholeToo() {
        everyPictureOfAProgressiveRenderIsWholeAndTheLastIsBetterThanTheFirst(BuiltInMethod.CLUSTER, 12);
    }

    private static double distance(Image a, Image b) {
        double sum = 0;
        float[] p = a.toArray();
        float[] q = b.toArray();
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (p[i] - q[i]);
        }
        return Math.sqrt(sum / p.length);
    }

    @Test
    void whatIsCancelledAfterTheFirstPassIsStillAWholePicture() {
        AtomicBoolean stop = new AtomicBoolean();
        RenderResult result = Renderer.render(RenderRequest.of(SMALL, QUICK)
                .withProgressive(true)
                .withCancelled(stop::get)
                .withAuxiliary(ALL)
                .withProgress((done, total, soFar) -> stop.set(true)));
        assertFalse(result.complete());
        assertEquals(0, result.report().pixels());
        assertEquals(3200, result.shownPixels());
        assertTrue(result.image().component(40, 20, 0) > 0);
        assertEquals(0, result.auxiliary().get(RenderResult.Auxiliary.SAMPLES).component(40, 20, 0));
        assertEquals(
                Float.POSITIVE_INFINITY,
                result.auxiliary().get(RenderResult.Auxiliary.ERROR).component(40, 20, 0));
    }

    @ParameterizedTest
    @ClassicMethods
    void aTimeBecomesANumberOfSamplesThatMakesTheSamePicture(Method method) {
        RenderSettings settings = QUICK.withMethod(method).with(new BuiltInMethod.RayTraceSettings(1));
        AtomicReference<String> told = new AtomicReference<>();
        RenderResult timed = Renderer.render(
                RenderRequest.of(SMALL, settings.withBudget(RenderSettings.Budget.NONE.withSeconds(0.5)))
                        .withProgress(new RenderProgress() {
                            @Override
                            public void progress(long done, long total, java.util.function.Supplier<Image> soFar) {}

                            @Override
                            public void planned(double samples, String decidedBy) {
                                assertEquals(null, told.getAndSet(samples + " " + decidedBy));
                            }
                        }));
        double samples = timed.report().sampling().plannedSamples();
        assertEquals(samples + " time", told.get());
        // Three digits, give or take what a decimal fraction is in binary.
        double scaled = samples * Math.pow(10, 2 - Math.floor(Math.log10(samples)));
        assertEquals(Math.rint(scaled), scaled, 1e-6);
        RenderResult again = Renderer.render(
                RenderRequest.of(SMALL, settings.withBudget(RenderSettings.Budget.NONE.withSamples(samples))));
        assertArrayEquals(again.image().toArray(), timed.image().toArray());
        // Work, not time by the clock, which depends on what else the machine does: docs/notes/benchmarks.md measures
        // that. The
        // just-in-time compiler works, too.
        double work = timed.report().phases().stream()
                .mapToDouble(RenderReport.Phase::cpuSeconds)
                .sum();
        assertTrue(work < 0.5 * (settings.threads() + 4), work + " s of work");
    }

    /** A 64th of these samples would take an hour. */
    @ParameterizedTest
    @Timeout(600)
    @ClassicMethods
    void theFirstPassCostsTheSameWhateverIsAskedFor(Method method) {
        AtomicBoolean stop = new AtomicBoolean();
        RenderSettings settings = QUICK.withMethod(method)
                .withBudget(RenderSettings.Budget.NONE.withSamples(RenderSettings.Budget.MAX_SAMPLES));
        RenderResult result = Renderer.render(RenderRequest.of(SMALL, settings)
                .withProgressive(true)
                .withCancelled(stop::get)
                .withProgress((done, total, soFar) -> stop.set(true)));
        assertEquals(3200, result.shownPixels());
        assertEquals(0, result.report().pixels());
    }

    @Test
    void anErrorThatWasAskedForIsMetOrSaidNotToBe() {
        RenderSettings settings = QUICK.withMethod(Method.CLUSTER);
        RenderReport met = Renderer.render(
                        RenderRequest.of(SMALL, settings.withBudget(RenderSettings.Budget.NONE.withError(0.05))))
                .report();
        assertTrue(met.isErrorMet(), met.sampling().toString());
        RenderReport few = Renderer.render(RenderRequest.of(
                        SMALL,
                        settings.withBudget(
                                RenderSettings.Budget.NONE.withError(0.001).withSamples(3))))
                .report();
        assertFalse(few.isErrorMet());
        assertEquals("samples", few.sampling().decidedBy());
        assertTrue(Renderer.render(RenderRequest.of(SMALL, settings)).report().isErrorMet());
    }
}
