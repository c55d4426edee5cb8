package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that are no stores, or stores that somebody has tampered with: one clear line each, and nothing of them is used. */
class HostileStoreTest {
    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void store() throws IOException {
        file = folder.resolve("s.db");
        try (StoreArchive archive =
                TestStores.open(TestStores.at(file), StoreLogin.NONE, TestStores.ID, StoredSamples.PIXELS)) {
            archive.keep(TestStores.PLAN);
            for (int unit = 0; unit < 4; unit++) {
                archive.keepSamples(0, unit, 0, unit % 50, TestStores.samples(unit));
                archive.keep(0, unit, "me", TestStores.result(unit));
            }
        }
    }

    private void sql(String... lines) throws SQLException {
        try (Connection c = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = c.createStatement()) {
            for (String line : lines) {
                statement.execute(line);
            }
        }
    }

    private void assertRefused(String words) {
        for (boolean writes : new boolean[] {false, true}) {
            IOException e = assertThrows(IOException.class, () -> {
                if (writes) {
                    TestStores.open(file).close();
                } else {
                    SampleStore.open(TestStores.at(file), StoreLogin.NONE).close();
                }
            });
            assertTrue(e.getMessage().contains(words), e.getMessage());
            assertEquals(1, e.getMessage().lines().count());
        }
    }

