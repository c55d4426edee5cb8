package enlightenment.net.server;

import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FrameLayout;
import enlightenment.engine.ResultStore;
import enlightenment.engine.UnitAssembly;
import enlightenment.image.Image;
import enlightenment.net.checkpoint.ResultJournal;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.IntFunction;

/**
 * Where tiles of many pictures become pictures. A picture takes memory from its first tile on until it is whole and
 * {@linkplain #takeWhole taken}; only the first few that were not taken may be worked at. Of one that was taken nothing is kept: where a
 * tile of it turns out to be wrong, the picture begins anew. For use by several threads at once.
 */
public final class FrameAssemblies implements UnitAssembly, Closeable {
    private final FrameLayout layout;
    private final long[] pixels;
    private final IntFunction<FilmAssembly> empty;
    private final int ahead;

    /** What is worked at, by the pictures' numbers. */
    private final Map<Integer, Open> open = new TreeMap<>();

    private final BitSet whole = new BitSet();
    private final BitSet taken = new BitSet();
    private final Set<Integer> begunAnew = new TreeSet<>();
    private Image latest;
    private int end;

    /** A picture in the making, and what is needed to take tiles out of it. */
    private record Open(FilmAssembly film, ResultJournal results) {}

    /** A picture that is whole. */
    public record Whole(int frame, FilmAssembly film) {}

    /**
     * Pictures of which nothing is there yet.
     *
     * @param pixels of each
     * @param empty makes an empty one
     * @param ahead how many from the first on that was not taken may be worked at, at least 1
     */
    public FrameAssemblies(FrameLayout layout, long[] pixels, IntFunction<FilmAssembly> empty, int ahead) {
        this.layout = layout;
        this.pixels = pixels.clone();
        this.empty = empty;
        this.ahead = ahead;
        advance();
    }

    private void advance() {
        int last = (int) Math.min((long) taken.nextClearBit(0) + ahead, layout.frames());
        end = Math.max(end, layout.first(last));
    }

    /** The next picture that is whole and has not been taken; empty if there is none. */
    public synchronized Optional<Whole> takeWhole() {
        BitSet waiting = (BitSet) whole.clone();
        waiting.andNot(taken);
        int frame = waiting.nextSetBit(0);
        if (frame < 0) {
            return Optional.empty();
        }
        taken.set(frame);
        advance();
        Open done = open.remove(frame);
        close(done);
        return Optional.of(new Whole(frame, done.film));
    }

    private static void close(Open closed) {
        try {
            closed.results.close();
        } catch (IOException e) {
            throw new UncheckedIOException("a file of the temporary folder: " + e.getMessage(), e);
        }
    }

    /** Shows this picture until another one is worked at. */
    public synchronized void show(Image image) {
        latest = image;
    }

    /** The picture, which becomes one that is worked at. */
    private Open open(int frame) {
        if (taken.get(frame)) {
            taken.clear(frame);
            begunAnew.add(frame);
        }
        Open there = open.get(frame);
        if (there == null) {
            FilmAssembly film = empty.apply(frame);
            ResultJournal results = new ResultJournal(film.needsStore() ? film.units() : 0);
            if (film.needsStore()) {
                film.keepIn(results);
            }
            there = new Open(film, results);
            open.put(frame, there);
        }
        return there;
    }

    private int within(int unit) {
        return unit - layout.first(layout.frame(unit));
    }

    @Override
    public int units() {
        return layout.units();
    }

    @Override
    public synchronized int end() {
        return end;
    }

    @Override
    public synchronized List<Range> takeLost() {
        if (begunAnew.isEmpty()) {
            return List.of();
        }
        List<Range> lost = new ArrayList<>();
        for (int frame : begunAnew) {
            for (int unit = layout.first(frame); unit < layout.first(frame + 1); unit++) {
                if (!has(unit)) {
                    lost.add(new Range(unit, unit + 1));
                }
            }
        }
        begunAnew.clear();
        return lost;
    }

    @Override
    public int longest(int unit) {
        return film(unit).longest(within(unit));
    }

    @Override
    public Optional<String> problem(int unit, byte[] bytes) {
        return unit < 0 || unit >= units()
                ? Optional.of("there is no such tile")
                : film(unit).problem(within(unit), bytes);
    }

    /** The picture of a unit as it is; an empty one where nothing is kept, as after it was taken. */
    private FilmAssembly film(int unit) {
        int frame = layout.frame(unit);
        synchronized (this) {
            Open there = open.get(frame);
            if (there != null) {
                return there.film;
            }
        }
        return empty.apply(frame);
    }

    @Override
    public synchronized void put(int unit, byte[] bytes) {
        int frame = layout.frame(unit);
        FilmAssembly film = open(frame).film;
        film.put(within(unit), bytes);
        whole.set(frame, film.done() == film.units());
    }

    @Override
    public synchronized void remove(int unit) {
        int frame = layout.frame(unit);
        if (taken.get(frame) || open.containsKey(frame)) {
            open(frame).film.remove(within(unit));
            whole.clear(frame);
        }
    }

    @Override
    public synchronized boolean has(int unit) {
        int frame = layout.frame(unit);
        Open there = open.get(frame);
        return there == null ? taken.get(frame) : there.film.has(within(unit));
    }

    @Override
    public synchronized int done() {
        int sum = open.values().stream().mapToInt(o -> o.film.done()).sum();
        for (int f = taken.nextSetBit(0); f >= 0; f = taken.nextSetBit(f + 1)) {
            sum += layout.first(f + 1) - layout.first(f);
        }
        return sum;
    }

    @Override
    public synchronized long pixelsDone() {
        long sum = open.values().stream().mapToLong(o -> o.film.pixelsDone()).sum();
        for (int f = taken.nextSetBit(0); f >= 0; f = taken.nextSetBit(f + 1)) {
            sum += pixels[f];
        }
        return sum;
    }

    @Override
    public long pixels() {
        long sum = 0;
        for (long one : pixels) {
            sum += one;
        }
        return sum;
    }

    @Override
    public synchronized Image image() {
        for (Open one : open.values()) {
            if (one.film.done() > 0) {
                return one.film.image();
            }
        }
        return latest == null ? empty.apply(0).image() : latest;
    }

    /** False: each picture has one of its own. */
    @Override
    public boolean needsStore() {
        return false;
    }

    @Override
    public void keepIn(ResultStore results) {
        throw new UnsupportedOperationException("each picture keeps its results itself");
    }

    @Override
    public synchronized void close() {
        open.values().forEach(FrameAssemblies::close);
        open.clear();
    }
}
