package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmRoom;
import enlightenment.engine.FrameLayout;
import enlightenment.engine.Rendered;
import enlightenment.engine.SharedImages;
import enlightenment.net.job.FilmContent;
import enlightenment.net.job.JobContent;
import enlightenment.net.server.FrameAssemblies;
import enlightenment.net.server.ServerJob;
import enlightenment.net.worker.WorkerUnits;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
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
    /** Threads inside one unit of a film: a worker's pool renders several units in parallel. */
    private static final int THREADS = 1;

    /** Two frames at least are worked at, and one more may be on its way to its file; more are worked at only if all are small. */
    private static final int OPEN_FRAMES = 3;

    /**
     * A frame that is to be rendered.
     *
     * @param scene its scene
     * @param settings how it is rendered
     */
    record Wish(Scene scene, RenderSettings settings) {}

    private final IntFunction<Wish> frames;
    private final FilmRoom room;
    private final String build;
    private final Consumer<String> log;
    private final BooleanSupplier cancelled;
    private final SharedImages images = new SharedImages();
    private final Set<String> notes = new HashSet<>();

    /** The frames that are not exact enough, with the samples that they get. */
    private final Map<Integer, Double> more = new TreeMap<>();

    private Round latest;

    /** @param room where finished pixels of frames may be */
    FilmQueue(IntFunction<Wish> frames, FilmRoom room, String build, Consumer<String> log, BooleanSupplier cancelled) {
        this.frames = frames;
        this.room = room.among(OPEN_FRAMES);
        this.build = build;
        this.log = log;
        this.cancelled = cancelled;
    }

    /**
     * Frames that are one job.
     *
     * @param number 1 for the first, which has all frames
     * @param numbers of the frames
     * @param frames what is kept of their renders
     * @param film where they are put together
     */
    record Round(
            int number,
            List<Integer> numbers,
            List<PlannedFrame> frames,
            FrameAssemblies film,
            FilmContent parts,
            JobContent content,
            Consumer<String> log,
            String build) {
        int number(int frame) {
            return numbers.get(frame);
        }

        /** The number of the frame that a tile of the job belongs to. */
        int numberOfTile(int tile) {
            return number(film.frame(tile));
        }

        boolean isDone() {
            return film.done() == film.units();
        }

        /** The job, afresh. */
        ServerJob job() {
            return ServerJob.of(WorkerUnits.of(parts.frames(), parts.images(), build, THREADS), film, content, log);
        }
    }

    /**
     * The job of all frames.
     *
     * @throws CancellationException if it is cancelled before all of them are planned
     */
    Round first(List<Integer> numbers) {
        return round(1, numbers, (number, frame) -> {
            if (frame.settings().budget().seconds().isPresent()) {
                throw new IllegalArgumentException("the frames of a film that many machines make must not depend on the"
                        + " time that they take: give samples or an error");
            }
            return DividedRender.prepare(frame.scene(), frame.settings(), images, room, cancelled);
        });
    }

    /**
     * The job of the frames that are not exact enough yet; null if there are none.
     *
     * @throws CancellationException if it is cancelled before all of them are planned: they are still to be done then
     */
    Round next(Round before) {
        if (more.isEmpty()) {
            return null;
        }
        Map<Integer, Double> samples = new TreeMap<>(more);
        Round next = round(before.number + 1, List.copyOf(samples.keySet()), (number, frame) -> before.frames
                .get(before.numbers.indexOf(number))
                .course()
                .again(frame.scene(), images, samples.get(number), cancelled));
        more.clear();
        return next;
    }

    /** Plans a frame. */
    @FunctionalInterface
    private interface Plan {
        DividedRender render(int number, Wish frame);
    }

    private Round round(int count, List<Integer> numbers, Plan plan) {
        FilmContent parts = new FilmContent(build);
        List<PlannedFrame> planned = new ArrayList<>();
        for (int number : numbers) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("stopped before all frames were planned");
            }
            Wish frame = frames.apply(number);
            DividedRender render = plan.render(number, frame);
            tell(number, render.notes());
            PlannedFrame kept = PlannedFrame.of(render, numbers.size());
            parts.add(frame.scene(), render.outline(), kept.group());
            planned.add(kept);
        }
        FrameLayout layout = new FrameLayout(
                parts.frames().stream().mapToInt(FilmContent.Frame::tiles).toArray());
        int ahead = planned.stream().mapToInt(PlannedFrame::ahead).min().orElseThrow();
        FrameAssemblies film = new FrameAssemblies(layout, new PlannedFrame.All(planned), ahead);
        latest = new Round(count, numbers, planned, film, parts, parts.content(), log, build);
        return latest;
    }

    /** Logs notes about a frame, unless an earlier frame had equal ones. */
    private void tell(int number, List<String> said) {
        for (String note : said) {
            if (notes.add(note)) {
                log.accept("frame " + number + ": " + note);
            }
        }
    }

    /** Whether a frame is as exact as was asked; if not it is rendered again in the next round. */
    boolean isEnough(Round round, int frame, Rendered rendered) {
        int number = round.number(frame);
        OptionalDouble samples =
                round.frames.get(frame).course().next(rendered, note -> log.accept("frame " + number + ": " + note));
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
