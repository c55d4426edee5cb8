package enlightenment.store;

import java.util.List;
import java.util.Properties;

/** The differences of databases. */
enum Dialect {
    SQLITE("BLOB"),
    MARIADB("LONGBLOB"),
    H2("BLOB"),
    POSTGRESQL("BYTEA"),
    /** Any other: what the standard says. */
    OTHER("BLOB");

    /** The type of columns that hold bytes. */
    final String blob;

    Dialect(String blob) {
        this.blob = blob;
    }

    static Dialect of(String scheme) {
        return switch (scheme) {
            case "sqlite" -> SQLITE;
            case "mariadb", "mysql" -> MARIADB;
            case "h2" -> H2;
            case "postgresql" -> POSTGRESQL;
            default -> OTHER;
        };
    }

    /** The URL to connect to. H2 gets an option that writes before it acknowledges: otherwise it loses acknowledged rows. */
    String url(String url) {
        return this == H2 && !url.toUpperCase(java.util.Locale.ROOT).contains(";WRITE_DELAY=")
                ? url + ";WRITE_DELAY=0"
                : url;
    }

    /** The driver's properties. */
    Properties properties(Properties login) {
        Properties all = new Properties();
        all.putAll(login);
        if (this == SQLITE) {
            // A transaction takes the lock for writing when it begins: two that take it in the middle would wait for
            // each other.
            all.setProperty("transaction_mode", "IMMEDIATE");
            all.setProperty("busy_timeout", "10000");
        }
        return all;
    }

    /** The statements that configure a new connection. */
    List<String> greeting(boolean writes) {
        if (this != SQLITE) {
            return List.of();
        }
        List<String> careful = List.of("PRAGMA trusted_schema=OFF", "PRAGMA cell_size_check=ON");
        return writes
                ? List.of(careful.get(0), careful.get(1), "PRAGMA journal_mode=WAL", "PRAGMA synchronous=FULL")
                : List.of(careful.get(0), careful.get(1), "PRAGMA query_only=ON");
    }

    /** The FROM clause of a SELECT of constants. */
    String fromNothing() {
        return this == MARIADB ? " FROM DUAL" : "";
    }

    /** The number of bytes of a column. */
    String length(String column) {
        return this == SQLITE || this == POSTGRESQL ? "LENGTH(" + column + ")" : "OCTET_LENGTH(" + column + ")";
    }
}
