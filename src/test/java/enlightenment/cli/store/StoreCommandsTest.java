package enlightenment.cli.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders into a store, and what comes out of it. */
class StoreCommandsTest extends SceneFixture {
    private Path store;
    private Path direct;

    StoreCommandsTest() {
        super(50, 34);
    }

    @BeforeEach
    void files() {
        store = folder.resolve("s.db");
        direct = folder.resolve("direct.png");
    }

    private static CliRun ok(Object... args) {
        CliRun run = CliRun.of(args);
        assertEquals(0, run.code(), run.err());
        return run;
    }

    private void assertRefused(int code, String words, Object... args) {
        CliRun run = CliRun.of(args);
        assertEquals(code, run.code(), run.err());
        assertTrue(run.err().contains(words), run.err());
    }

    private void assertSame(Path a, Path b) throws IOException {
        assertArrayEquals(Files.readAllBytes(a), Files.readAllBytes(b));
    }

    private static <T> T sql(Path file, String query) throws SQLException {
        try (Connection c = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = c.createStatement()) {
            if (!statement.execute(query)) {
                return null;
            }
            try (ResultSet result = statement.getResultSet()) {
                result.next();
                @SuppressWarnings("unchecked")
                T value = (T) result.getObject(1);
                return value;
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"raytrace,--store-rays", "raytrace,", "cluster,"})
    void aPictureFromTheStoreHasTheBytesOfTheRender(String method, String samples) throws IOException {
        ok("render", scene, "-o", direct, "--method", method, "--depth", 16);
        Object[] render = {"render", scene, "-o", picture, "--method", method, "--depth", 16, "--store", store};
        Object[] all = samples == null ? render : Arrays.copyOf(render, render.length + 1);
        all[all.length - 1] = samples == null ? all[all.length - 1] : samples;
        ok(all);
        assertSame(direct, picture);
        Path again = folder.resolve("again.png");
        assertEquals("", ok("render-store", store, "-o", again, "--depth", 16).err());
        assertSame(direct, again);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cornell-box", "glass-physical", "bounce"})
    void raysCostThePictureNotABit(String name) throws Exception {
        Path shipped = Path.of("scenes", name + ".json");
        ok("render", shipped, "-o", direct, "--size", "20x12", "--samples", 4);
        ok("render", shipped, "-o", picture, "--size", "20x12", "--samples", 4, "--store", store, "--store-rays");
        assertSame(direct, picture);
        ok("store-export", store, "--rows");
        assertEquals(20 * 12 * 4, (int) sql(store, "SELECT COUNT(*) FROM sample"));
        assertTrue((int) sql(store, "SELECT COUNT(*) FROM sample WHERE outcome = 'lit'") > 100);
        assertEquals(
                0,
                (int)
                        sql(
                                store,
                                "SELECT COUNT(*) FROM sample WHERE outcome IN ('lit', 'shadowed') AND (light_x IS NULL OR surface_x IS NULL)"));
    }

    @Test
    void aStoreThatCannotBeReadIsBlamedAndNotTheFileThatItIsUnpackedInto() throws Exception {
        ok("render", scene, "-o", picture, "--store", store, "--store-samples");
        sql(store, "UPDATE sample_block SET tile = 'x' WHERE tile = 1");
        sql(store, "UPDATE film_part SET tile = 'x' WHERE tile = 1");
        Path csv = folder.resolve("s.csv");
        CliRun run = CliRun.of("store-export", store, "--csv", csv);
        assertEquals(List.of("enlightenment: " + store + ": the numbers of its blocks are no numbers"), run.errLines());
        assertEquals(1, run.code());
        assertFalse(Files.exists(csv));
    }

    @Test
    void whatIsMissingIsBlackAndSaidAndIsAllThatIsRenderedNext() throws Exception {
        ok("render", scene, "-o", direct, "--store", store);
        int units = sql(store, "SELECT COUNT(*) FROM film_part");
        sql(store, "DELETE FROM film_part WHERE tile % 3 = 1");
        sql(store, "UPDATE film_part SET worker = 'before'");
        int left = sql(store, "SELECT COUNT(*) FROM film_part");
        assertRefused(
                1,
                "missing: " + (units - left) + " of " + units + " units; they are black",
                "render-store",
                store,
                "-o",
                picture);
        assertFalse(Arrays.equals(Files.readAllBytes(direct), Files.readAllBytes(picture)));
        CliRun info = ok("store-info", store);
        assertTrue(info.out().contains(left + " of " + units + " units"), info.out());
        assertTrue(info.out().contains("before: " + left + " units"), info.out());
        CliRun next = ok("render", scene, "-o", picture, "--store", store);
        assertTrue(next.err().contains(left + " of " + units + " units are kept"), next.err());
        assertSame(direct, picture);
        assertEquals(left, (int) sql(store, "SELECT COUNT(*) FROM film_part WHERE worker = 'before'"));
        assertEquals(units, (int) sql(store, "SELECT COUNT(*) FROM film_part"));
    }

    /** Whoever looks early finds a render, then its plan, and then its units. */
    @Test
    void aRenderThatHasNoPlanOrNoUnitYetIsNotBlamedOnAnotherVersion() throws Exception {
        ok("render", scene, "-o", direct, "--store", store);
        for (String table : List.of("film_part", "render_plan")) {
            sql(store, "DELETE FROM " + table);
            assertRefused(1, "nothing of the picture is in the store yet", "render-store", store, "-o", picture);
            assertFalse(Files.exists(picture));
        }
    }

    @Test
    void moreSamplesGoOnFromThoseThatAreThere() throws IOException {
        ok("render", scene, "-o", picture, "--samples", 4, "--store", store);
        ok("render", scene, "-o", picture, "--samples", 16, "--store", store);
        ok("render", scene, "-o", direct, "--samples", 16);
        assertSame(direct, picture);
        ok("render-store", store, "-o", picture);
        assertSame(direct, picture);
        assertTrue(ok("store-info", store).out().contains("pass 1: complete"));
    }

    @Test
    void severalRendersAreToldApartByTheirIds() throws Exception {
        ok("render", scene, "-o", direct, "--store", store);
        String first = sql(store, "SELECT id FROM render");
        ok("render", scene, "-o", picture, "--store", store, "--seed", 5);
        assertRefused(1, "holds 2 renders; say which", "render-store", store, "-o", picture);
        assertRefused(1, "begins with \"xyz\"", "render-store", store, "xyz", "-o", picture);
        ok("render-store", store, first.substring(0, 6), "-o", picture);
        assertSame(direct, picture);
        assertEquals(
                2,
                ok("store-info", store).outLines().stream()
                        .filter(l -> l.contains("50 x 34"))
                        .count());
    }

    @Test
    void aServerWritesWhatItsThreadsAndWorkersMade() throws Exception {
        ok("render", scene, "-o", direct);
        ok("server", scene, "-o", picture, "--port", 0, "--store", store);
        assertSame(direct, picture);
        ok("render-store", store, "-o", picture);
        assertSame(direct, picture);
        sql(store, "DELETE FROM film_part WHERE tile % 2 = 0");
        CliRun again = ok("server", scene, "-o", picture, "--port", 0, "--store", store);
        assertTrue(again.err().contains("tiles are done already"), again.err());
        assertSame(direct, picture);
        CliRun whole = ok("render", scene, "-o", picture, "--store", store);
        assertTrue(whole.err().contains("units are kept from before"), whole.err());
        assertSame(direct, picture);
    }

    @Test
    void checkpointAndStoreOfAServerGiveEachOtherWhatTheyHave() throws Exception {
        Path checkpoint = folder.resolve("server.checkpoint");
        ok("server", scene, "-o", direct, "--port", 0, "--checkpoint", checkpoint);
        ok("server", scene, "-o", picture, "--port", 0, "--checkpoint", checkpoint, "--store", store);
        ok("render-store", store, "-o", picture);
        assertSame(direct, picture);
        Files.delete(checkpoint);
        ok("server", scene, "-o", picture, "--port", 0, "--checkpoint", checkpoint, "--store", store);
        int units = (int) sql(store, "SELECT COUNT(*) FROM film_part");
        CliRun again = ok("server", scene, "-o", picture, "--port", 0, "--checkpoint", checkpoint);
        assertTrue(again.err().contains("checkpoint: " + units + " of " + units + " tiles are done"), again.err());
        assertSame(direct, picture);
    }

    @Test
    void samplesAreUnpackedAsLinesAndAsRows() throws Exception {
        ok("render", scene, "-o", picture, "--samples", 4, "--store", store, "--store-samples");
        Path csv = folder.resolve("samples.csv");
        ok("store-export", store, "--csv", csv);
        List<String> lines = Files.readAllLines(csv);
        assertEquals("pass,tile,px,py,n,x,y,r,g,b,w", lines.get(0));
        assertEquals(1 + 50 * 34 * 4, lines.size());
        ok("store-export", store, "--rows");
        ok("store-export", store, "--rows");
        assertEquals(50 * 34 * 4, (int) sql(store, "SELECT COUNT(*) FROM sample"));
        assertEquals(50 * 34, (int) sql(store, "SELECT COUNT(*) FROM sample WHERE n = 3"));
        assertEquals(0, (int)
                sql(store, "SELECT COUNT(*) FROM sample WHERE x < px OR x >= px + 1 OR y < py OR y >= py + 1"));
    }

    /** With so many samples a tile is made in several units. */
    @Test
    void theSamplesOfAPixelAreNumberedThroughAllPassesOverItsTile() throws Exception {
        int samples = 1 << 17;
        ok("render", scene, "-o", picture, "--size", "2x1", "--samples", samples, "--store", store, "--store-samples");
        assertTrue((int) sql(store, "SELECT COUNT(*) FROM film_part") > 1, "passes");
        Path csv = folder.resolve("samples.csv");
        ok("store-export", store, "--csv", csv);
        int[] next = new int[2];
        List<String> lines = Files.readAllLines(csv);
        for (String line : lines.subList(1, lines.size())) {
            String[] values = line.split(",");
            int pixel = Integer.parseInt(values[2]);
            assertEquals(next[pixel]++, Integer.parseInt(values[4]), line);
        }
        assertEquals(2 * samples, next[0] + next[1]);
        ok("store-export", store, "--rows");
        for (int pixel = 0; pixel < 2; pixel++) {
            String all = "FROM sample WHERE px = " + pixel;
            assertEquals(next[pixel], (int) sql(store, "SELECT COUNT(DISTINCT n) " + all));
            assertEquals(next[pixel] - 1, (int) sql(store, "SELECT MAX(n) " + all));
        }
    }

    @Test
    void samplesOfAnEarlierPassAreFoundWhereTheLastHasNone() throws Exception {
        ok("render", scene, "-o", picture, "--samples", "4", "--store", store, "--store-samples");
        ok("render", scene, "-o", picture, "--samples", "8", "--store", store);
        assertTrue(ok("store-export", store, "--rows").err().contains(", pass 0, unpacked"));
    }

    @Test
    void unitsWithoutTheSamplesThatAreWantedAreRenderedAgain() throws Exception {
        ok("render", scene, "-o", direct, "--store", store);
        assertRefused(1, "no samples of render", "store-export", store, "--rows");
        ok("render", scene, "-o", picture, "--store", store, "--store-rays");
        assertSame(direct, picture);
        assertEquals((int) sql(store, "SELECT SUM(samples) FROM film_part"), (int)
                sql(store, "SELECT SUM(n) FROM sample_block"));
        sql(store, "DELETE FROM sample_block WHERE tile % 2 = 0");
        assertTrue(ok("store-export", store, "--rows").err().contains("units were kept without them"));
        CliRun third = ok("render", scene, "-o", picture, "--store", store, "--store-samples");
        assertTrue(third.err().contains("units are kept from before"), third.err());
    }

    /** The empty tables take less than 20 pages of 4096 bytes, the rays of 50 x 34 pixels more. */
    @Test
    void aFullStoreCostsThePictureNothingAndIsToldOnceWithTheReason() throws IOException {
        ok("render", scene, "-o", direct, "--samples", 256);
        String full = "jdbc:sqlite:" + store + "?max_page_count=20";
        CliRun run = ok("render", scene, "-o", picture, "--samples", 256, "--store", full, "--store-rays");
        assertSame(direct, picture);
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(run.err().startsWith("enlightenment: store " + store + ": "), run.err());
        assertTrue(run.err().contains(": [SQLITE_FULL] "), run.err());
    }

    @Test
    void outputsAreNoInputsAndOptionsGoTogether() {
        ok("render", scene, "-o", direct, "--store", store);
        assertRefused(2, "the store", "store-export", store, "--csv", store);
        assertRefused(2, "the store", "store-export", store, "--csv", folder.resolve("s.db-wal"));
        assertRefused(2, "--store", "render", scene, "-o", picture, "--store", scene);
        assertRefused(2, "either --csv FILE or --rows", "store-export", store);
        assertRefused(2, "--store-rays needs --store", "render", scene, "-o", picture, "--store-rays");
        assertRefused(2, "need --store", "render", scene, "-o", picture, "--store-user", "me");
        assertRefused(
                2,
                "--store-rays: method cluster does not tell of its samples one by one; raytrace does",
                "render",
                scene,
                "-o",
                picture,
                "--store",
                store,
                "--store-rays",
                "--method",
                "cluster");
        assertRefused(
                2, "must not be given with --part", "render", scene, "-o", "a.film", "--part", "1/2", "--store", store);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "jdbc:mariadb://me:secret-word@h/db",
                "jdbc:mariadb://h/db?user=me&password=secret-word",
                "jdbc:h2:/x;USER=a;PASSWORD=secret-word",
                "jdbc:mysql://address=(host=h)(password=secret-word)/db"
            })
    void aPasswordInTheUrlIsRefusedAndNotRepeated(String url) {
        CliRun run = CliRun.of("render", scene, "-o", picture, "--store", url);
        assertEquals(2, run.code(), run.err());
        assertTrue(run.err().contains("ENLIGHTENMENT_STORE_PASSWORD"), run.err());
        assertFalse(run.err().contains("secret-word"), run.err());
    }

    @Test
    void aMissingDriverIsNamedWithWhereToGetIt() {
        assertRefused(
                1,
                "no JDBC driver for postgresql here: put the jar of org.postgresql:postgresql:",
                "store-info",
                "jdbc:postgresql://h/db?secret=1");
        assertRefused(1, "there is no such file", "store-info", store);
        assertFalse(Files.exists(store));
    }
}
