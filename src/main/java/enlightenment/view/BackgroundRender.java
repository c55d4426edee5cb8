package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.image.ImageFormat;
import enlightenment.math.InvalidValueException;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.SceneException;
import enlightenment.text.Plain;
import enlightenment.view.RenderStatus.State;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/** Final renders of a view, one at a time on a background thread, and the files of the last one. All members are thread-safe. */
final class BackgroundRender {
    /** Formats of the files that are made of each render. */
    static final List<ImageFormat> FORMATS = List.of(ImageFormat.PNG, ImageFormat.EXR);

    private static final double NANO = 1e-9;
    private static final long NEWS_NANOS = 200_000_000;
    private static final int MOST_NOTES = 5;
    private static final int LONGEST_NOTE = 500;

    private final ViewSession session;
    private final PictureFiles files;
    private final LongSupplier clock;

    private RenderStatus status = new RenderStatus(1, State.NONE, 0, 0, 0, 0, List.of());
    private Map<ImageFormat, byte[]> written = Map.of();
    private boolean isCancelled;
    private long began;

    /** Time of the last status change caused by progress, in nanoseconds of the clock. */
    private long told;

    /** @param clock nanoseconds of any origin */
    BackgroundRender(ViewSession session, PictureFiles files, LongSupplier clock) {
        this.session = session;
        this.files = files;
        this.clock = clock;
    }

    /**
     * Begins a render and discards the files of the last one.
     *
     * @throws InvalidValueException if a render is under way
     */
    synchronized void start(RenderOrder order) {
        if (status.isRunning()) {
            throw new InvalidValueException("render", "is under way: it can be cancelled");
        }
        isCancelled = false;
        written = Map.of();
        began = clock.getAsLong();
        int width = order.settings().width();
        int height = order.settings().height();
        change(new RenderStatus(0, State.RUNNING, 0, 0, width, height, List.of()));
        session.background(true);
        Thread thread = new Thread(() -> run(order), "view final");
        thread.setDaemon(true);
        thread.start();
    }

    /** Cancels the render that is under way, if any. */
    synchronized void cancel() {
        isCancelled = true;
    }

    private synchronized boolean isCancelled() {
        return isCancelled || session.isClosed();
    }

    private void run(RenderOrder order) {
        try {
            render(order);
        } catch (CancellationException e) {
            end(State.CANCELLED, List.of());
        } catch (SceneException e) {
            end(State.FAILED, ViewSession.lines(e));
        } catch (InvalidValueException e) {
            end(State.FAILED, List.of("\"" + e.key() + "\" " + e.problem()));
        } catch (OutOfMemoryError e) {
            end(State.FAILED, List.of("out of memory: a smaller picture, or java -Xmx, may help"));
        } catch (IOException e) {
            end(State.FAILED, List.of(Plain.line(e.getMessage(), LONGEST_NOTE)));
        } catch (RuntimeException e) {
            end(State.FAILED, List.of("internal error: " + e));
        }
    }

    private void render(RenderOrder order) throws IOException {
        RenderResult result = order.film()
                .render(RenderRequest.of(order.scene(), order.settings())
                        .withProgress(new Listener())
                        .withCancelled(
                                new RestingThreads(this::isCancelled, session::isInUse, clock, RestingThreads::sleep)));
        if (!result.complete()) {
            throw new CancellationException("the render was cancelled");
        }
        if (!result.report().isErrorMet()) {
            note(String.format(
                    Locale.ROOT,
                    "the error is about %.3g, more than asked",
                    result.report().sampling().errorInFile()));
        }
        Map<ImageFormat, byte[]> made = new EnumMap<>(ImageFormat.class);
        for (ImageFormat format : FORMATS) {
            made.put(format, files.bytes(order.scene(), order.frame(), result, format));
        }
        finish(made);
    }

    private synchronized void finish(Map<ImageFormat, byte[]> made) {
        if (isCancelled()) {
            end(State.CANCELLED, List.of());
            return;
        }
        written = made;
        end(State.DONE, status.notes());
    }

    private synchronized void end(State state, List<String> notes) {
        double done = state == State.DONE ? 1 : status.done();
        change(new RenderStatus(0, state, done, seconds(), status.width(), status.height(), notes));
        session.background(false);
    }

    /** Sets the status, with the next version in place of that of {@code next}, and wakes waiting threads. */
    private synchronized void change(RenderStatus next) {
        status = new RenderStatus(
                status.version() + 1,
                next.state(),
                next.done(),
                next.seconds(),
                next.width(),
                next.height(),
                List.copyOf(next.notes()));
        notifyAll();
    }

    private synchronized void advance(double done) {
        if (clock.getAsLong() - told >= NEWS_NANOS) {
            told = clock.getAsLong();
            change(new RenderStatus(
                    0, State.RUNNING, done, seconds(), status.width(), status.height(), status.notes()));
        }
    }

    private synchronized void note(String text) {
        List<String> notes = new ArrayList<>(status.notes());
        notes.add(Plain.line(text, LONGEST_NOTE));
        List<String> last = notes.subList(Math.max(notes.size() - MOST_NOTES, 0), notes.size());
        change(new RenderStatus(0, status.state(), status.done(), seconds(), status.width(), status.height(), last));
    }

    private double seconds() {
        return (clock.getAsLong() - began) * NANO;
    }

    private final class Listener implements RenderProgress {
        @Override
        public void progress(long done, long total, Supplier<Image> soFar) {
            advance((double) done / total);
        }

        @Override
        public void note(String text) {
            BackgroundRender.this.note(text);
        }
    }

    synchronized RenderStatus status() {
        return status;
    }

    /**
     * Waits for a status newer than a version, and returns the latest status.
     *
     * @param millis the longest wait
     */
    synchronized RenderStatus awaitNewer(long than, long millis) throws InterruptedException {
        long end = System.nanoTime() + millis * 1_000_000;
        for (long left = millis; !session.isClosed() && status.version() <= than && left > 0; ) {
            wait(left);
            left = (end - System.nanoTime()) / 1_000_000;
        }
        return status;
    }

    /** The bytes of a file of the last render; null unless that render is done. */
    synchronized byte[] file(ImageFormat format) {
        return written.get(format);
    }
}