    private List<Integer> sound() throws IOException {
        List<Integer> units = new ArrayList<>();
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            RenderRow render = store.choose("");
            store.results(render, store.plans(render).get(0), (unit, bytes) -> units.add(unit));
        }
        return units;
    }

    @Test
    void filesOfOtherProgramsAreLeftAsTheyAre() throws Exception {
        Files.writeString(file, "just a text, longer than the sixteen bytes that tell");
        assertRefused("is not a SQLite file: it is left as it is");
        assertEquals("just a text, longer than the sixteen bytes that tell", Files.readString(file));
        Files.delete(file);
        sql("CREATE TABLE contacts (name TEXT)");
        assertRefused("is a SQLite file of something else, no store");
        Files.delete(file);
        Files.createDirectory(file);
        assertRefused("is no file");
    }

    @Test
    void laterVersionsAndWhatRunsOrStandsInForATableAreRefused() throws Exception {
        sql("UPDATE store_version SET version = 2");
        assertRefused("is a store of version 2, made by a newer program; this one knows version 1");
        sql(
                "UPDATE store_version SET version = 1",
                "CREATE TRIGGER t AFTER INSERT ON film_part BEGIN DELETE FROM render; END");
        assertRefused("has triggers");
        sql("DROP TRIGGER t", "DROP TABLE film_part", "CREATE VIEW film_part AS SELECT * FROM render");
        assertRefused("has a view where a store has a table");
    }

    @Test
    void resultsOfWrongLengthChecksumTypeOrNumberAreNotUsed() throws Exception {
        sql("UPDATE film_part SET crc = crc + 1 WHERE tile = 0");
        assertEquals(List.of(1, 2, 3), sound());
        sql("UPDATE film_part SET data = zeroblob(70000000) WHERE tile = 1");
        assertEquals(List.of(2, 3), sound());
        sql("UPDATE film_part SET data = 'a text', crc = 'another' WHERE tile = 2");
        assertEquals(List.of(3), sound());
        sql("UPDATE film_part SET tile = 2147483647 WHERE tile = 3", "UPDATE film_part SET tile = -1 WHERE tile = 0");
        assertEquals(List.of(Integer.MAX_VALUE), sound());
        sql("UPDATE film_part SET tile = 4294967296 WHERE tile = 2147483647");
        assertEquals(List.of(), sound());
    }

    @Test
    void blocksThatAreNotWhatTheySayAreLeftOut() throws Exception {
        sql(
                "UPDATE sample_block SET n = 2147483647 WHERE tile = 0",
                "UPDATE sample_block SET n = -1 WHERE tile = 1",
                "UPDATE sample_block SET data = zeroblob(56) WHERE tile = 2");
        List<Integer> units = new ArrayList<>();
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            Blocks blocks = new Blocks(store.database(), TestStores.ID, 0);
            blocks.read(0, (unit, block) -> units.add(unit));
            assertEquals(3, blocks.damaged());
        }
        assertEquals(List.of(3), units);
    }

    @Test
    void plansThatMakeNoSenseMakeNoPicture() throws Exception {
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            RenderRow render = store.choose("");
            assertTrue(StorePicture.units(store.plans(render).get(0)).isEmpty());
            IOException e = assertThrows(IOException.class, () -> StorePicture.of(store, render, Optional.empty()));
            assertTrue(e.getMessage().contains("can make a picture of"), e.getMessage());
        }
        sql("UPDATE render_plan SET data = zeroblob(100000000)");
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            assertTrue(store.plans(store.choose("")).isEmpty());
        }
    }

    @Test
    void textsAreShownWithoutWhatTerminalsObey() throws Exception {
        sql(
                "UPDATE film_part SET worker = char(27) || '[2J' || char(10) || 'fake line'",
                "UPDATE render SET name = char(27) || ']0;title' || char(7), settings = 'a' || char(10) || 'b',"
                        + " program = 'x' || char(13), id = 'aaaa' || char(27), created = char(8238) || 'now'",
                "UPDATE film_part SET render_id = (SELECT id FROM render)",
                "UPDATE render_plan SET render_id = (SELECT id FROM render)");
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            RenderRow render = store.renders().get(0);
            String all = render + SampleStore.shortId(render);
            assertFalse(all.chars().anyMatch(c -> Character.isISOControl(c) || c == 0x202E), all);
        }
    }

    /** They would end the command where the file is written. */
    @Test
    void textsThatNoFileCanHaveAreLeftOut() {
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put("Title", "a scene");
        texts.put("", "no keyword");
        texts.put("two  spaces", "");
        texts.put("\u001b[2J", "moves the cursor");
        texts.put("Comment", "ends\0here");
        assertEquals(Map.of("Title", "a scene"), Texts.of(Texts.toBytes(texts)));
    }

    /** Whoever only looks would make such a file, and nobody would see that a picture is to be written over it. */
    @Test
    void urlsWithinUrlsAreRefused() {
        for (String url : List.of("jdbc:sqlite:file:" + file, "jdbc:sqlite:file::memory:?cache=shared")) {
            IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> StoreAddress.of(url));
            assertTrue(e.getMessage().contains("give the path of the file"), e.getMessage());
        }
    }

    /** One jar of many in the folder may be for a later Java. */
    @Test
    void driversThatCannotBeLoadedAreAsGoodAsNone() throws Exception {
        byte[] driver;
        try (InputStream in = Drivers.class.getResourceAsStream("Drivers.class")) {
            driver = in.readAllBytes();
        }
        // The version of the class file.
        driver[6] = Byte.MAX_VALUE;
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve("later.jar")))) {
            jar.putNextEntry(new ZipEntry("META-INF/services/java.sql.Driver"));
            jar.write("later.Driver".getBytes(StandardCharsets.UTF_8));
            jar.putNextEntry(new ZipEntry("later/Driver.class"));
            jar.write(driver);
        }
        StoreAddress address = StoreAddress.of("jdbc:unheardof:there");
        IOException e = assertThrows(IOException.class, () -> new Drivers(List.of(folder))
                .connect(address, address.url(), new Properties()));
        assertTrue(e.getMessage().startsWith("there is no JDBC driver for unheardof here"), e.getMessage());
    }

    @Test
    void numbersThatAreTooLargeAreAddedUpAllTheSame() throws Exception {
        sql("UPDATE film_part SET samples = 9223372036854775807");
        try (SampleStore store = SampleStore.open(TestStores.at(file), StoreLogin.NONE)) {
            RenderRow render = store.choose("");
            assertEquals(4, store.facts(render, store.plans(render).get(0)).units());
        }
    }
}
