package enlightenment.store;

import java.io.Closeable;
import java.io.IOException;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * Keeps a render in a store. What comes within a fifth of a second is written in one transaction, a unit and its samples never in two:
 * what {@link #tick} or {@link #close} has written is safe, and of what came later a unit is there with its samples or not at all.
 */
public final class StoreArchive implements Closeable {
    static final long WRITE_EVERY_NANOS = 200_000_000L;

    /** What waits to be written is no more than this, and one result. */
    private static final long MOST_WAITING = 8L << 20;

    private final Database database;
    private final String render;

    /** What a picture's file is to say of itself, by the plan. */
    private final Function<byte[], Map<String, String>> texts;

    /** How many camera rays are in a result. */
    private final SampleCount samples;

    /** Which samples are wanted with each unit; -1 for none. */
    private final int kind;

    /** By plan: units that were given away when it was opened, and may be made again if they are of no use. */
    private final Map<Integer, BitSet> replayed = new HashMap<>();

    private final Map<Place, Part> parts = new LinkedHashMap<>();
    private final List<Block> blocks = new ArrayList<>();

    /** How many blocks each unit has that is not written. */
    private final Map<Place, Integer> pieces = new HashMap<>();

    private long waiting;
    private long lastWrite = System.nanoTime();
    private long damaged;

    /** Counts the camera rays of a result. */
    @FunctionalInterface
    public interface SampleCount {
        long of(byte[] result);
    }

    /** Takes what is kept. */
    @FunctionalInterface
    public interface Replay {
        void result(int unit, byte[] bytes) throws IOException;
    }

    private StoreArchive(
            Database database,
            String render,
            Function<byte[], Map<String, String>> texts,
            SampleCount samples,
            int kind) {
        this.database = database;
        this.render = render;
        this.texts = texts;
        this.samples = samples;
        this.kind = kind;
    }

    /**
     * Opens a store, which is made if there is none, for a render, which begins there or goes on.
     *
     * @param scene the scene's text
     * @param texts what the picture's file is to say of itself, by the plan
     * @param kind which samples are to be kept with each unit; -1 for none
     * @throws IOException if the store cannot be used; the message says why
     */
    public static StoreArchive open(
            StoreAddress address,
            StoreLogin login,
            RenderRow row,
            byte[] scene,
            Function<byte[], Map<String, String>> texts,
            SampleCount samples,
            int kind)
            throws IOException {
        Database database = Database.toWrite(address, login, Drivers.ofProgram());
        try {
            database.write(c -> {
                row.insert(c, database.dialect(), scene);
                return null;
            });
            return new StoreArchive(database, row.id(), texts, samples, kind);
        } catch (IOException | RuntimeException e) {
            database.close();
            throw e;
        }
    }

    /** What messages call it. */
    public String name() {
        return "store " + database.name();
    }

    /** The plans that the render was made by so far. */
    public List<byte[]> plans() throws IOException {
        return PlanRow.all(database, render).stream().map(PlanRow::data).toList();
    }

    /** The number of a plan from now on. */
    public int keep(byte[] plan) throws IOException {
        return PlanRow.numberOf(database, render, plan, texts.apply(plan));
    }

    /** Gives away all that is kept of a plan and is whole; where samples are wanted, what has some. */
    public void replay(int plan, Replay to) throws IOException {
        write();
        BitSet given = replayed.computeIfAbsent(plan, p -> new BitSet());
        Parts there = new Parts(database, render, plan, kind);
        there.read((unit, bytes) -> {
            if (unit >= 0) {
                given.set(unit);
                to.result(unit, bytes);
            }
        });
        damaged += there.damaged();
    }

    /** How many results were found damaged. */
    public long damaged() {
        return damaged;
    }

    /** A unit's result; null if it is not there, or damaged. */
    public byte[] find(int plan, int unit) throws IOException {
        Place place = new Place(render, plan, unit);
        Part part = parts.get(place);
        return part != null
                ? part.data()
                : database.read(c -> {
                    try (PreparedStatement select = c.prepareStatement("SELECT crc, data FROM film_part WHERE "
                            + Place.CONDITION + " AND " + database.dialect().length("data") + " <= " + Parts.LONGEST)) {
                        place.set(select, 1);
                        try (ResultSet row = select.executeQuery()) {
                            byte[] data = row.next() ? row.getBytes(2) : null;
                            return data == null || Checksum.of(data) != row.getLong(1) ? null : data;
                        }
                    }
                });
    }

    /** Keeps samples of a unit, before its result. */
    public void block(int plan, int unit, int blockKind, int count, byte[] data) throws IOException {
        Place place = new Place(render, plan, unit);
        int piece = pieces.merge(place, 1, Integer::sum) - 1;
        blocks.add(new Block(place, blockKind, piece, count, data));
        waiting += data.length;
        if (waiting >= MOST_WAITING) {
            write();
        }
    }

    /** Keeps a result. */
    public void keep(int plan, int unit, String worker, byte[] result) throws IOException {
        Place place = new Place(render, plan, unit);
        pieces.remove(place);
        Part before = parts.put(place, new Part(place, samples.of(result), worker, result));
        waiting += result.length - (before == null ? 0 : before.data().length);
        if (waiting >= MOST_WAITING || System.nanoTime() - lastWrite >= WRITE_EVERY_NANOS) {
            write();
        }
    }

    /** Takes a result out, and its samples. */
    public void remove(int plan, int unit) throws IOException {
        write();
        database.write(c -> {
            Part.delete(c, new Place(render, plan, unit));
            return null;
        });
    }

    /** Time has passed. */
    public void tick() throws IOException {
        if (System.nanoTime() - lastWrite >= WRITE_EVERY_NANOS) {
            write();
        }
    }

    private void write() throws IOException {
        lastWrite = System.nanoTime();
        if (parts.isEmpty() && blocks.isEmpty()) {
            return;
        }
        database.write(c -> {
            for (Block block : blocks) {
                block.insert(c, database.dialect());
            }
            for (Part part : parts.values()) {
                BitSet given = replayed.get(part.place().pass());
                part.insert(
                        c,
                        database.dialect(),
                        given != null && given.get(part.place().tile()));
            }
            return null;
        });
        parts.clear();
        blocks.clear();
        waiting = 0;
        lastWrite = System.nanoTime();
    }

    @Override
    public void close() throws IOException {
        try (database) {
            write();
        }
    }
}
