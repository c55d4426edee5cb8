package enlightenment.status;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(600)
class WatchedRenderTest {
    private static final long SECOND = 1_000_000_000L;

    private final AtomicLong clock = new AtomicLong();
    private final WatchedRender watched = new WatchedRender("a scene", image -> image, clock::get);
    private final RenderProgress progress = watched.listening(RenderProgress.NONE);
    private final AtomicInteger copies = new AtomicInteger();

    private Image copied() {
        copies.incrementAndGet();
        return new Image(1, 1, new float[3]);
    }

    @Test
    void whatTheDisplayHearsItHearsAllTheSame() {
        List<String> heard = new ArrayList<>();
        RenderProgress display = new RenderProgress() {
            @Override
            public void progress(long done, long total, Supplier<Image> soFar) {
                heard.add(done + " of " + total);
            }

            @Override
            public void planned(double samples, String decidedBy) {
                heard.add(samples + " by " + decidedBy);
            }

            @Override
            public void note(String text) {
                heard.add(text);
            }
        };
        RenderProgress listening = watched.listening(display);
        listening.planned(4, "time");
        listening.note("a note");
        listening.progress(1, 2, this::copied);
        assertEquals(List.of("4.0 by time", "a note", "1 of 2"), heard);
    }

    @Test
    void itTellsHowFarTheRenderIs() {
        assertEquals(State.PREPARING, watched.status().state());
        assertEquals(0, watched.status().percent());
        assertEquals(0, watched.status().picture());
        clock.addAndGet(SECOND);
        progress.note("a note");
        progress.planned(4, "samples");
        progress.progress(1_000, 100_000, this::copied);
        clock.addAndGet(4 * SECOND);
        progress.progress(51_000, 100_000, this::copied);
        Status status = watched.status();
        assertEquals("a scene", status.title());
        assertEquals(State.RENDERING, status.state());
        assertEquals(51, status.percent());
        assertEquals("pixels", status.unit());
        assertEquals(5, status.elapsedSeconds(), 1e-9);
        // 50,000 pixels in four seconds, 49,000 to go.
        assertEquals(3.92, status.remainingSeconds().getAsDouble(), 1e-9);
        assertEquals(List.of(new Status.Note(1, "a note")), status.notes());
        assertEquals(4.0, status.statistics().get("samplesPerPixel"));
        assertEquals("samples", status.statistics().get("decidedBy"));
        assertEquals(204_000.0, status.statistics().get("samples"));
        watched.title("frame 2");
        assertEquals("frame 2", watched.status().title());
    }

    @Test
    void aCoarsePictureIsThereWhileTheRenderIsPrepared() {
        List<String> heard = new ArrayList<>();
        RenderProgress listening = watched.listening(new RenderProgress() {
            @Override
            public void progress(long done, long total, Supplier<Image> soFar) {}

            @Override
            public void coarse(Supplier<Image> soFar) {
                heard.add("coarse");
            }
        });
        listening.coarse(this::copied);
        assertEquals(List.of("coarse"), heard);
        assertEquals(State.PREPARING, watched.status().state());
        assertEquals(1, watched.status().picture());
        assertTrue(watched.image().isPresent());
        clock.addAndGet(SECOND);
        listening.progress(0, 2, this::copied);
        assertEquals(2, copies.get());
    }

    @Test
    void theEndIsToldAndTheClockStopsThere() {
        progress.progress(1, 2, this::copied);
        assertFalse(watched.isWhole());
        clock.addAndGet(3 * SECOND);
        watched.ended(false);
        clock.addAndGet(SECOND);
        assertEquals(State.STOPPED, watched.status().state());
        assertEquals(3, watched.status().elapsedSeconds(), 1e-9);
        assertEquals(0, watched.status().remainingSeconds().getAsDouble());
        progress.progress(2, 2, this::copied);
        assertTrue(watched.isWhole());
        watched.ended(true);
        assertEquals(State.FINISHED, watched.state());
    }

    @Test
    void thePictureIsCopiedOnlyForThoseWhoLookAndAFewTimesASecond() {
        progress.progress(1, 1_000, this::copied);
        assertEquals(1, copies.get(), "the first, so that there is one");
        for (int i = 2; i < 100; i++) {
            clock.addAndGet(SECOND);
            progress.progress(i, 1_000, this::copied);
        }
        assertEquals(1, copies.get(), "nobody looks");
        for (int i = 100; i < 200; i++) {
            clock.addAndGet(WatchedRender.PERIOD_NANOS / 10);
            watched.status();
            progress.progress(i, 1_000, this::copied);
        }
        assertEquals(11, copies.get());
    }

    @Test
    void whereCopyingTakesLongItIsDoneSeldom() {
        long took = SECOND;
        for (int i = 0; i < 1_000; i++) {
            watched.status();
            progress.progress(i, 1_000, () -> {
                clock.addAndGet(took);
                return copied();
            });
            clock.addAndGet(SECOND);
        }
        double share = copies.get() * (double) took / clock.get();
        assertTrue(
                share <= 1.1 * WatchedRender.SHARE && copies.get() > 10, copies.get() + " copies, a share of " + share);
    }

    @Test
    void whereThereIsNoMemoryForACopyTheRenderGoesOnUnseen() {
        progress.progress(1, 3, () -> {
            throw new OutOfMemoryError("none for this");
        });
        progress.progress(2, 3, this::copied);
        assertEquals(0, copies.get());
        assertEquals(66, watched.status().percent());
    }

    @Test
    void theLastPictureIsAlwaysTaken() {
        progress.progress(1, 2, this::copied);
        progress.progress(2, 2, this::copied);
        assertEquals(2, copies.get());
    }

    @Test
    void picturesAreShownAsTheFileWillHaveThemAndMadeOnce() {
        AtomicInteger views = new AtomicInteger();
        Image shown = new Image(2, 2, new float[12]);
        WatchedRender other = new WatchedRender(
                "",
                image -> {
                    views.incrementAndGet();
                    return shown;
                },
                clock::get);
        assertEquals(Optional.empty(), other.image());
        other.listening(RenderProgress.NONE).progress(1, 2, this::copied);
        assertEquals(0, views.get(), "nothing is done by the threads that render");
        assertSame(shown, other.image().orElseThrow());
        assertSame(shown, other.image().orElseThrow());
        assertEquals(1, views.get());
    }

    @Test
    void whoeverAsksAfterALongTimeWaitsForANewPicture() throws Exception {
        Image next = new Image(2, 2, new float[12]);
        WatchedRender patient = new WatchedRender("", image -> image, clock::get, 500_000);
        RenderProgress heard = patient.listening(RenderProgress.NONE);
        heard.progress(1, 10, this::copied);
        clock.addAndGet(WatchedRender.STALE_NANOS);
        Thread rendering = new Thread(() -> {
            // Until somebody has asked.
            while (!isWaited()) {
                Thread.onSpinWait();
            }
            heard.progress(2, 10, () -> next);
        });
        asking = Thread.currentThread();
        rendering.start();
        assertSame(next, patient.image().orElseThrow());
        rendering.join();
    }

    private volatile Thread asking;

    private boolean isWaited() {
        return asking.getState() == Thread.State.TIMED_WAITING;
    }
}
