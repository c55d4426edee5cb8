package enlightenment.status;

import enlightenment.image.Image;
import enlightenment.machine.MachineFacts;
import enlightenment.picture.ReducedPicture;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.report.RenderReport;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * The status of a render of this process. Without watchers its cost is negligible: the picture is copied only after a request since the last copy, a
 * few times a second at most, and less often if it is large, so that copies take a small share of the time. All other work is done by the threads
 * that answer requests.
 */
public final class WatchedRender implements StatusSource {
    static final long PERIOD_NANOS = 250_000_000L;

    /** The largest share of one thread's time for copies. */
    static final double SHARE = 0.02;

    /** Age from which a request waits for a newer picture. */
    static final long STALE_NANOS = 1_000_000_000L;

    /** The longest wait of a request for a newer picture. */
    private static final long SOON_MILLIS = 500;

    private static final int MOST_NOTES = 100;
    private static final double NANO = 1e-9;

    private final UnaryOperator<Image> view;
    private final LongSupplier clock;
    private final long soonMillis;
    private final long started;
    private long ended;
    private final TimeLeft timeLeft = new TimeLeft();
    private final Map<String, Object> statistics = new LinkedHashMap<>();
    private final Deque<Status.Note> notes = new ArrayDeque<>();

    /** The last picture as it is displayed, shared by all requests. */
    private final AtomicReference<Shown> shown = new AtomicReference<>(new Shown(0, null));

    private volatile State state = State.PREPARING;
    private volatile boolean isWanted = true;

    /** Whether a copy of the picture did not fit into memory; no further copies are made then. */
    private volatile boolean isTooLarge;

    private String title;
    private long done;
    private long total;
    private double samples;
    private Image picture;
    private long number;
    private long taken;
    private long took = Long.MAX_VALUE;

    private record Shown(long number, Image image) {}

    /**
     * @param title the title of the render
     * @param view converts a picture into the displayed one
     * @param clock nanoseconds of any origin
     */
    public WatchedRender(String title, UnaryOperator<Image> view, LongSupplier clock) {
        this(title, view, clock, SOON_MILLIS);
    }

    /** @param soonMillis the longest wait of a request for a newer picture */
    WatchedRender(String title, UnaryOperator<Image> view, LongSupplier clock, long soonMillis) {
        this.soonMillis = soonMillis;
        this.title = title;
        this.view = view;
        this.clock = clock;
        started = clock.getAsLong();
    }

    /** Sets the title, for instance for the next frame of a film. */
    public synchronized void title(String value) {
        title = value;
    }

    /** Sets a statistic of the render: a text, a number, or a boolean. */
    public synchronized void statistic(String name, Object value) {
        statistics.put(name, value);
    }

    /** A listener that records the progress of a render and forwards all of it to the display. */
    public RenderProgress listening(RenderProgress display) {
        return new Listener(display);
    }

    /** Records the final picture of a render, which may be incomplete, and its statistics. */
    public void rendered(Image image, RenderResult result) {
        RenderReport report = result.report();
        synchronized (this) {
            statistics.put("samplesPerPixel", report.sampling().samplesPerPixel());
            statistics.put("rays", report.rays());
            statistics.put("raysPerSecond", report.raysPerSecond());
            statistics.put("estimatedError", report.sampling().estimatedError());
        }
        take(image.isInMemory() ? image : ReducedPicture.of(image, ReducedPicture.MOST_PIXELS), Long.MAX_VALUE);
    }

    /** Whether all units are done. */
    public synchronized boolean isWhole() {
        return total > 0 && done == total;
    }

    /** Records the end of the render, and whether it is complete. */
    public synchronized void ended(boolean isComplete) {
        ended = clock.getAsLong();
        state = isComplete ? State.FINISHED : State.STOPPED;
        notifyAll();
    }

