package enlightenment.store;

import java.io.IOException;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * A plan that a render was, or is, made by.
 *
 * @param pass its number within the render
 * @param data what it says
 * @param texts what the picture's file is to say of itself
 */
public record PlanRow(int pass, byte[] data, Map<String, String> texts) {
    /** No plan has more bytes, nor more beside it. */
    private static final int LONGEST = 4 << 20;

    static final int MOST = 1_000;

    /** The sound plans of a render, in their order. */
    static List<PlanRow> all(Database database, String render) throws IOException {
        return database.read(c -> all(c, database.dialect(), render));
    }

    private static List<PlanRow> all(Connection c, Dialect dialect, String render) throws SQLException {
        List<PlanRow> rows = new ArrayList<>();
        try (PreparedStatement select = c.prepareStatement("SELECT pass, crc, data, texts FROM render_plan"
                + " WHERE render_id = ? AND pass >= 0 AND pass < " + MOST + " AND " + dialect.length("data") + " <= "
                + LONGEST + " AND "
                + dialect.length("texts") + " <= " + LONGEST + " ORDER BY pass")) {
            select.setMaxRows(MOST);
            select.setString(1, render);
            try (ResultSet found = select.executeQuery()) {
                while (found.next()) {
                    byte[] data = found.getBytes(3);
                    byte[] texts = found.getBytes(4);
                    if (data != null && texts != null && Checksum.of(data) == found.getLong(2)) {
                        rows.add(new PlanRow(found.getInt(1), data, Texts.of(texts)));
                    }
                }
            }
        }
        return rows;
    }

    /** The number of a plan of a render: that which it has already, or the next. */
    static int numberOf(Database database, String render, byte[] plan, Map<String, String> texts) throws IOException {
        return database.write(c -> {
            for (PlanRow row : all(c, database.dialect(), render)) {
                if (Arrays.equals(row.data, plan)) {
                    return row.pass;
                }
            }
            int next = next(c, render);
            insert(c, render, next, plan, texts);
            return next;
        });
    }

    private static int next(Connection c, String render) throws SQLException {
        try (PreparedStatement select = c.prepareStatement("SELECT MAX(pass) FROM render_plan WHERE render_id = ?")) {
            select.setString(1, render);
            try (ResultSet row = select.executeQuery()) {
                row.next();
                int last = row.getInt(1);
                return row.wasNull() ? 0 : Math.addExact(last, 1);
            }
        }
    }

    private static void insert(Connection c, String render, int pass, byte[] plan, Map<String, String> texts)
            throws SQLException {
        try (PreparedStatement insert = c.prepareStatement(
                "INSERT INTO render_plan (render_id, pass, texts, crc, data) VALUES (?, ?, ?, ?, ?)")) {
            insert.setString(1, render);
            insert.setInt(2, pass);
            insert.setBytes(3, Texts.toBytes(texts));
            insert.setLong(4, Checksum.of(plan));
            insert.setBytes(5, plan);
            insert.executeUpdate();
        }
    }
}
