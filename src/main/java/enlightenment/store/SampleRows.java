package enlightenment.store;

import enlightenment.film.SampleBlock;
import enlightenment.film.SampleLog;
import java.io.IOException;
import java.io.Writer;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import java.sql.Types;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/** Unpacks the samples of a plan: into rows of a table of the store, or into lines of text. */
public final class SampleRows {
    /** The columns of real numbers. */
    static final List<String> REALS = List.of(
            "x",
            "y",
            "r",
            "g",
            "b",
            "w",
            "window_x",
            "window_y",
            "window_z",
            "surface_x",
            "surface_y",
            "surface_z",
            "light_x",
            "light_y",
            "light_z");

    /** The number of these columns that do not belong to rays. */
    private static final int OF_SAMPLES = 6;

    private static final int KEYS = 6;
    private static final int COLUMNS = KEYS + REALS.size() + 2;

    /** The number of rows sent to the database at once. */
    private static final int BATCH = 1 << 12;

    private final Database database;
    private final RenderRow render;
    private final int pass;
    private final int kind;
    private final double[] reals = new double[REALS.size()];
    private final SampleNumbers numbers;
    private long written;
    private long damaged;

    private SampleRows(Database database, RenderRow render, PlanRow plan, int kind) {
        this.database = database;
        this.render = render;
        pass = plan.pass();
        this.kind = kind;
        numbers = new SampleNumbers(StorePicture.workUnits(plan));
    }

    /**
     * The samples of the plan whose picture {@link StorePicture} makes, or else of the last that has any; with their rays if they were
     * kept.
     *
     * @throws IOException if no samples of the render were kept
     */
    public static SampleRows of(SampleStore store, RenderRow render) throws IOException {
        List<PlanRow> plans = new ArrayList<>(store.plans(render));
        plans.add(StorePicture.plan(store, render));
        Collections.reverse(plans);
        for (PlanRow plan : plans) {
            for (int kind : new int[] {SampleLog.RAYS, SampleLog.PIXELS}) {
                if (has(store.database(), render, plan, kind)) {
                    return new SampleRows(store.database(), render, plan, kind);
                }
            }
        }
        throw new StoreException("no samples of render " + SampleStore.shortId(render) + " were kept: render with"
                + " --store-samples or --store-rays");
    }

    private static boolean has(Database database, RenderRow render, PlanRow plan, int kind) throws IOException {
        String sql = "SELECT 1 FROM sample_block WHERE render_id = ? AND pass = ? AND kind = ?";
        return !database.rows(sql, 1, row -> row.getInt(1), render.id(), plan.pass(), kind)
                .isEmpty();
    }

    /** The number of their plan within the render. */
    public int pass() {
        return pass;
    }

    /** The number of units without such samples, which are left out. */
    public long unitsWithout() throws IOException {
        String sql = "SELECT COUNT(*) FROM film_part p WHERE p.render_id = ? AND p.pass = ? AND NOT EXISTS (SELECT 1"
                + " FROM sample_block b WHERE b.render_id = p.render_id AND b.pass = p.pass AND b.tile = p.tile"
                + " AND b.kind = ?)";
        return database.rows(sql, 1, row -> row.getLong(1), render.id(), pass, kind)
                .get(0);
    }

    /** The number of damaged blocks, which are left out. */
    public long damaged() {
        return damaged;
    }

    /** Writes lines of values with commas between, under a line of names; returns how many samples. */
    public long writeCsv(Writer out) throws IOException {
        boolean hasRays = kind == SampleLog.RAYS;
        out.write("pass,tile,px,py,n," + String.join(",", REALS.subList(0, hasRays ? REALS.size() : OF_SAMPLES))
                + (hasRays ? ",outcome,bounces" : "") + "\n");
        StringBuilder line = new StringBuilder();
        Blocks blocks = new Blocks(database, render.id(), pass);
        blocks.read(kind, (tile, block) -> {
            int[] n = numbers.of(tile, block);
            for (int i = 0; i < block.size(); i++) {
                if (turnTo(block, i)) {
                    line.setLength(0);
                    line.append(pass).append(',').append(tile).append(',').append(column(block, i));
                    line.append(',').append(row(block, i)).append(',').append(n[i]);
                    for (int k = 0; k < (hasRays ? REALS.size() : OF_SAMPLES); k++) {
                        line.append(',');
                        append(line, k);
                    }
                    if (hasRays) {
                        line.append(',').append(outcome(block, i)).append(',').append(block.bounces(i));
                    }
                    out.append(line.append('\n'));
                    written++;
                }
            }
        });
        damaged = blocks.damaged();
        return written;
    }

