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
 * A render of this process that can be watched. Without watchers it costs next to nothing: the picture so far is copied only if a request
 * came since the last copy, some times a second at most, and for large pictures as seldom as makes it a small share of the time. All else
 * is done by the threads that answer requests.
 */
public final class WatchedRender implements StatusSource {
    static final long PERIOD_NANOS = 250_000_000L;

    /** The largest share of the time of one thread that copying may take. */
    static final double SHARE = 0.02;

    /** The age from which a picture is not returned if there will be a newer one soon. */
    static final long STALE_NANOS = 1_000_000_000L;

    /** How long a request waits for a newer picture. */
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

    /** The last picture as it is shown, for all who look. */
    private final AtomicReference<Shown> shown = new AtomicReference<>(new Shown(0, null));

    private volatile State state = State.PREPARING;
    private volatile boolean isWanted = true;

    /** Whether there is no memory for a copy of the picture. */
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
     * @param title what is rendered
     * @param view makes of a picture what is to be shown of it
     * @param clock nanoseconds
     */
    public WatchedRender(String title, UnaryOperator<Image> view, LongSupplier clock) {
        this(title, view, clock, SOON_MILLIS);
    }

    /** @param soonMillis how long a request waits for a picture that is not old */
    WatchedRender(String title, UnaryOperator<Image> view, LongSupplier clock, long soonMillis) {
        this.soonMillis = soonMillis;
        this.title = title;
        this.view = view;
        this.clock = clock;
        started = clock.getAsLong();
    }

    /** The title of what is rendered from now on, one frame of a film for instance. */
    public synchronized void title(String value) {
        title = value;
    }

    /** Sets a statistic of the render: a text, a number, or a truth value. */
    public synchronized void statistic(String name, Object value) {
        statistics.put(name, value);
    }

    /** Listens to a render, and passes everything on to the display. */
    public RenderProgress listening(RenderProgress display) {
        return new Listener(display);
    }

    /** A picture is whole, or as whole as it will be. */
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

    /** Whether all of it is done, whatever becomes of it. */
    public synchronized boolean isWhole() {
        return total > 0 && done == total;
    }

    /** The render ends here. */
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
            // What is left is for the render: it goes on without being seen.
            isTooLarge = true;
        }
    }

    private synchronized void take(Image image, long nanos) {
        picture = image;
        number++;
        taken = clock.getAsLong();
        // The least of all: what the others took longer they waited for a processor.
        took = Math.min(nanos, took);
        isWanted = false;
        notifyAll();
    }

    /** The listener, which the rendering threads call one at a time. */
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

    /** Whether somebody waits for a picture, and there was none for long enough; called under the lock. */
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
            // Once: a wait that ends early gives an older picture, which is no harm.
            wait(soonMillis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
