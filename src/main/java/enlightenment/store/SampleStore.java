package enlightenment.store;

import enlightenment.text.Plain;
import java.io.Closeable;
import java.io.IOException;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.List;
import java.util.stream.Collectors;

/** A store that is there, to look at what it holds. For one thread. */
public final class SampleStore implements Closeable {
    /** More workers are not told of. */
    private static final int MOST_WORKERS = 50;

    private static final int LISTED = 20;
    private static final int SHOWN_DIGITS = 12;

    private final Database database;

    private SampleStore(Database database) {
        this.database = database;
    }

    /**
     * Opens a store to read it.
     *
     * @throws IOException if there is none, or it cannot be used; the message says why
     */
    public static SampleStore open(StoreAddress address, StoreLogin login) throws IOException {
        return new SampleStore(Database.toRead(address, login, Drivers.ofProgram()));
    }

    /** Opens a store to unpack samples there. */
    public static SampleStore openToUnpack(StoreAddress address, StoreLogin login) throws IOException {
        return new SampleStore(Database.toUnpack(address, login, Drivers.ofProgram()));
    }

    /** The name of the store in messages. */
    public String name() {
        return database.name();
    }

    Database database() {
        return database;
    }

    /** All renders, the oldest first. */
    public List<RenderRow> renders() throws IOException {
        return RenderRow.all(database);
    }

    /**
     * The render whose id begins so; the only one if nothing is given.
     *
     * @throws IOException if there is none, or are several: the message lists them
     */
    public RenderRow choose(String prefix) throws IOException {
        List<RenderRow> all = renders();
        List<RenderRow> meant =
                all.stream().filter(r -> r.id().startsWith(prefix)).toList();
        if (meant.size() == 1) {
            return meant.get(0);
        }
        if (all.isEmpty()) {
            throw new StoreException(name() + " holds no render yet");
        }
        String why = meant.isEmpty()
                ? "no render in " + name() + " has an id that begins with " + Plain.quoted(prefix) + ":"
                : name() + " holds " + meant.size() + " renders"
                        + (prefix.isEmpty() ? "; say which by the first digits of its id:" : " whose ids begin so:");
        throw new StoreException(why + list(meant.isEmpty() ? all : meant));
    }

    private static String list(List<RenderRow> renders) {
        String lines = renders.stream()
                .skip(Math.max(renders.size() - LISTED, 0))
                .map(r -> "\n  " + shortId(r) + "  " + r.created() + "  " + r.width() + " x " + r.height() + "  "
                        + r.name())
                .collect(Collectors.joining());
        int more = renders.size() - LISTED;
        return lines + (more > 0 ? "\n  and " + more + " older ones" : "");
    }

    /** Enough digits to call a render by. */
    public static String shortId(RenderRow render) {
        return render.id().substring(0, Math.min(render.id().length(), SHOWN_DIGITS));
    }

    /** The plans that a render was made by, in their order. */
    public List<PlanRow> plans(RenderRow render) throws IOException {
        return PlanRow.all(database, render.id());
    }

    /** Receives results. */
    @FunctionalInterface
    public interface Taker {
        void take(int unit, byte[] bytes) throws IOException;
    }

    /**
     * Passes all undamaged results of a plan to a receiver, in the order of units.
     *
     * @return how many are damaged
     */
    public long results(RenderRow render, PlanRow plan, Taker taker) throws IOException {
        Parts parts = new Parts(database, render.id(), plan.pass(), -1);
        parts.read(taker::take);
        return parts.damaged();
    }

    /**
     * The stored amount of a plan.
     *
     * @param units how many results
     * @param samples how many camera rays are in them
     * @param bytes how many bytes they have
     * @param blocks how many blocks of samples
     * @param kept how many samples are in these
     * @param blockBytes how many bytes they have
     */
    public record Facts(long units, long samples, long bytes, long blocks, long kept, long blockBytes) {}

    /** The stored amount of a plan. */
    public Facts facts(RenderRow render, PlanRow plan) throws IOException {
        String parts = "SELECT COUNT(*), SUM(samples * 1.0), SUM("
                + database.dialect().length("data") + " * 1.0) FROM film_part WHERE render_id = ? AND pass = ?";
        String blocks = "SELECT COUNT(*), SUM(n * 1.0), SUM("
                + database.dialect().length("data") + " * 1.0) FROM sample_block WHERE render_id = ? AND pass = ?";
        long[] p = sums(parts, render, plan);
        long[] b = sums(blocks, render, plan);
        return new Facts(p[0], p[1], p[2], b[0], b[1], b[2]);
    }

    private long[] sums(String sql, RenderRow render, PlanRow plan) throws IOException {
        return database.rows(
                        sql,
                        1,
                        row -> new long[] {row.getLong(1), (long) row.getDouble(2), (long) row.getDouble(3)},
                        render.id(),
                        plan.pass())
                .get(0);
    }

    /**
     * A worker with results in the store.
     *
     * @param name its name
     * @param units how many it made
     * @param samples how many camera rays are in them
     */
    public record Worker(String name, long units, long samples) {}

    /** The workers with results of a plan: those with the most first, and no more than fifty. */
    public List<Worker> workers(RenderRow render, PlanRow plan) throws IOException {
        String sql =
                "SELECT SUBSTR(worker, 1, " + Part.LONGEST_WORKER + "), COUNT(*), SUM(samples * 1.0) FROM film_part"
                        + " WHERE render_id = ? AND pass = ? GROUP BY worker ORDER BY 2 DESC, 1";
        return database.rows(sql, MOST_WORKERS, SampleStore::worker, render.id(), plan.pass());
    }

    private static Worker worker(ResultSet row) throws SQLException {
        String name = Plain.line(String.valueOf(row.getString(1)), Part.LONGEST_WORKER);
        return new Worker(name, row.getLong(2), (long) row.getDouble(3));
    }

    @Override
    public void close() throws IOException {
        database.close();
    }
}
