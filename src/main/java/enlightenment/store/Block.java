package enlightenment.store;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;

/**
 * Samples of a unit on their way into the store.
 *
 * @param kind what is kept of them
 * @param piece which block of the unit it is
 * @param samples how many they are
 */
record Block(Place place, int kind, int piece, int samples, byte[] data) {
    private static final String CONDITION = Place.CONDITION + " AND kind = ? AND piece = ?";

    /** Inserts it. Samples whose unit is not in the store yet belong to no result, and are replaced. */
    void insert(Connection c, Dialect dialect) throws SQLException, StoreException {
        if (tryInsert(c, dialect) || exists(c)) {
            return;
        }
        if (hasPart(c)) {
            throw new StoreException("the samples of " + place + " are in the store already with other numbers:"
                    + " one of the two machines computes wrongly");
        }
        try (PreparedStatement delete = c.prepareStatement("DELETE FROM sample_block WHERE " + CONDITION)) {
            set(delete, 1);
            delete.executeUpdate();
        }
        tryInsert(c, dialect);
    }

    private int set(PreparedStatement statement, int first) throws SQLException {
        int k = place.set(statement, first);
        statement.setInt(k, kind);
        statement.setInt(k + 1, piece);
        return k + 2;
    }

    private boolean tryInsert(Connection c, Dialect dialect) throws SQLException {
        try (PreparedStatement insert =
                c.prepareStatement("INSERT INTO sample_block (render_id, pass, tile, kind, piece, n, crc, data)"
                        + " SELECT ?, ?, ?, ?, ?, ?, ?, ?" + dialect.fromNothing()
                        + " WHERE NOT EXISTS (SELECT 1 FROM sample_block WHERE " + CONDITION + ")")) {
            int k = set(insert, 1);
            insert.setInt(k++, samples);
            insert.setLong(k++, Checksum.of(data));
            insert.setBytes(k++, data);
            set(insert, k);
            return insert.executeUpdate() > 0;
        }
    }

    /** Whether the same is there. */
    private boolean exists(Connection c) throws SQLException {
        try (PreparedStatement select = c.prepareStatement("SELECT n, crc FROM sample_block WHERE " + CONDITION)) {
            set(select, 1);
            try (ResultSet row = select.executeQuery()) {
                return row.next() && row.getInt(1) == samples && row.getLong(2) == Checksum.of(data);
            }
        }
    }

    private boolean hasPart(Connection c) throws SQLException {
        try (PreparedStatement select = c.prepareStatement("SELECT 1 FROM film_part WHERE " + Place.CONDITION)) {
            place.set(select, 1);
            try (ResultSet row = select.executeQuery()) {
                return row.next();
            }
        }
    }
}
