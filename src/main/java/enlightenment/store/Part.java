package enlightenment.store;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.Arrays;
import java.util.Optional;

/**
 * A result of a unit on its way into the store.
 *
 * @param samples how many camera rays are in it
 * @param worker who made it
 */
record Part(Place place, long samples, String worker, byte[] data) {
    static final int LONGEST_WORKER = 100;

    /**
     * Inserts it, where it is not there yet.
     *
     * @param isSuspect whether what is there instead has been judged already, and is of no use
     * @throws StoreException if another result is there
     */
    void insert(Connection c, Dialect dialect, boolean isSuspect) throws SQLException, StoreException {
        if (tryInsert(c, dialect)) {
            return;
        }
        Optional<byte[]> there = sound(c, dialect, place);
        if (there.isPresent() && Arrays.equals(there.get(), data)) {
            return;
        }
        if (there.isPresent() && !isSuspect) {
            if (!startAlike(there.get(), data)) {
                throw new StoreException(place + " is in the store already, by another worker, with other numbers:"
                        + " one of the two machines computes wrongly");
            }
            if (there.get().length > data.length) {
                return;
            }
        }
        delete(c, "film_part", place);
        tryInsert(c, dialect);
    }

    /** One may say more than the other, from which more samples go on. */
    private static boolean startAlike(byte[] a, byte[] b) {
        int common = Math.min(a.length, b.length);
        return Arrays.equals(a, 0, common, b, 0, common);
    }

    private boolean tryInsert(Connection c, Dialect dialect) throws SQLException {
        try (PreparedStatement insert =
                c.prepareStatement("INSERT INTO film_part (render_id, pass, tile, samples, worker, crc, data)"
                        + " SELECT ?, ?, ?, ?, ?, ?, ?" + dialect.fromNothing()
                        + " WHERE NOT EXISTS (SELECT 1 FROM film_part WHERE " + Place.CONDITION + ")")) {
            int k = place.set(insert, 1);
            insert.setLong(k++, samples);
            insert.setString(k++, worker.substring(0, Math.min(worker.length(), LONGEST_WORKER)));
            insert.setLong(k++, Checksum.of(data));
            insert.setBytes(k++, data);
            place.set(insert, k);
            return insert.executeUpdate() > 0;
        }
    }

    /** The result of a unit, unless it is missing or damaged. */
    static Optional<byte[]> sound(Connection c, Dialect dialect, Place place) throws SQLException {
        try (PreparedStatement select = c.prepareStatement("SELECT crc, data FROM film_part WHERE " + Place.CONDITION
                + " AND " + dialect.length("data") + " <= " + Parts.LONGEST)) {
            place.set(select, 1);
            try (ResultSet row = select.executeQuery()) {
                if (!row.next()) {
                    return Optional.empty();
                }
                byte[] bytes = row.getBytes(2);
                return bytes != null && Checksum.of(bytes) == row.getLong(1) ? Optional.of(bytes) : Optional.empty();
            }
        }
    }

    /** Deletes a result, with its samples. */
    static void delete(Connection c, Place place) throws SQLException {
        deleteResult(c, place);
        delete(c, "sample_block", place);
    }

    /**
     * Deletes the results of one worker, with their samples.
     *
     * @param any the place of a unit of that plan
     */
    static void deleteOf(Connection c, Place any, String worker) throws SQLException {
        String theirs = " WHERE render_id = ? AND pass = ? AND ";
        try (PreparedStatement blocks = c.prepareStatement("DELETE FROM sample_block" + theirs
                        + "tile IN (SELECT tile FROM film_part" + theirs + "worker = ?)");
                PreparedStatement parts = c.prepareStatement("DELETE FROM film_part" + theirs + "worker = ?")) {
            String name = worker.substring(0, Math.min(worker.length(), LONGEST_WORKER));
            blocks.setString(1, any.render());
            blocks.setInt(2, any.pass());
            blocks.setString(3, any.render());
            blocks.setInt(4, any.pass());
            blocks.setString(5, name);
            blocks.executeUpdate();
            parts.setString(1, any.render());
            parts.setInt(2, any.pass());
            parts.setString(3, name);
            parts.executeUpdate();
        }
    }

    /** Deletes a result, but not its samples. */
    static void deleteResult(Connection c, Place place) throws SQLException {
        delete(c, "film_part", place);
    }

    private static void delete(Connection c, String table, Place place) throws SQLException {
        try (PreparedStatement delete = c.prepareStatement("DELETE FROM " + table + " WHERE " + Place.CONDITION)) {
            place.set(delete, 1);
            delete.executeUpdate();
        }
    }
}
