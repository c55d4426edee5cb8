package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is planned while a render is cancelled is neither kept nor rendered: going on makes the picture of a render that never stopped. */
@Timeout(600)
class CancelledPlanTest {
    private static final Scene FIRE = TestScenes.whiteFireAndIce().build();
    private static final Scene LAMP = SceneReader.read(Path.of("scenes/lamp-room.json"));

    private final MemoryArchive archive = new MemoryArchive();
    private final List<Double> planned = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();

    /** What is done when something is noted. */
    private Runnable whenNoted = () -> {};

    /** What is done when a round has all of its pixels. */
    private Runnable whenDone = () -> {};

    /** A scene and its method; there is no other thread, so that each render asks in the same order whether to stop. */
    record Kind(String name, Scene scene, Method method) {
        RenderSettings settings(RenderSettings.Budget budget) {
            return RenderSettings.of(scene)
                    .withMethod(method)
                    .withSize(24, 16)
                    .with(new BuiltInMethod.RayTraceSettings(1))
                    .withThreads(1)
                    .withBudget(budget);
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

    private RenderResult render(Kind kind, RenderSettings.Budget budget, BooleanSupplier cancelled) {
        RenderProgress listener = new RenderProgress() {
            @Override
            public void progress(long done, long total, Supplier<Image> soFar) {
                if (done == total) {
                    whenDone.run();
                }
            }

            @Override
            public void planned(double samples, String decidedBy) {
                planned.add(samples);
            }

            @Override
            public void note(String text) {
                notes.add(text);
                whenNoted.run();
            }
        };
        return Renderer.render(RenderRequest.of(kind.scene, kind.settings(budget))
                .withProgress(listener)
                .withCancelled(cancelled)
                .withArchives(List.of(archive)));
    }

    private void forget() {
        archive.plans.clear();
        archive.results.clear();
        planned.clear();
        notes.clear();
    }

    private static void assertSame(RenderResult expected, RenderResult actual) {
        assertTrue(actual.complete());
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().sampling(), actual.report().sampling());
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void whereverPlanningIsStoppedThePictureIsThatOfOneGo(Kind kind) {
        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withSamples(12);
        RenderResult expected = render(kind, budget, () -> false);
        byte[] plan = archive.plans.get(0);
        boolean isPlanned = false;
        for (int patience = 1; !isPlanned; patience += 1 + patience / 4) {
            forget();
            AtomicInteger asked = new AtomicInteger();
            int most = patience;
            RenderResult stopped = render(kind, budget, () -> asked.incrementAndGet() >= most);
            assertFalse(stopped.complete());
            isPlanned = !archive.plans.isEmpty();
            if (isPlanned) {
                assertArrayEquals(plan, archive.plans.get(0), "stopped after " + patience);
            } else {
                assertEquals(0, stopped.shownPixels());
                assertEquals(List.of(), planned, "no number of samples is told that is none");
            }
            if (patience == 1 || isPlanned) {
                assertSame(expected, render(kind, budget, () -> false));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aTimeThatWasNotTriedOutIsNotPlannedFor(Kind kind) {
        // Less than what the most samples take, or trials would end at once.
        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withSeconds(1000);
        for (int patience : new int[] {1, 2, 5, 30, 200}) {
            AtomicInteger asked = new AtomicInteger();
            RenderResult stopped = render(kind, budget, () -> asked.incrementAndGet() >= patience);
            assertFalse(stopped.complete());
            assertEquals(0, stopped.shownPixels());
            assertEquals(List.of(), archive.plans);
            assertEquals(List.of(), planned);
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aFurtherRoundThatIsStoppedWhileItIsPlannedLeavesTheRoundBefore(Kind kind) {
        RenderSettings.Budget budget =
                RenderSettings.Budget.NONE.withError(0.02).withSamples(200);
        RenderResult expected = render(kind, budget, () -> false);
        List<byte[]> plans = List.copyOf(archive.plans);
        assertTrue(plans.size() > 1, "a picture as small as this is its own first trial");
        forget();
        AtomicBoolean stop = new AtomicBoolean();
        whenNoted = () -> stop.set(stop.get() || notes.get(notes.size() - 1).contains(": once more with"));
        RenderResult first = render(kind, budget, stop::get);
        assertTrue(first.complete());
        assertTrue(stop.get());
        assertEquals(1, first.report().sampling().rounds());
        assertEquals(1, archive.plans.size());
        assertEquals(1, planned.size());
        assertTrue(notes.get(notes.size() - 1).startsWith("stopped: the picture is that of the round before"));
        whenNoted = () -> {};
        assertSame(expected, render(kind, budget, () -> false));
        assertEquals(plans.size(), archive.plans.size());
    }

    @Test
    void aRenderThatIsStoppedBetweenRoundsSaysThatItWas() {
        Kind kind = new Kind("fire and ice", FIRE, Method.RAYTRACE);
        AtomicBoolean stop = new AtomicBoolean();
        whenDone = () -> stop.set(true);
        RenderResult first =
                render(kind, RenderSettings.Budget.NONE.withError(0.02).withSamples(200), stop::get);
        assertTrue(first.complete());
        assertEquals(1, first.report().sampling().rounds());
        assertTrue(notes.get(notes.size() - 1).startsWith("stopped: the picture is that of the round before"));
    }

    @Test
    void whatIsKeptIsShownThoughItIsStoppedAtOnce() {
        Kind kind = new Kind("fire and ice", FIRE, Method.RAYTRACE);
        RenderSettings.Budget budget = RenderSettings.Budget.NONE.withSamples(4);
        RenderResult whole = render(kind, budget, () -> false);
        RenderResult again = render(kind, budget, () -> true);
        assertTrue(again.complete());
        assertArrayEquals(whole.image().toArray(), again.image().toArray());
    }
}
