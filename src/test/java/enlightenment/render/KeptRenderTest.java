package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A render whose results are kept, is stopped and goes on, against one that never was. */
class KeptRenderTest {
    private static final Scene FIRE = TestScenes.whiteFireAndIce().build();
    private static final Scene LAMP = SceneReader.read(Path.of("scenes/lamp-room.json"));
    private static final Scene CAUSTICS = SceneReader.read(Path.of("scenes/caustics.json"));

    private MemoryArchive archive = new MemoryArchive();
    private final List<String> notes = new ArrayList<>();

    /** A scene and a method. */
    record Kind(String name, Scene scene, Method method) {
        RenderSettings settings(double samples) {
            RenderSettings settings = RenderSettings.of(scene)
                    .withMethod(method)
                    .withSize(scene == FIRE ? 40 : 24, scene == FIRE ? 24 : 16)
                    .withThreads(2)
                    .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
            return scene == FIRE ? settings.with(new BuiltInMethod.RayTraceSettings(2)) : settings;
        }

        @Override
        public String toString() {
            return method.word() + " " + name;
        }
    }

    static Stream<Kind> kinds() {
        return Stream.concat(
                BuiltInMethod.rendering(Shading.Model.CLASSIC).stream().map(m -> new Kind("fire and ice", FIRE, m)),
                BuiltInMethod.rendering(Shading.Model.PHYSICAL).stream().map(m -> new Kind("lamp room", LAMP, m)));
    }

    private static Kind fire(Method method) {
        return new Kind("fire and ice", FIRE, method);
    }

    private RenderResult render(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        notes.clear();
        RenderProgress listener = new RenderProgress() {
            @Override
            public void progress(long done, long total, java.util.function.Supplier<Image> soFar) {}

            @Override
            public void note(String text) {
                notes.add(text);
            }
        };
        return Renderer.render(RenderRequest.of(scene, settings)
                .withProgress(listener)
                .withCancelled(cancelled)
                .withArchives(List.of(archive)));
    }

    private RenderResult render(Kind kind, double samples) {
        return render(kind.scene, kind.settings(samples), () -> false);
    }

    private static RenderResult alone(Kind kind, double samples) {
        return Renderer.render(RenderRequest.of(kind.scene, kind.settings(samples)));
    }

