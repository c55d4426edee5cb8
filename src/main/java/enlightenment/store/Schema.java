package enlightenment.store;

import java.sql.Connection;
import java.sql.DatabaseMetaData;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;

/** The tables of a store, and whether a database has them. docs/guide/sample-store.md has what the columns mean. */
final class Schema {
    /** The version that is written; a newer one is refused. */
    static final int VERSION = 1;

    private static final String VERSIONS = "store_version";

    private Schema() {}

    private static List<String> tables(Dialect dialect) {
        String blob = dialect.blob;
        return List.of(
                "CREATE TABLE IF NOT EXISTS store_version (version INT NOT NULL PRIMARY KEY)",
                "CREATE TABLE IF NOT EXISTS render (id VARCHAR(64) NOT NULL PRIMARY KEY, name VARCHAR(200) NOT NULL,"
                        + " scene " + blob
                        + " NOT NULL, settings VARCHAR(4000) NOT NULL, program VARCHAR(100) NOT NULL,"
                        + " width INT NOT NULL, height INT NOT NULL, created VARCHAR(32) NOT NULL)",
                "CREATE TABLE IF NOT EXISTS render_plan (render_id VARCHAR(64) NOT NULL, pass INT NOT NULL,"
                        + " texts " + blob + " NOT NULL, crc BIGINT NOT NULL, data " + blob
                        + " NOT NULL, PRIMARY KEY (render_id, pass))",
                "CREATE TABLE IF NOT EXISTS film_part (render_id VARCHAR(64) NOT NULL, pass INT NOT NULL,"
                        + " tile INT NOT NULL, samples BIGINT NOT NULL, worker VARCHAR(100) NOT NULL,"
                        + " crc BIGINT NOT NULL, data " + blob + " NOT NULL, PRIMARY KEY (render_id, pass, tile))",
                "CREATE TABLE IF NOT EXISTS sample_block (render_id VARCHAR(64) NOT NULL, pass INT NOT NULL,"
                        + " tile INT NOT NULL, kind INT NOT NULL, piece INT NOT NULL, n INT NOT NULL,"
                        + " crc BIGINT NOT NULL, data " + blob
                        + " NOT NULL, PRIMARY KEY (render_id, pass, tile, kind, piece))");
    }

    /** The columns of the table that {@code store-export --rows} fills. */
    static String samples(Dialect dialect) {
        String real = dialect == Dialect.POSTGRESQL || dialect == Dialect.H2 ? "DOUBLE PRECISION" : "DOUBLE";
        StringBuilder columns = new StringBuilder("CREATE TABLE IF NOT EXISTS sample (render_id VARCHAR(64) NOT NULL,"
                + " pass INT NOT NULL, tile INT NOT NULL, px INT NOT NULL, py INT NOT NULL, n INT NOT NULL");
        for (String name : SampleRows.REALS) {
            columns.append(", ").append(name).append(' ').append(real);
        }
        return columns + ", outcome VARCHAR(16), bounces INT)";
    }

    /** Makes the tables and indices that are missing. */
    static void create(Connection connection, Dialect dialect) throws SQLException {
        try (Statement statement = connection.createStatement()) {
            for (String table : tables(dialect)) {
                statement.executeUpdate(table);
            }
            statement.executeUpdate("INSERT INTO store_version SELECT " + VERSION + dialect.fromNothing()
                    + " WHERE NOT EXISTS (SELECT 1 FROM store_version)");
        }
    }

    /** Whether a table is there, by whatever capital letters. */
    static boolean has(Connection connection, String table) throws SQLException {
        DatabaseMetaData data = connection.getMetaData();
        for (String name : List.of(table, table.toUpperCase(java.util.Locale.ROOT))) {
            try (ResultSet found = data.getTables(connection.getCatalog(), null, name, null)) {
                while (found.next()) {
                    if (table.equalsIgnoreCase(found.getString("TABLE_NAME"))) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /**
     * Whether it is a store that this program can use.
     *
     * @return false if there is no store in the database
     * @throws StoreException if there is one that it cannot use, or something else where it would have to be
     */
    static boolean check(Connection connection, Dialect dialect, String name) throws SQLException, StoreException {
        if (dialect == Dialect.SQLITE) {
            checkFile(connection, name);
        }
        if (!has(connection, VERSIONS)) {
            return false;
        }
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT MAX(version) FROM store_version")) {
            int version = result.next() ? result.getInt(1) : 0;
            if (version > VERSION) {
                throw new StoreException(name + " is a store of version " + version
                        + ", made by a newer program; this one knows version " + VERSION + ": it is left as it is");
            }
            return version == VERSION;
        }
    }

    /** A file may come from anybody: there is to be nothing in it that runs, or stands in for a table. */
    private static void checkFile(Connection connection, String name) throws SQLException, StoreException {
        boolean isStore = false;
        boolean isEmpty = true;
        try (Statement statement = connection.createStatement();
                ResultSet entries = statement.executeQuery("SELECT type, name, tbl_name FROM sqlite_master")) {
            while (entries.next()) {
                isEmpty = false;
                String type = String.valueOf(entries.getString(1));
                String what = String.valueOf(entries.getString(2));
                isStore |= type.equals("table") && what.equalsIgnoreCase(VERSIONS);
                if (type.equals("trigger")) {
                    throw new StoreException(
                            name + " has triggers, which no store has and which would run here: it is left as it is");
                }
                if (type.equals("view") && OWN.contains(what.toLowerCase(java.util.Locale.ROOT))) {
                    throw new StoreException(name + " has a view where a store has a table: it is left as it is");
                }
            }
        }
        if (!isEmpty && !isStore) {
            throw new StoreException(name + " is a SQLite file of something else, no store: it is left as it is");
        }
    }

    private static final List<String> OWN =
            List.of(VERSIONS, "render", "render_plan", "film_part", "sample_block", "sample");
}
