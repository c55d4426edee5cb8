package enlightenment.store;

import java.io.File;
import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.sql.Connection;
import java.sql.Driver;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;

/**
 * Finds the driver of a database: on the class path or module path, and in {@code lib/*.jar} beside the program's own jar, or in the
 * folder of that jar if it is called {@code lib} itself. None is part of the program.
 */
final class Drivers {
    private static final String LIB = "lib";

    /** The Maven artifact of the driver, by kind of database. */
    private static final Map<String, String> ARTIFACTS = Map.of(
            "sqlite", "org.xerial:sqlite-jdbc:3.54.1.0",
            "mariadb", "org.mariadb.jdbc:mariadb-java-client:4.0.0",
            "mysql", "com.mysql:mysql-connector-j",
            "postgresql", "org.postgresql:postgresql:42.7.14",
            "h2", "com.h2database:h2:2.5.252");

    /** Folders with jars that may hold drivers. */
    private final List<Path> folders;

    Drivers(List<Path> folders) {
        this.folders = List.copyOf(folders);
    }

    /** The drivers beside this program. */
    static Drivers ofProgram() {
        return new Drivers(folders(Drivers.class.getProtectionDomain().getCodeSource()));
    }

    private static List<Path> folders(CodeSource source) {
        try {
            Path jar = source == null ? null : Path.of(source.getLocation().toURI());
            Path folder = jar == null || !Files.isRegularFile(jar) ? null : jar.getParent();
            if (folder == null) {
                return List.of();
            }
            Path name = folder.getFileName();
            return name != null && name.toString().equals(LIB)
                    ? List.of(folder.resolve(LIB), folder)
                    : List.of(folder.resolve(LIB));
        } catch (URISyntaxException | IllegalArgumentException | SecurityException e) {
            // A program that was loaded from elsewhere has no folder.
            return List.of();
        }
    }

    /**
     * Opens a connection.
     *
     * @throws StoreException if there is no driver; the message says what to fetch and where to put it
     * @throws SQLException if the database does not let us in
     */
    Connection connect(StoreAddress address, String url, Properties properties) throws IOException, SQLException {
        Connection connection = connect(services(Drivers.class.getClassLoader()), url, properties);
        if (connection == null) {
            URL[] jars = jars();
            // Stays open as long as the process: drivers load classes whenever they like.
            connection = jars.length == 0
                    ? null
                    : connect(services(new URLClassLoader(jars, Drivers.class.getClassLoader())), url, properties);
        }
        if (connection == null) {
            throw new StoreException(missing(address.scheme()));
        }
        return connection;
    }

    private static Connection connect(Iterable<Driver> drivers, String url, Properties properties) throws SQLException {
        for (Driver driver : drivers) {
            if (driver.acceptsURL(url)) {
                return driver.connect(url, properties);
            }
        }
        return null;
    }

    /** All drivers that can be loaded, without those that cannot. */
    private static List<Driver> services(ClassLoader loader) {
        if (Drivers.class.getModule().isNamed()) {
            // A module that said that it uses drivers could not be loaded where there is no java.sql.
            return DriverManager.drivers().toList();
        }
        List<Driver> all = new ArrayList<>();
        Iterator<Driver> drivers = ServiceLoader.load(Driver.class, loader).iterator();
        for (int failures = 0; failures < ARTIFACTS.size(); ) {
            try {
                if (!drivers.hasNext()) {
                    return all;
                }
                all.add(drivers.next());
            } catch (ServiceConfigurationError | LinkageError e) {
                // A class for a later Java, for instance.
                failures++;
            }
        }
        return all;
    }

    private URL[] jars() throws IOException {
        List<Path> jars = new ArrayList<>();
        for (Path folder : folders) {
            if (Files.isDirectory(folder)) {
                try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, "*.jar")) {
                    found.forEach(jars::add);
                }
            }
        }
        Collections.sort(jars);
        List<URL> urls = new ArrayList<>();
        for (Path jar : jars) {
            try {
                urls.add(jar.toUri().toURL());
            } catch (MalformedURLException e) {
                throw new StoreException(jar + ": cannot be loaded", e);
            }
        }
        return urls.toArray(new URL[0]);
    }

    private String missing(String scheme) {
        String artifact = ARTIFACTS.get(scheme);
        String folder =
                folders.isEmpty() ? LIB : folders.get(folders.size() - 1).toString();
        String place = folders.isEmpty() ? "onto the class path" : "into " + folder + File.separator;
        return "there is no JDBC driver for " + scheme + " here: put the jar of "
                + (artifact == null ? "its driver " : artifact + " ") + place
                + (artifact == null
                        ? ""
                        : " (mvn dependency:copy -Dartifact=" + artifact + " -DoutputDirectory=" + folder + ")");
    }
}
