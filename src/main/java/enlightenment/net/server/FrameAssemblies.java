package enlightenment.net.server;

import enlightenment.checkpoint.ResultJournal;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FrameLayout;
import enlightenment.engine.ResultCheck;
import enlightenment.engine.ResultStore;
import enlightenment.engine.UnitAssembly;
import enlightenment.engine.UnitGroups;
import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Where tiles of many pictures become pictures. A picture takes memory from its first tile on until it is whole and
 * {@linkplain #takeWhole taken}; only the first few that were not taken may be worked at. Of one that was taken nothing is kept: where a
 * tile of it turns out to be wrong, the picture begins anew. For use by several threads at once.
 */
public final class FrameAssemblies implements UnitAssembly, Closeable {
    private final FrameLayout layout;
    private final Frames frames;
    private final int ahead;

    /** The open pictures by their numbers. */
    private final Map<Integer, Open> open = new TreeMap<>();

    private final BitSet whole = new BitSet();
    private final BitSet taken = new BitSet();
    private final Set<Integer> begunAnew = new TreeSet<>();
    private Image latest;
    private int end;

    /** The properties of the pictures that assembling needs. */
    public interface Frames {
        /** Number of pixels. */
        long pixels(int frame);

        /** Which units of the picture are one here. */
        UnitGroups groups(int frame);

        /** The check for results of the picture's units; called without any lock. */
        ResultCheck check(int frame);

        /** An empty picture. */
        FilmAssembly empty(int frame);
    }

    /** A picture in the making, the groups of its units that are there, and what is needed to take them out again. */
    private record Open(FilmAssembly film, UnitGroups groups, BitSet there, ResultJournal results) {
        int done() {
            return there.cardinality();
        }
    }

    /** A picture that is whole. */
    public record Whole(int frame, FilmAssembly film) {}

    /**
     * Pictures of which nothing is there yet.
     *
     * @param ahead how many from the first on that was not taken may be worked at, at least 1
     */
    public FrameAssemblies(FrameLayout layout, Frames frames, int ahead) {
        this.layout = layout;
        this.frames = frames;
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
            there = opened(frame);
            open.put(frame, there);
        }
        return there;
    }

    private Open opened(int frame) {
        FilmAssembly film = frames.empty(frame);
        ResultJournal results = new ResultJournal(film.needsStore() ? film.units() : 0);
        if (film.needsStore()) {
            film.keepIn(results);
        }
        return new Open(film, frames.groups(frame), new BitSet(), results);
    }

    /** The index of the picture that a unit belongs to. */
    public int frame(int unit) {
        return layout.frame(unit);
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
        int frame = layout.frame(unit);
        UnitGroups groups = frames.groups(frame);
        ResultCheck check = frames.check(frame);
        int sum = 0;
        for (int one = groups.first(within(unit)); one < groups.last(within(unit)); one++) {
            sum += Integer.BYTES + check.longest(one);
        }
        return sum;
    }

    @Override
    public Optional<String> problem(int unit, byte[] bytes) {
        if (unit < 0 || unit >= units()) {
            return Optional.of("there is no such tile");
        }
        int frame = layout.frame(unit);
        UnitGroups groups = frames.groups(frame);
        Optional<List<byte[]>> results = groups.split(within(unit), bytes);
        if (results.isEmpty()) {
            return Optional.of("it is not the results of a group of tiles");
        }
        // The picture may be taken, or not begun: then it has no memory, and gets none for what somebody says of it.
        ResultCheck check = frames.check(frame);
        int one = groups.first(within(unit));
        for (byte[] result : results.get()) {
            Optional<String> problem = check.problem(one++, result);
            if (problem.isPresent()) {
                return problem;
            }
        }
        return Optional.empty();
    }

    @Override
    public ContentHash digest(int unit, byte[] bytes) {
        int frame = layout.frame(unit);
        ResultCheck check = frames.check(frame);
        MessageDigest digest = ContentHash.sha256();
        for (byte[] result : frames.groups(frame).split(within(unit), bytes).orElseThrow()) {
            digest.update(check.digest(result).toBytes());
        }
        return ContentHash.fromBytes(digest.digest());
    }

    @Override
    public synchronized void put(int unit, byte[] bytes) {
        int frame = layout.frame(unit);
        Open of = open(frame);
        int group = within(unit);
        List<byte[]> results = of.groups
                .split(group, bytes)
                .orElseThrow(() -> new IllegalArgumentException("unit " + unit + " is not the results of a group"));
        for (int i = 0; i < results.size(); i++) {
            of.film.put(of.groups.first(group) + i, results.get(i));
        }
        of.there.set(group);
        whole.set(frame, of.film.done() == of.film.units());
    }

    @Override
    public synchronized void remove(int unit) {
        int frame = layout.frame(unit);
        if (taken.get(frame) || open.containsKey(frame)) {
            Open of = open(frame);
            int group = within(unit);
            for (int one = of.groups.first(group); one < of.groups.last(group); one++) {
                of.film.remove(one);
            }
            of.there.clear(group);
            whole.clear(frame);
        }
    }

    @Override
    public synchronized boolean has(int unit) {
        int frame = layout.frame(unit);
        Open there = open.get(frame);
        return there == null ? taken.get(frame) : there.there.get(within(unit));
    }

    @Override
    public synchronized int done() {
        int sum = open.values().stream().mapToInt(Open::done).sum();
        for (int f = taken.nextSetBit(0); f >= 0; f = taken.nextSetBit(f + 1)) {
            sum += layout.first(f + 1) - layout.first(f);
        }
        return sum;
    }

    @Override
    public synchronized long pixelsDone() {
        long sum = open.values().stream().mapToLong(o -> o.film.pixelsDone()).sum();
        for (int f = taken.nextSetBit(0); f >= 0; f = taken.nextSetBit(f + 1)) {
            sum += frames.pixels(f);
        }
        return sum;
    }

    @Override
    public long pixels() {
        long sum = 0;
        for (int f = 0; f < layout.frames(); f++) {
            sum += frames.pixels(f);
        }
        return sum;
    }

    @Override
    public synchronized Image image() {
        for (Open one : open.values()) {
            if (one.done() > 0) {
                return one.film.image();
            }
        }
        if (latest == null) {
            FilmAssembly empty = frames.empty(0);
            latest = empty.image();
            empty.film().release();
        }
        return latest;
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
        for (Open one : open.values()) {
            close(one);
            one.film.film().release();
        }
        open.clear();
    }
}
