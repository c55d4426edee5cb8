package enlightenment.store;

import enlightenment.text.Plain;
import java.io.IOException;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;

/**
 * A render that is in a store, or is to be.
 *
 * @param id tells it from all others: what it is of, how, and by which version of the program; 64 hexadecimal digits
 * @param name the scene's name
 * @param settings the settings that matter, in words
 * @param program the version of the program
 * @param width columns of the whole picture
 * @param height rows of the whole picture
 * @param created when it was begun, in UTC
 */
public record RenderRow(
        String id, String name, String settings, String program, int width, int height, String created) {
    private static final int LONGEST_NAME = 200;
    private static final int LONGEST_SETTINGS = 4_000;
    private static final int LONGEST_PROGRAM = 100;
    private static final int LONGEST_CREATED = 32;

    /** More than these are not listed. */
    static final int MOST = 10_000;

    /** A scene with more bytes is not kept beside its picture. */
    static final int LARGEST_SCENE = 8 << 20;

    /** A render that begins now. */
    public static RenderRow now(String id, String name, String settings, String program, int width, int height) {
        String now = Instant.now().truncatedTo(ChronoUnit.SECONDS).toString();
        return new RenderRow(id, name, settings, program, width, height, now);
    }

    /** Inserts it, where it is not there yet. */
    void insert(Connection c, Dialect dialect, byte[] scene) throws SQLException {
        try (PreparedStatement insert =
                c.prepareStatement("INSERT INTO render (id, name, scene, settings, program, width, height, created)"
                        + " SELECT ?, ?, ?, ?, ?, ?, ?, ?" + dialect.fromNothing()
                        + " WHERE NOT EXISTS (SELECT 1 FROM render WHERE id = ?)")) {
            insert.setString(1, id);
            insert.setString(2, Plain.line(name, LONGEST_NAME));
            insert.setBytes(3, scene.length > LARGEST_SCENE ? new byte[0] : scene);
            insert.setString(4, Plain.line(settings, LONGEST_SETTINGS));
            insert.setString(5, Plain.line(program, LONGEST_PROGRAM));
            insert.setInt(6, width);
            insert.setInt(7, height);
            insert.setString(8, created);
            insert.setString(9, id);
            insert.executeUpdate();
        }
    }

    /** All renders of a store, the oldest first. */
    static List<RenderRow> all(Database database) throws IOException {
        String short0 = "SUBSTR(id, 1, 64), SUBSTR(name, 1, " + LONGEST_NAME + "), SUBSTR(settings, 1, "
                + LONGEST_SETTINGS + "), SUBSTR(program, 1, " + LONGEST_PROGRAM
                + "), width, height, SUBSTR(created, 1, "
                + LONGEST_CREATED + ")";
        return database.rows("SELECT " + short0 + " FROM render ORDER BY created, id", MOST, RenderRow::row);
    }

    /** Texts of a row may come from anybody. */
    private static RenderRow row(ResultSet row) throws SQLException {
        return new RenderRow(
                plain(row.getString(1), 2 * LONGEST_CREATED),
                plain(row.getString(2), LONGEST_NAME),
                plain(row.getString(3), LONGEST_SETTINGS),
                plain(row.getString(4), LONGEST_PROGRAM),
                row.getInt(5),
                row.getInt(6),
                plain(row.getString(7), LONGEST_CREATED));
    }

    private static String plain(String text, int most) {
        return Plain.line(String.valueOf(text), most);
    }
}