    private void take(Supplier<Image> soFar, long now) {
        try {
            Image image = soFar.get();
            take(image, clock.getAsLong() - now);
        } catch (OutOfMemoryError e) {
            // The remaining memory is for the render, which goes on without a picture.
            isTooLarge = true;
        }
    }

    private synchronized void take(Image image, long nanos) {
        picture = image;
        number++;
        taken = clock.getAsLong();
        // The shortest time of all: longer ones include waiting for a processor.
        took = Math.min(nanos, took);
        isWanted = false;
        notifyAll();
    }

    /** The listener of the render; rendering threads call it one at a time. */
    private final class Listener implements RenderProgress {
        private final RenderProgress display;

        Listener(RenderProgress display) {
            this.display = display;
        }

        @Override
        public void planned(double planned, String decidedBy) {
            synchronized (WatchedRender.this) {
                samples = planned;
                statistics.put("samplesPerPixel", planned);
                statistics.put("decidedBy", decidedBy);
            }
            display.planned(planned, decidedBy);
        }

        @Override
        public void note(String text) {
            synchronized (WatchedRender.this) {
                if (notes.size() == MOST_NOTES) {
                    notes.removeFirst();
                }
                notes.add(new Status.Note(seconds(), text));
            }
            display.note(text);
        }

        @Override
        public void coarse(Supplier<Image> soFar) {
            display.coarse(soFar);
            long now = clock.getAsLong();
            boolean isDue;
            synchronized (WatchedRender.this) {
                isDue = isDue(now);
            }
            if (isDue) {
                take(soFar, now);
            }
        }

        @Override
        public void progress(long isDone, long ofAll, Supplier<Image> soFar) {
            display.progress(isDone, ofAll, soFar);
            long now = clock.getAsLong();
            boolean isDue;
            synchronized (WatchedRender.this) {
                state = State.RENDERING;
                done = isDone;
                total = ofAll;
                timeLeft.at(now, isDone, ofAll);
                isDue = isDue(now) || isDone == ofAll && !isTooLarge;
            }
            if (isDue) {
                take(soFar, now);
            }
        }
    }

    /** Whether a picture was requested and the last copy is old enough; called under the lock. */
    private boolean isDue(long now) {
        long pause = Math.max(PERIOD_NANOS, (long) (took / SHARE));
        return !isTooLarge && isWanted && (picture == null || now - taken >= pause);
    }

    private double seconds() {
        return ((state.isOver() ? ended : clock.getAsLong()) - started) * NANO;
    }

    @Override
    public State state() {
        return state;
    }

    @Override
    public synchronized Status status() {
        isWanted = true;
        double seconds = seconds();
        Map<String, Object> known = new LinkedHashMap<>(statistics);
        double made = done * samples;
        if (made > 0) {
            known.put("samples", made);
            known.put("samplesPerSecond", made / seconds);
        }
        Runtime runtime = Runtime.getRuntime();
        known.put("memoryBytes", runtime.totalMemory() - runtime.freeMemory());
        known.put("processorSeconds", MachineFacts.processorNanos() * NANO);
        OptionalDouble left = state.isOver() ? OptionalDouble.of(0) : timeLeft.seconds();
        return new Status(title, state, done, total, "pixels", seconds, left, number, known, List.copyOf(notes));
    }

    @Override
    public Optional<Image> image() {
        Image latest;
        long which;
        synchronized (this) {
            isWanted = true;
            awaitNewer();
            latest = picture;
            which = number;
        }
        if (latest == null) {
            return Optional.empty();
        }
        Shown last = shown.get();
        if (last.number != which) {
            last = new Shown(which, view.apply(latest));
            shown.set(last);
        }
        return Optional.of(last.image);
    }

    private void awaitNewer() {
        if (state.isOver() || picture != null && clock.getAsLong() - taken < STALE_NANOS) {
            return;
        }
        try {
            // No loop: a spurious wakeup merely returns an older picture.
            wait(soonMillis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
