package enlightenment.store;

import enlightenment.text.Plain;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A connection to a store, which is made anew if it breaks. For one thread at a time. */
final class Database implements Closeable {
    /** The first bytes of a SQLite file; an empty file is one, too. */
    private static final byte[] MAGIC = "SQLite format 3\0".getBytes(StandardCharsets.US_ASCII);

    /** How often a transaction is tried that conflicts with others. */
    private static final int TRIES = 6;

    private static final long PAUSE_MILLIS = 50;
    private static final int LONGEST_REASON = 200;

    private final StoreAddress address;
    private final StoreLogin login;
    private final boolean writes;
    private final Drivers drivers;
    private final Dialect dialect;
    private Connection connection;

    private Database(StoreAddress address, StoreLogin login, boolean writes, Drivers drivers) {
        this.address = address;
        this.login = login;
        this.writes = writes;
        this.drivers = drivers;
        dialect = Dialect.of(address.scheme());
    }

    /** A piece of work with a connection. */
    @FunctionalInterface
    interface Work<T> {
        T run(Connection connection) throws SQLException, IOException;
    }

    /** Converts a row. */
    @FunctionalInterface
    interface RowReader<T> {
        T read(ResultSet row) throws SQLException;
    }

    /** Opens a store to read it: it must be there. */
    static Database toRead(StoreAddress address, StoreLogin login, Drivers drivers) throws IOException {
        return open(address, login, false, drivers);
    }

    /** Opens a store that must be there to add tables to it. */
    static Database toUnpack(StoreAddress address, StoreLogin login, Drivers drivers) throws IOException {
        toRead(address, login, drivers).close();
        return open(address, login, true, drivers);
    }

    /** Opens a store to write to it; makes it if there is none. */
    static Database toWrite(StoreAddress address, StoreLogin login, Drivers drivers) throws IOException {
        return open(address, login, true, drivers);
    }

    private static Database open(StoreAddress address, StoreLogin login, boolean writes, Drivers drivers)
            throws IOException {
        Database database = new Database(address, login, writes, drivers);
        database.checkFile();
        try {
            database.connect();
            boolean hasTables = database.read(c -> Schema.check(c, database.dialect, database.name()));
            if (!hasTables && !writes) {
                throw new StoreException(address.shown() + " holds no store");
            }
            if (!hasTables) {
                database.prepare();
            }
            return database;
        } catch (IOException | RuntimeException e) {
            database.close();
            throw e;
        }
    }

    private void prepare() throws IOException {
        write(c -> {
            Schema.create(c, dialect);
            return null;
        });
        if (Boolean.FALSE.equals(read(c -> Schema.check(c, dialect, name())))) {
            throw new StoreException(name() + ": the tables of the store could not be made");
        }
    }