    private static void assertSame(RenderResult expected, RenderResult actual) {
        assertTrue(actual.complete());
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().sampling(), actual.report().sampling());
        assertEquals(expected.report().raysByKind(), actual.report().raysByKind());
        assertEquals(expected.report().pixels(), actual.report().pixels());
        assertEquals(expected.shownPixels(), actual.shownPixels());
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void howeverOftenItIsStoppedThePictureIsThatOfOneGo(Kind kind) {
        RenderResult expected = alone(kind, 9);
        int before = -1;
        while (archive.given > before) {
            before = archive.given;
            int more = before + 1 + before / 2;
            RenderResult part = render(kind.scene, kind.settings(9), () -> archive.given >= more);
            if (part.complete()) {
                assertSame(expected, part);
            }
        }
        assertSame(expected, render(kind, 9));
        assertEquals(before, archive.given, "nothing was left to do");
        assertEquals(before, archive.results.get(0).size(), "nothing was done twice");
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void moreSamplesGiveThePictureOfAskingForThemAtOnce(Kind kind) {
        for (double samples : kind.scene == FIRE ? new double[] {4, 9.3, 20.5} : new double[] {5, 11.5}) {
            assertSame(alone(kind, samples), render(kind, samples));
        }
    }

    @Test
    @Tag("full")
    void moreSamplesGiveThePictureOfAskingForThemAtOnceWhateverTheNumbers() {
        List<Kind> all = new ArrayList<>(kinds().toList());
        BuiltInMethod.rendering(Shading.Model.PHYSICAL).forEach(m -> all.add(new Kind("caustics", CAUSTICS, m)));
        for (Kind kind : all) {
            archive.plans.clear();
            archive.results.clear();
            for (double samples : new double[] {1, 1.4, 2, 3, 5.6, 8, 16, 48, 64, 100}) {
                assertSame(alone(kind, samples), render(kind, samples));
            }
        }
    }

    @Test
    void moreSamplesOfAPartOfThePictureGiveThatPart() {
        RenderSettings.Crop crop = new RenderSettings.Crop(5, 3, 21, 17);
        for (double samples : new double[] {16, 48, 64}) {
            RenderSettings settings = fire(Method.RAYTRACE).settings(samples).withCrop(crop);
            RenderResult expected = Renderer.render(RenderRequest.of(FIRE, settings));
            assertSame(expected, render(FIRE, settings, () -> false));
        }
    }

    @Test
    void aSquareOfPositionsGrowsToAnotherNumberOfSamples() {
        Kind kind = fire(Method.RAYTRACE);
        RenderSettings three =
                kind.settings(1).withBudget(RenderSettings.Budget.NONE).withAntialias(3);
        assertSame(Renderer.render(RenderRequest.of(FIRE, three)), render(FIRE, three, () -> false));
        assertSame(alone(kind, 64), render(kind, 64));
        assertTrue(archive.found > 0, "64 samples begin with those nine");
    }

    /** The light of the first samples is taken over, not looked for again: so a lie about it stays. */
    @Test
    void whatIsKeptOfASmallerNumberIsNotRenderedAgain() {
        Kind kind = fire(Method.RAYTRACE);
        render(kind, 8);
        for (byte[] result : archive.results.get(0).values()) {
            long cameraRays = ByteBuffer.wrap(result).getLong(Long.BYTES);
            ByteBuffer.wrap(result).putLong(Long.BYTES, cameraRays + 1_000_000);
        }
        long units = archive.results.get(0).size();
        double more = render(kind, 32).report().raysByKind().values().stream()
                .mapToDouble(Long::doubleValue)
                .sum();
        double rays = alone(kind, 32).report().raysByKind().values().stream()
                .mapToDouble(Long::doubleValue)
                .sum();
        assertEquals(rays + 1e6 * units, more);
        assertTrue(notes.stream().anyMatch(n -> n.contains("go on from 8")), notes.toString());
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void whetherMoreSamplesGoOnFromThoseThatAreKeptIsTold(Kind kind) {
        render(kind, 4);
        render(kind, 16);
        boolean anew = List.of("cluster", "bidirectional-cluster", "metropolis").contains(kind.method.word());
        String said = anew
                ? "what is kept has 4 samples per pixel: " + kind.method.word()
                        + " takes others where there are more, so all are taken anew"
                : "tiles go on from 4 samples per pixel where they are kept";
        assertEquals(1, notes.stream().filter(n -> n.startsWith(said)).count(), notes.toString());
        render(kind, 2);
        assertTrue(notes.stream().noneMatch(n -> n.contains("4 samples per pixel")), "there are none with fewer");
    }

    @Test
    void aResultThatMakesNoSenseIsRenderedAgain() {
        Kind kind = fire(Method.RAYTRACE);
        RenderResult expected = alone(kind, 4);
        render(kind, 4);
        byte[] nan = archive.results.get(0).get(3);
        ByteBuffer.wrap(nan).putDouble(nan.length - 8, Double.NaN);
        archive.results.get(0).put(7, new byte[5]);
        archive.results.get(0).put(100_000, archive.results.get(0).get(1));
        int given = archive.given;
        assertSame(expected, render(kind, 4));
        assertEquals(given + 2, archive.given);
        assertTrue(notes.stream().anyMatch(n -> n.contains("3 results make no sense")), notes.toString());
    }

    @Test
    void aResultOfASmallerNumberThatMakesNoSenseIsNotGoneOnFrom() {
        Kind kind = fire(Method.RAYTRACE);
        render(kind, 4);
        for (byte[] result : archive.results.get(0).values()) {
            // The first sum of the last pixel is not its mean times its samples.
            ByteBuffer.wrap(result).putDouble(result.length - 12 * 8, 0.123);
        }
        assertSame(alone(kind, 16), render(kind, 16));
    }

    @Test
    void aResultThatCountsAsMuchAsItMayIsNotGoneOnFrom() {
        Kind kind = fire(Method.RAYTRACE);
        render(kind, 4);
        long most = (1L << 62) / archive.results.get(0).size();
        for (byte[] result : archive.results.get(0).values()) {
            ByteBuffer.wrap(result).putLong(Long.BYTES, most);
        }
        assertSame(alone(kind, 16), render(kind, 16));
    }

    @Test
    void aFullDiskCostsWhatIsKeptAndNotThePicture() {
        Kind kind = fire(Method.RAYTRACE);
        for (String named : List.of("", "memory: ")) {
            archive = new MemoryArchive();
            archive.room = 4;
            archive.full = named + "No space left on device";
            assertSame(alone(kind, 4), render(kind, 4));
            assertEquals(
                    List.of("memory: No space left on device; it is not used any more, the render goes on without"),
                    notes);
            assertEquals(4, archive.given);
        }
    }

    @Test
    void anArchiveGetsWhatAnotherHas() {
        Kind kind = fire(Method.RAYTRACE);
        render(kind.scene, kind.settings(4), () -> archive.given >= 5);
        MemoryArchive second = new MemoryArchive();
        RenderResult result =
                Renderer.render(RenderRequest.of(FIRE, kind.settings(4)).withArchives(List.of(archive, second)));
        assertSame(alone(kind, 4), result);
        assertEquals(archive.results.get(0).keySet(), second.results.get(0).keySet());
    }

    @Test
    void anArchiveThatCannotBeReadCostsItselfAndNotTheOneThatIsToHaveWhatItHas() {
        Kind kind = fire(Method.RAYTRACE);
        render(kind.scene, kind.settings(4), () -> archive.given >= 5);
        int before = archive.given;
        archive.isUnreadable = true;
        for (boolean isFirst : new boolean[] {true, false}) {
            MemoryArchive second = new MemoryArchive();
            List<RenderResult.Archive> both = isFirst ? List.of(archive, second) : List.of(second, archive);
            RenderResult result =
                    Renderer.render(RenderRequest.of(FIRE, kind.settings(4)).withArchives(both));
            assertSame(alone(kind, 4), result);
            assertEquals(before, archive.given);
            assertTrue(second.given > 0);
        }
    }

    @Test
    void roundsOfAnErrorGoOnFromEachOtherAndFromWhatIsKept() {
        RenderSettings settings = fire(Method.RAYTRACE)
                .settings(1)
                .withBudget(RenderSettings.Budget.NONE.withError(0.012).withDepth(8));
        RenderResult expected = Renderer.render(RenderRequest.of(FIRE, settings));
        for (int stop = 3; stop < 200; stop *= 4) {
            int most = stop;
            render(FIRE, settings, () -> archive.given >= most);
        }
        RenderResult result = render(FIRE, settings, () -> false);
        assertSame(expected, result);
        assertEquals(result.report().sampling().rounds(), archive.plans.size());
    }

    @Test
    void aTimeIsPlannedOnce() {
        RenderSettings settings =
                fire(Method.RAYTRACE).settings(1).withBudget(RenderSettings.Budget.NONE.withSeconds(0.3));
        RenderResult first = render(FIRE, settings, () -> archive.given >= 3);
        RenderResult second = render(FIRE, settings, () -> false);
        double samples = second.report().sampling().plannedSamples();
        assertEquals(first.report().sampling().plannedSamples(), samples);
        assertTrue(second.complete());
        assertEquals(1, archive.plans.size());
        RenderSettings same = settings.withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        assertArrayEquals(Renderer.render(FIRE, same).toArray(), second.image().toArray());
    }

    @Test
    void aStoppedRenderShowsItsPreviewWhereNothingIsFinished() {
        RenderSettings settings = fire(Method.RAYTRACE).settings(16);
        RenderResult part = Renderer.render(RenderRequest.of(FIRE, settings)
                .withProgressive(true)
                .withCancelled(() -> archive.given >= 5)
                .withArchives(List.of(archive)));
        assertFalse(part.complete());
        assertEquals(40 * 24, part.shownPixels());
        Image whole = alone(fire(Method.RAYTRACE), 16).image();
        int right = 0;
        int black = 0;
        for (int i = 0; i < 40 * 24; i++) {
            right += whole.component(i % 40, i / 40, 0) == part.image().component(i % 40, i / 40, 0) ? 1 : 0;
            black += part.image().component(i % 40, i / 40, 0) == 0 ? 1 : 0;
        }
        assertTrue(right >= 5 * 64 && right < 40 * 24, right + " pixels are finished");
        assertTrue(black < 40 * 24 / 2, black + " pixels are black");
    }

    @Test
    void furtherPicturesAreThoseOfOneGo() {
        RenderSettings settings = new Kind("lamp room", LAMP, Method.RAYTRACE).settings(8);
        RenderRequest request = RenderRequest.of(LAMP, settings).withAuxiliary(RenderResult.Auxiliary.values());
        RenderResult expected = Renderer.render(request);
        Renderer.render(request.withArchives(List.of(archive)).withCancelled(() -> archive.given >= 7));
        RenderResult result = Renderer.render(request.withArchives(List.of(archive)));
        for (RenderResult.Auxiliary kind : RenderResult.Auxiliary.values()) {
            assertArrayEquals(
                    expected.auxiliary().get(kind).toArray(),
                    result.auxiliary().get(kind).toArray(),
                    kind.word());
        }
    }

    @Test
    void whatIsKeptDoesNotTellOfClustersAndChains() {
        RenderRequest request = RenderRequest.of(FIRE).withArchives(List.of(archive));
        assertThrows(IllegalArgumentException.class, () -> request.withClusters(true));
        assertThrows(IllegalArgumentException.class, () -> request.withChains(true));
    }

    /** A file that is written by an interrupted thread closes itself, and whoever opened an archive closes it after the render. */
    @Test
    void thatTimeHasPassedIsToldWithoutInterruptAndNotBeyondTheEnd() {
        CountDownLatch ticking = new CountDownLatch(1);
        AtomicBoolean isTicking = new AtomicBoolean();
        AtomicBoolean wasInterrupted = new AtomicBoolean();
        archive.whenTicked = () -> {
            isTicking.set(true);
            ticking.countDown();
            try {
                Thread.sleep(300);
            } catch (InterruptedException e) {
                wasInterrupted.set(true);
            }
            isTicking.set(false);
        };
        Kind kind = fire(BuiltInMethod.RAYTRACE);
        RenderProgress listener = (done, total, soFar) -> {
            try {
                // Nothing is kept after this: the render ends while somebody is told of the time.
                if (done == total) {
                    ticking.await();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        };
        RenderResult result = Renderer.render(RenderRequest.of(kind.scene, kind.settings(2))
                .withProgress(listener)
                .withArchives(List.of(archive)));
        assertFalse(isTicking.get(), "after the end");
        assertFalse(wasInterrupted.get(), "an interrupt");
        assertSame(alone(kind, 2), result);
    }

    /** As a driver of a database may, which is not of this program. */
    @Test
    void anArchiveThatFailsInAnyWayDoesNotCostThePicture() {
        CountDownLatch ticked = new CountDownLatch(1);
        archive.whenTicked = () -> {
            ticked.countDown();
            throw new IllegalStateException("a driver's fault");
        };
        List<String> said = Collections.synchronizedList(new ArrayList<>());
        Kind kind = fire(BuiltInMethod.RAYTRACE);
        RenderProgress listener = new RenderProgress() {
            @Override
            public void progress(long done, long total, java.util.function.Supplier<Image> soFar) {
                try {
                    ticked.await();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }

            @Override
            public void note(String text) {
                said.add(text);
            }
        };
        RenderResult result = Renderer.render(RenderRequest.of(kind.scene, kind.settings(2))
                .withProgress(listener)
                .withArchives(List.of(archive)));
        assertSame(alone(kind, 2), result);
        assertEquals(
                List.of("memory: java.lang.IllegalStateException: a driver's fault; it is not used any more, the render"
                        + " goes on without"),
                said);
    }
}
