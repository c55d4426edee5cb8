package enlightenment.net;

import enlightenment.compiled.SceneImages;
import enlightenment.engine.DividedRender;
import enlightenment.engine.FrameLayout;
import enlightenment.engine.RenderCourse;
import enlightenment.engine.Rendered;
import enlightenment.net.job.FilmContent;
import enlightenment.net.job.JobContent;
import enlightenment.net.server.FrameAssemblies;
import enlightenment.net.server.ServerJob;
import enlightenment.net.worker.WorkerUnits;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntFunction;

/**
 * The frames of a film as jobs: first all of them, then those that are not as exact as was asked, with more samples, and so on. Used by
 * one thread.
 */
final class FilmQueue {
    /** At most so much memory is taken by frames that are worked at, as a share of what there is. */
    private static final double SHARE_OF_MEMORY = 0.25;

    /** What a pixel takes while it is worked at, at most: sums of paths and of tiles, and the finished picture. */
    private static final int BYTES_PER_PIXEL = 256;

    /** The threads of a film's units are those of whoever makes them. */
    private static final int THREADS = 1;

    private final IntFunction<FilmServer.Frame> frames;
    private final String build;
    private final Consumer<String> log;
    private final BooleanSupplier cancelled;
    private final SceneImages images = new SceneImages();
    private final Set<String> notes = new HashSet<>();

    /** The frames that are not exact enough, with the samples that they get. */
    private final Map<Integer, Double> more = new TreeMap<>();

    private Round latest;

    FilmQueue(IntFunction<FilmServer.Frame> frames, String build, Consumer<String> log, BooleanSupplier cancelled) {
        this.frames = frames;
        this.build = build;
        this.log = log;
        this.cancelled = cancelled;
    }

    /**
     * Frames that are one job.
     *
     * @param number 1 for the first, which has all frames
     * @param numbers of the frames
     * @param courses what is kept of their renders
     * @param film where they are put together
     */
    record Round(
            int number,
            List<Integer> numbers,
            List<RenderCourse> courses,
            FrameAssemblies film,
            FilmContent parts,
            JobContent content,
            Consumer<String> log,
            String build) {
        int number(int frame) {
            return numbers.get(frame);
        }

        boolean isDone() {
            return film.done() == film.units();
        }

        /** The job, afresh. */
        ServerJob job() {
            return new ServerJob(WorkerUnits.of(parts.frames(), parts.images(), build, THREADS), film, content, log);
        }
    }

    /** The job of all frames. */
    Round first(List<Integer> numbers) {
        return round(1, numbers, (number, frame) -> {
            if (frame.settings().budget().seconds().isPresent()) {
                throw new IllegalArgumentException("the frames of a film that many machines make must not depend on the"
                        + " time that they take: give samples or an error");
            }
            return DividedRender.prepare(frame.scene(), frame.settings(), images, cancelled);
        });
    }

    /** The job of the frames that are not exact enough yet; null if there are none. */
    Round next(Round before) {
        if (more.isEmpty()) {
            return null;
        }
        Map<Integer, Double> samples = new TreeMap<>(more);
        more.clear();
        return round(before.number + 1, List.copyOf(samples.keySet()), (number, frame) -> before.courses
                .get(before.numbers.indexOf(number))
                .again(frame.scene(), images, samples.get(number), cancelled));
    }

    /** Plans a frame. */
    @FunctionalInterface
    private interface Plan {
        DividedRender render(int number, FilmServer.Frame frame);
    }

    private Round round(int count, List<Integer> numbers, Plan plan) {
        FilmContent parts = new FilmContent(build);
        List<RenderCourse> courses = new ArrayList<>();
        long[] pixels = new long[numbers.size()];
        for (int number : numbers) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("stopped before all frames were planned");
            }
            FilmServer.Frame frame = frames.apply(number);
            DividedRender render = plan.render(number, frame);
            tell(number, render.notes());
            RenderSettings.Crop region = frame.settings().region();
            pixels[courses.size()] = (long) region.width() * region.height();
            parts.add(frame.scene(), render.outline());
            courses.add(render.course());
        }
        FrameLayout layout = new FrameLayout(
                parts.frames().stream().mapToInt(FilmContent.Frame::tiles).toArray());
        FrameAssemblies film =
                new FrameAssemblies(layout, pixels, frame -> courses.get(frame).assembly(), ahead(pixels));
        latest = new Round(count, numbers, courses, film, parts, parts.content(), log, build);
        return latest;
    }

    /** What is true of many frames is said once. */
    private void tell(int number, List<String> said) {
        for (String note : said) {
            if (notes.add(note)) {
                log.accept("frame " + number + ": " + note);
            }
        }
    }

    /** How many frames may be worked at at once: two at least, so that nobody waits where one ends. */
    private static int ahead(long[] pixels) {
        long most = 1;
        for (long one : pixels) {
            most = Math.max(most, one);
        }
        double bytes = SHARE_OF_MEMORY * Runtime.getRuntime().maxMemory();
        return (int) Math.max(2, Math.min(bytes / ((double) most * BYTES_PER_PIXEL), pixels.length));
    }

    /** Whether a frame is as exact as was asked; if not it is rendered again in the next round. */
    boolean isEnough(Round round, int frame, Rendered rendered) {
        int number = round.number(frame);
        OptionalDouble samples =
                round.courses.get(frame).next(rendered, note -> log.accept("frame " + number + ": " + note));
        if (samples.isPresent()) {
            more.put(number, samples.getAsDouble());
            return false;
        }
        more.remove(number);
        return true;
    }

    /** Whether there is nothing more to do. */
    boolean isDone() {
        return latest.isDone() && more.isEmpty();
    }

    /** Lets go of what is worked at. */
    void close() {
        latest.film.close();
    }
}
