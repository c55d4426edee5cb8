package enlightenment.store;

import enlightenment.film.SampleBlock;
import enlightenment.film.SampleLog;
import java.io.IOException;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.util.List;
import java.util.Optional;

/** Reads blocks of samples from the store, one after the other, in the order of units. */
final class Blocks {
    /** The number of keys in one query. */
    private static final int PAGE = 1 << 10;

    private final Database database;
    private final String render;
    private final int pass;
    private long damaged;

    Blocks(Database database, String render, int pass) {
        this.database = database;
        this.render = render;
        this.pass = pass;
    }

    /** The key of a row, and what it says of itself. */
    private record Row(int tile, int piece, int samples, long bytes) {}

    /** Receives a block. */
    @FunctionalInterface
    interface Taker {
        void take(int tile, SampleBlock block) throws IOException;
    }

    /** The number of blocks left out: damaged, or with wrong counts. */
    long damaged() {
        return damaged;
    }

    /** Passes all undamaged blocks of a kind, whose units are there, to a receiver. */
    void read(int kind, Taker taker) throws IOException {
        int tile = -1;
        int piece = -1;
        while (true) {
            List<Row> rows = page(kind, tile, piece);
            for (Row row : rows) {
                if (row.tile < tile || row.tile == tile && row.piece <= piece) {
                    throw new StoreException(database.name() + ": the numbers of its blocks are no numbers");
                }
                tile = row.tile;
                piece = row.piece;
                Optional<SampleBlock> block = block(kind, row);
                if (block.isPresent()) {
                    taker.take(tile, block.get());
                } else {
                    damaged++;
                }
            }
            if (rows.size() < PAGE) {
                return;
            }
        }
    }

    private List<Row> page(int kind, int tile, int piece) throws IOException {
        String sql = "SELECT b.tile, b.piece, b.n, " + database.dialect().length("b.data") + " FROM sample_block b"
                + " WHERE b.render_id = ? AND b.pass = ? AND b.kind = ? AND b.tile >= ?"
                + " AND (b.tile > ? OR b.piece > ?) AND EXISTS (SELECT 1 FROM film_part p"
                + " WHERE p.render_id = b.render_id AND p.pass = b.pass AND p.tile = b.tile)"
                + " ORDER BY b.tile, b.piece";
        return database.rows(
                sql,
                PAGE,
                row -> new Row(row.getInt(1), row.getInt(2), row.getInt(3), row.getLong(4)),
                render,
                pass,
                kind,
                tile,
                tile,
                piece);
    }

    private Optional<SampleBlock> block(int kind, Row row) throws IOException {
        if (SampleBlock.problem(kind, row.samples, row.bytes).isPresent()) {
            return Optional.empty();
        }
        return database.read(c -> {
            try (PreparedStatement select = c.prepareStatement("SELECT crc, data FROM sample_block WHERE "
                    + Place.CONDITION + " AND kind = ? AND piece = ? AND "
                    + database.dialect().length("data") + " = "
                    + (long) row.samples * SampleLog.bytesPerSample(kind))) {
                int k = new Place(render, pass, row.tile).set(select, 1);
                select.setInt(k, kind);
                select.setInt(k + 1, row.piece);
                try (ResultSet found = select.executeQuery()) {
                    byte[] data = found.next() ? found.getBytes(2) : null;
                    boolean isSound = data != null
                            && Checksum.of(data) == found.getLong(1)
                            && SampleBlock.problem(kind, row.samples, data.length)
                                    .isEmpty();
                    return isSound ? Optional.of(SampleBlock.of(kind, row.samples, data)) : Optional.empty();
                }
            }
        });
    }
}