    private void append(StringBuilder line, int which) {
        // Places are exact sums of a column and a float; colours and weights are floats.
        if (reals[which] == reals[which]) {
            line.append(
                    which >= 2 && which < OF_SAMPLES
                            ? Float.toString((float) reals[which])
                            : Double.toString(reals[which]));
        }
    }

    /** Fills the table {@code sample} of the store, in place of what it has of the render; returns how many samples. */
    public long fillTable() throws IOException {
        database.write(c -> {
            try (Statement statement = c.createStatement()) {
                statement.executeUpdate(Schema.samples(database.dialect()));
            }
            try (PreparedStatement delete = c.prepareStatement("DELETE FROM sample WHERE render_id = ?")) {
                delete.setString(1, render.id());
                delete.executeUpdate();
            }
            return null;
        });
        String insert = "INSERT INTO sample VALUES (?" + ", ?".repeat(COLUMNS - 1) + ")";
        Blocks blocks = new Blocks(database, render.id(), pass);
        blocks.read(kind, (tile, block) -> {
            int[] n = numbers.of(tile, block);
            written += database.write(c -> insert(c, insert, tile, block, n));
        });
        damaged = blocks.damaged();
        return written;
    }

    private long insert(Connection c, String sql, int tile, SampleBlock block, int[] n) throws SQLException {
        long rows = 0;
        try (PreparedStatement insert = c.prepareStatement(sql)) {
            int waiting = 0;
            for (int i = 0; i < block.size(); i++) {
                if (!turnTo(block, i)) {
                    continue;
                }
                set(insert, tile, block, i, n[i]);
                insert.addBatch();
                rows++;
                if (++waiting == BATCH) {
                    insert.executeBatch();
                    waiting = 0;
                }
            }
            if (waiting > 0) {
                insert.executeBatch();
            }
        }
        return rows;
    }

    private void set(PreparedStatement insert, int tile, SampleBlock block, int i, int n) throws SQLException {
        insert.setString(1, render.id());
        insert.setInt(2, pass);
        insert.setInt(3, tile);
        insert.setInt(4, column(block, i));
        insert.setInt(5, row(block, i));
        insert.setInt(6, n);
        int k = KEYS + 1;
        for (double real : reals) {
            if (real == real) {
                insert.setDouble(k++, real);
            } else {
                insert.setNull(k++, Types.DOUBLE);
            }
        }
        if (kind == SampleLog.RAYS) {
            insert.setString(k, outcome(block, i));
            insert.setInt(k + 1, block.bounces(i));
        } else {
            insert.setNull(k, Types.VARCHAR);
            insert.setNull(k + 1, Types.INTEGER);
        }
    }

    /** Turns to a sample; false for one of a pixel that the picture does not have. */
    private boolean turnTo(SampleBlock block, int i) {
        int pixel = block.pixel(i);
        if (pixel < 0 || pixel >= (long) render.width() * render.height()) {
            return false;
        }
        for (int k = 0; k < OF_SAMPLES; k++) {
            reals[k] = block.number(i, k);
        }
        reals[0] += column(block, i);
        reals[1] += row(block, i);
        for (int k = OF_SAMPLES; k < reals.length; k++) {
            reals[k] = kind == SampleLog.RAYS ? block.coordinate(i, k - OF_SAMPLES) : Double.NaN;
        }
        return true;
    }

    private int column(SampleBlock block, int i) {
        return block.pixel(i) % render.width();
    }

    private int row(SampleBlock block, int i) {
        return block.pixel(i) / render.width();
    }

    private static String outcome(SampleBlock block, int i) {
        return block.outcome(i)
                .map(o -> o.name().toLowerCase(Locale.ROOT).replace('_', ' '))
                .orElse("");
    }
}
