package enlightenment.store;

import enlightenment.engine.FilmAssembly;
import enlightenment.engine.KeptPlan;
import enlightenment.film.SampleLog;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;

/**
 * Keeps a render in a store. What comes within a fifth of a second is written in one transaction, a unit and its samples never in two:
 * what {@link #tick} or {@link #close} has written is safe, and of what came later a unit is there with its samples or not at all.
 */
public final class StoreArchive implements RenderResult.Archive.OfSamples {
    static final long WRITE_EVERY_NANOS = 200_000_000L;

    /** Bytes that may wait to be written, beside one result. */
    private static final long MOST_WAITING = 8L << 20;

    private final Database database;
    private final String render;

    private final DoubleFunction<Map<String, String>> texts;

    /** Which samples are wanted with each unit; -1 for none. */
    private final int kind;

    /** By plan, units that were replayed when it was opened, and may be made again if not valid. */
    private final Map<Integer, BitSet> replayed = new HashMap<>();

    private final Map<Place, Part> parts = new LinkedHashMap<>();
    private final List<Block> blocks = new ArrayList<>();

    /** By unit, the number of its blocks that are not written. */
    private final Map<Place, Integer> pieces = new HashMap<>();

    private long waiting;
    private long lastWrite = System.nanoTime();
    private long damaged;

    /** Whether the last write threw: its caller has received the reason. */
    private boolean isFailureTold;

    /**
     * The render to keep.
     *
     * @param row of which render
     * @param scene its scene as a text, to be looked at
     * @param texts what the picture's file is to say of itself, by the number of samples per pixel that is planned
     * @param samples which data of camera samples are kept beside results
     */
    public record Render(
            RenderRow row, byte[] scene, DoubleFunction<Map<String, String>> texts, StoredSamples samples) {}

    private StoreArchive(Database database, Render what) {
        this.database = database;
        render = what.row.id();
        texts = what.texts;
        kind = what.samples.kind;
    }

    /**
     * Opens a store, which is made if there is none, for a render, which begins there or goes on.
     *
     * @throws IOException if the store cannot be used; the message says why
     */
    public static StoreArchive open(StoreAddress address, StoreLogin login, Render what) throws IOException {
        Database database = Database.toWrite(address, login, Drivers.ofProgram());
        try {
            database.write(c -> {
                what.row.insert(c, database.dialect(), what.scene);
                return null;
            });
            return new StoreArchive(database, what);
        } catch (IOException | RuntimeException e) {
            database.close();
            throw e;
        }
    }

    @Override
    public String name() {
        return "store " + database.name();
    }

    @Override
    public List<byte[]> plans() throws IOException {
        List<byte[]> plans = new ArrayList<>();
        for (PlanRow row : PlanRow.all(database, render)) {
            while (plans.size() < Math.min(row.pass(), PlanRow.MOST)) {
                plans.add(new byte[0]);
            }
            plans.add(row.data());
        }
        return plans;
    }

    @Override
    public int keep(byte[] plan) throws IOException {
        double planned =
                KeptPlan.read(plan).map(p -> p.outline().plan().samples()).orElse(0.0);
        return PlanRow.numberOf(database, render, plan, texts.apply(planned));
    }

    /** Passes all undamaged results of a plan to a listener; where samples are wanted, only those with some. */
    @Override
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

    /** The number of results found damaged. */
    public long damaged() {
        return damaged;
    }

    @Override
    public Optional<byte[]> find(int plan, int unit) throws IOException {
        Place place = new Place(render, plan, unit);
        Part part = parts.get(place);
        return part != null ? Optional.of(part.data()) : database.read(c -> Part.sound(c, database.dialect(), place));
    }

    @Override
    public boolean keepsSamples() {
        return kind >= 0;
    }

    @Override
    public boolean keepsRays() {
        return kind == SampleLog.RAYS;
    }

    @Override
    public void keepSamples(int plan, int unit, int blockKind, int count, byte[] data) throws IOException {
        Place place = new Place(render, plan, unit);
        int piece = pieces.merge(place, 1, Integer::sum) - 1;
        blocks.add(new Block(place, blockKind, piece, count, data));
        waiting += data.length;
        if (waiting >= MOST_WAITING) {
            write();
        }
    }

    @Override
    public void keep(int plan, int unit, String worker, byte[] result) throws IOException {
        Place place = new Place(render, plan, unit);
        pieces.remove(place);
        Part before = parts.put(place, new Part(place, FilmAssembly.cameraRays(result), worker, result));
        waiting += result.length - (before == null ? 0 : before.data().length);
        if (waiting >= MOST_WAITING || System.nanoTime() - lastWrite >= WRITE_EVERY_NANOS) {
            write();
        }
    }

    @Override
    public void remove(int plan, int unit) throws IOException {
        write();
        database.write(c -> {
            Part.delete(c, new Place(render, plan, unit));
            return null;
        });
    }

    @Override
    public void removeAll(int plan, String worker) throws IOException {
        write();
        database.write(c -> {
            Part.deleteOf(c, new Place(render, plan, 0), worker);
            return null;
        });
    }

    @Override
    public void tick() throws IOException {
        if (System.nanoTime() - lastWrite >= WRITE_EVERY_NANOS) {
            write();
        }
    }

    /** Writes what waits: when this returns, it is safe. */
    void write() throws IOException {
        lastWrite = System.nanoTime();
        if (parts.isEmpty() && blocks.isEmpty()) {
            return;
        }
        isFailureTold = true;
        database.write(c -> {
            insertAll(c);
            return null;
        });
        isFailureTold = false;
        parts.clear();
        blocks.clear();
        waiting = 0;
        lastWrite = System.nanoTime();
    }

    private void insertAll(Connection c) throws SQLException, IOException {
        for (Block block : blocks) {
            if (!parts.containsKey(block.place())) {
                // More of its samples follow: what was kept without them must not be taken for whole meanwhile.
                Part.deleteResult(c, block.place());
            }
            block.insert(c, database.dialect());
        }
        for (Part part : parts.values()) {
            BitSet given = replayed.get(part.place().pass());
            part.insert(
                    c,
                    database.dialect(),
                    given != null && given.get(part.place().tile()));
        }
    }

    /** Writes the pending units, also those that an earlier write could not. A reason that a caller has received is not thrown again. */
    @Override
    public void close() throws IOException {
        boolean wasTold = isFailureTold;
        try (database) {
            write();
        } catch (IOException e) {
            if (!wasTold) {
                throw e;
            }
        }
    }
}
