package enlightenment.store;

import java.io.IOException;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.util.ArrayList;
import java.util.List;

/** Reads results of a plan from the store, in the order of units, a few at a time. */
final class Parts {
    /** No result of a unit is longer: what is, is not looked at. */
    static final long LONGEST = 64L << 20;

    /** The largest number of rows in one query, and of bytes. */
    private static final int PAGE = 1 << 10;

    private static final long PAGE_BYTES = 4L << 20;

    private final Database database;
    private final String render;
    private final int pass;

    /** Only those with samples of this kind or a later one; -1 for all. */
    private final int kind;

    private long damaged;

    Parts(Database database, String render, int pass, int kind) {
        this.database = database;
        this.render = render;
        this.pass = pass;
        this.kind = kind;
    }

    /** Receives a result. */
    @FunctionalInterface
    interface Taker {
        void take(int tile, byte[] data) throws IOException;
    }

    /** The key of a row, and how long it is. */
    private record Row(int tile, long bytes) {}

    /** The number of results left out: damaged, or longer than any result. */
    long damaged() {
        return damaged;
    }

    /** Passes all undamaged results to a receiver. */
    void read(Taker taker) throws IOException {
        long after = -1;
        while (true) {
            List<Row> rows = page(after);
            int from = 0;
            while (from < rows.size()) {
                int to = from;
                long bytes = 0;
                do {
                    bytes += Math.min(rows.get(to++).bytes, LONGEST);
                } while (to < rows.size() && bytes + rows.get(to).bytes <= PAGE_BYTES);
                read(rows.get(from).tile, rows.get(to - 1).tile, to - from, taker);
                from = to;
            }
            if (rows.size() < PAGE) {
                return;
            }
            long last = rows.get(rows.size() - 1).tile;
            if (last <= after) {
                throw new StoreException(database.name() + ": the numbers of its units are no numbers");
            }
            after = last;
        }
    }

    private String condition() {
        return "FROM film_part p WHERE p.render_id = ? AND p.pass = ?"
                + (kind < 0
                        ? ""
                        : " AND EXISTS (SELECT 1 FROM sample_block b WHERE b.render_id = p.render_id"
                                + " AND b.pass = p.pass AND b.tile = p.tile AND b.kind >= " + kind + ")");
    }

    private List<Row> page(long after) throws IOException {
        String sql = "SELECT p.tile, " + database.dialect().length("p.data") + " " + condition()
                + " AND p.tile > ? ORDER BY p.tile";
        return database.rows(
                sql, PAGE, row -> new Row(row.getInt(1), Math.max(row.getLong(2), 0)), render, pass, after);
    }

    /** A piece of a page, whose rows are known to be short enough together. */
    private void read(int first, int last, int count, Taker taker) throws IOException {
        String sql = "SELECT p.tile, p.crc, p.data " + condition() + " AND p.tile >= ? AND p.tile <= ? AND "
                + database.dialect().length("p.data") + " <= " + LONGEST + " ORDER BY p.tile";
        List<Integer> tiles = new ArrayList<>();
        List<byte[]> all = new ArrayList<>();
        database.read(c -> {
            tiles.clear();
            all.clear();
            try (PreparedStatement select = c.prepareStatement(sql)) {
                select.setString(1, render);
                select.setInt(2, pass);
                select.setInt(3, first);
                select.setInt(4, last);
                try (ResultSet found = select.executeQuery()) {
                    while (found.next()) {
                        byte[] data = found.getBytes(3);
                        if (data != null && Checksum.of(data) == found.getLong(2)) {
                            tiles.add(found.getInt(1));
                            all.add(data);
                        }
                    }
                }
            }
            return null;
        });
        damaged += Math.max(count - all.size(), 0);
        for (int i = 0; i < all.size(); i++) {
            taker.take(tiles.get(i), all.get(i));
        }
    }
}
