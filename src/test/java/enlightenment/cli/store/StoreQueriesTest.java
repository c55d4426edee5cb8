package enlightenment.cli.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Samples and rays of two balls under a lamp, unpacked, against what is known of that scene; and the queries of docs/guide/sample-store.md. */
class StoreQueriesTest {
    private static final Path PAGE = Path.of("docs/guide/sample-store.md");
    private static final Pattern QUERY = Pattern.compile("(?ms)^```sql$(.*?)^```$");

    /** What rounding makes of points on surfaces, in units of the scene: generously. */
    private static final double NEAR = 1e-9;

    @TempDir
    private static Path folder;

    private static Connection connection;

    @BeforeAll
    static void render() throws IOException, SQLException {
        Path scene = CliRun.scene(folder, "\"width\": 50, \"height\": 34");
        Path store = folder.resolve("s.db");
        CliRun run = CliRun.of(
                "render", scene, "-o", folder.resolve("p.pfm"), "--samples", 8, "--store", store, "--store-rays");
        assertEquals(0, run.code(), run.err());
        assertEquals(0, CliRun.of("store-export", store, "--rows").code());
        connection = DriverManager.getConnection("jdbc:sqlite:" + store);
    }

    @AfterAll
    static void close() throws SQLException {
        connection.close();
    }

    private static double number(String query) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery(query)) {
            assertTrue(result.next());
            return result.getDouble(1);
        }
    }

    @Test
    void everyQueryOfThePageRunsAndFindsSomething() throws IOException, SQLException {
        String id;
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT id FROM render")) {
            result.next();
            id = result.getString(1);
        }
        List<String> queries = QUERY.matcher(Files.readString(PAGE))
                .results()
                .map(m -> m.group(1))
                .toList();
        assertTrue(queries.size() >= 6, queries.size() + " queries");
        for (String query : queries) {
            try (Statement statement = connection.createStatement();
                    ResultSet result = statement.executeQuery(
                            query.trim().replace(";", "").replace("ID%", id.substring(0, 8) + "%"))) {
                assertTrue(result.next(), query);
                assertTrue(result.getObject(1) != null, query);
            }
        }
    }

    @Test
    void theMeanOfAPixelsSamplesIsItsColour() throws IOException, SQLException {
        Image picture = ImageFiles.read(folder.resolve("p.pfm"));
        float[] rgb = picture.toArray();
        try (Statement statement = connection.createStatement();
                ResultSet pixel = statement.executeQuery(
                        "SELECT px, py, SUM(w * r) / SUM(w), SUM(w * g) / SUM(w), SUM(w * b) / SUM(w), COUNT(*)"
                                + " FROM sample GROUP BY px, py")) {
            int pixels = 0;
            while (pixel.next()) {
                int k = 3 * (50 * pixel.getInt(2) + pixel.getInt(1));
                for (int c = 0; c < 3; c++) {
                    assertEquals(rgb[k + c], pixel.getDouble(3 + c), 1e-6);
                }
                assertEquals(8, pixel.getInt(6));
                pixels++;
            }
            assertEquals(50 * 34, pixels);
        }
    }

    /** S lies on a ball, L in the lamp, P before the eye; and whether something is between S and L is told by the closest approach. */
    @Test
    void raysAreWhatTheSceneSays() throws SQLException {
        int lit = 0;
        int shadowed = 0;
        try (Statement statement = connection.createStatement();
                ResultSet ray = statement.executeQuery(
                        "SELECT outcome, surface_x, surface_y, surface_z, light_x, light_y,"
                                + " light_z, window_x, window_y, window_z FROM sample WHERE outcome IN ('lit', 'shadowed')")) {
            while (ray.next()) {
                double[] s = {ray.getDouble(2), ray.getDouble(3), ray.getDouble(4)};
                double[] l = {ray.getDouble(5), ray.getDouble(6), ray.getDouble(7)};
                double[] p = {ray.getDouble(8), ray.getDouble(9), ray.getDouble(10)};
                boolean onBall = Math.abs(distance(s, 0, 0, 0) - 1) < NEAR;
                boolean onFloor = Math.abs(distance(s, 0, -101, 0) - 100) < 100 * NEAR;
                assertTrue(onBall || onFloor);
                assertTrue(distance(l, 2, 3, -2) < 0.5 + NEAR);
                assertEquals(0, offLine(p, s), NEAR * distance(s, 0, 0, -5));
                boolean isLit = ray.getString(1).equals("lit");
                lit += isLit ? 1 : 0;
                shadowed += isLit ? 0 : 1;
                if (onFloor && !onBall) {
                    double gap = closest(s, l) - 1;
                    assertTrue(Math.abs(gap) < 1e-6 || isLit == gap > 0, gap + " " + isLit);
                }
            }
        }
        assertTrue(lit > 1000 && shadowed > 100, lit + " lit, " + shadowed + " shadowed");
        assertEquals(0, number("SELECT COUNT(*) FROM sample WHERE outcome = 'missed' AND surface_x IS NOT NULL"));
        assertEquals(0, number("SELECT COUNT(*) FROM sample WHERE bounces <> 0"));
    }

    private static double distance(double[] a, double x, double y, double z) {
        return Math.sqrt((a[0] - x) * (a[0] - x) + (a[1] - y) * (a[1] - y) + (a[2] - z) * (a[2] - z));
    }

    /** How far S is from the line through the eye and P. */
    private static double offLine(double[] p, double[] s) {
        double[] d = {p[0], p[1], p[2] + 5};
        double[] e = {s[0], s[1], s[2] + 5};
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        double x = (d[1] * e[2] - d[2] * e[1]) / length;
        double y = (d[2] * e[0] - d[0] * e[2]) / length;
        double z = (d[0] * e[1] - d[1] * e[0]) / length;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** How near the segment comes to the middle of the ball. */
    private static double closest(double[] s, double[] l) {
        double dd = 0;
        double sd = 0;
        for (int i = 0; i < 3; i++) {
            dd += (l[i] - s[i]) * (l[i] - s[i]);
            sd -= s[i] * (l[i] - s[i]);
        }
        double t = Math.min(Math.max(sd / dd, 0), 1);
        double[] q = new double[3];
        for (int i = 0; i < 3; i++) {
            q[i] = s[i] + t * (l[i] - s[i]);
        }
        return distance(q, 0, 0, 0);
    }
}