    /** A file is looked at before any library parses it. */
    private void checkFile() throws IOException {
        if (address.file().isEmpty()) {
            return;
        }
        Path file = address.file().get();
        if (!Files.exists(file)) {
            if (!writes) {
                throw new StoreException(address.shown() + ": there is no such file");
            }
            return;
        }
        if (!Files.isRegularFile(file)) {
            throw new StoreException(address.shown() + " is no file");
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] start = in.readNBytes(MAGIC.length);
            if (start.length > 0 && !Arrays.equals(start, MAGIC)) {
                throw new StoreException(address.shown() + " is not a SQLite file: it is left as it is");
            }
        }
    }

    private void connect() throws IOException {
        String given = address.url().toUpperCase(java.util.Locale.ROOT);
        if (dialect == Dialect.H2 && given.matches(".*;WRITE_DELAY=0*[1-9].*")) {
            throw new StoreException("H2 loses what it has acknowledged with a WRITE_DELAY: leave it out of the URL");
        }
        try {
            connection = drivers.connect(address, dialect.url(address.url()), dialect.properties(login.properties()));
            if (dialect == Dialect.MARIADB) {
                // Locks of gaps between rows would let two writers wait for each other.
                connection.setTransactionIsolation(Connection.TRANSACTION_READ_COMMITTED);
            }
            connection.setAutoCommit(true);
            try (Statement statement = connection.createStatement()) {
                for (String line : dialect.greeting(writes)) {
                    statement.execute(line);
                }
            }
        } catch (SQLException e) {
            throw failed(e);
        }
    }

    Dialect dialect() {
        return dialect;
    }

    /** The name of the store in messages. */
    String name() {
        return address.shown();
    }

    /** Reads, each statement by itself; a connection that broke is made anew once. */
    <T> T read(Work<T> work) throws IOException {
        for (int k = 0; ; k++) {
            try {
                return work.run(open());
            } catch (SQLException e) {
                if (k > 0 || !isBroken(e)) {
                    throw failed(e);
                }
                drop();
            }
        }
    }

    /**
     * The rows of a query.
     *
     * @param most the largest number of rows
     * @param values of the query's parameters: texts and whole numbers
     */
    <T> List<T> rows(String sql, int most, RowReader<T> reader, Object... values) throws IOException {
        return read(c -> {
            List<T> rows = new ArrayList<>();
            try (PreparedStatement select = c.prepareStatement(sql)) {
                select.setMaxRows(most);
                for (int k = 0; k < values.length; k++) {
                    select.setObject(k + 1, values[k]);
                }
                try (ResultSet found = select.executeQuery()) {
                    while (rows.size() < most && found.next()) {
                        rows.add(reader.read(found));
                    }
                }
            }
            return rows;
        });
    }

    /** Does all of it or nothing; again if somebody else was in the way. */
    <T> T write(Work<T> work) throws IOException {
        for (int k = 1; ; k++) {
            try {
                return once(work);
            } catch (SQLException e) {
                boolean isBroken = isBroken(e);
                if (k == TRIES || !isBroken && !isConflict(e)) {
                    throw failed(e);
                }
                if (isBroken) {
                    drop();
                }
                pause(k);
            }
        }
    }

    private <T> T once(Work<T> work) throws SQLException, IOException {
        Connection c = open();
        c.setAutoCommit(false);
        T result;
        try {
            result = work.run(c);
            c.commit();
        } catch (SQLException | IOException | RuntimeException | Error e) {
            undo(c, e);
            throw e;
        }
        c.setAutoCommit(true);
        return result;
    }

    /**
     * Rolls a connection back for the next transaction, or drops it. SQLite on a full disk has rolled back by itself, and refuses to end
     * that transaction again. The first failure is the one that is reported.
     */
    private void undo(Connection c, Throwable failure) {
        try {
            if (!c.isClosed()) {
                c.rollback();
                c.setAutoCommit(true);
            }
        } catch (SQLException e) {
            failure.addSuppressed(e);
            drop();
        }
    }

    private Connection open() throws IOException, SQLException {
        if (connection == null || connection.isClosed()) {
            connect();
        }
        return connection;
    }

    private static void pause(int tries) throws StoreException {
        try {
            Thread.sleep(PAUSE_MILLIS * tries);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new StoreException("stopped while others were writing to the store", e);
        }
    }

    /** Whether the connection is gone: class 08 of the standard's states. */
    private static boolean isBroken(SQLException e) {
        return e.getSQLState() != null && e.getSQLState().startsWith("08");
    }

    /** Whether others were in the way: a deadlock, a row with the same key that they inserted meanwhile, or a busy SQLite file. */
    private static boolean isConflict(SQLException e) {
        String state = e.getSQLState() == null ? "" : e.getSQLState();
        return state.startsWith("40")
                || state.startsWith("23")
                || e instanceof java.sql.SQLIntegrityConstraintViolationException
                || e instanceof java.sql.SQLTransactionRollbackException
                || String.valueOf(e.getMessage()).contains("SQLITE_BUSY")
                || String.valueOf(e.getMessage()).contains("SQLITE_CONSTRAINT");
    }

    /** The failure as a line about this store. Drivers' messages are foreign texts, and might repeat the URL. */
    private StoreException failed(SQLException e) {
        String reason = String.valueOf(e.getMessage())
                .replace(address.url(), address.shown())
                .replaceAll("[\\r\\n]+", " ");
        String secret = login.password().orElse("");
        String told = secret.isEmpty() ? reason : reason.replace(secret, "...");
        return new StoreException(name() + ": " + Plain.line(told, LONGEST_REASON), e);
    }

    private void drop() {
        try {
            close();
        } catch (IOException e) {
            // It is gone.
        }
    }

    @Override
    public void close() throws IOException {
        if (connection == null) {
            return;
        }
        try {
            connection.close();
        } catch (SQLException e) {
            throw failed(e);
        } finally {
            connection = null;
        }
    }
}
