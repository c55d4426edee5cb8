package enlightenment.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What goes into a store comes out again, by whichever database. */
class StoreArchiveTest {
    @TempDir
    private Path folder;

    private StoreAddress address(String database) {
        return database.equals("sqlite")
                ? TestStores.at(folder.resolve("s.db"))
                : StoreAddress.of("jdbc:h2:" + folder.resolve("s"));
    }

    private static Map<Integer, byte[]> replayed(StoreArchive archive, int plan) throws IOException {
        Map<Integer, byte[]> all = new HashMap<>();
        archive.replay(plan, all::put);
        return all;
    }

    @ParameterizedTest
    @ValueSource(strings = {"sqlite", "h2"})
    void resultsAreThereAgainInTheOrderOfUnitsWhoeverOpensItNext(String database) throws IOException {
        StoreAddress address = address(database);
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            assertEquals(0, archive.keep(TestStores.PLAN));
            for (int unit = 2500; unit > 0; unit--) {
                archive.keep(0, unit, "me", TestStores.result(unit));
            }
            assertArrayEquals(TestStores.result(7), archive.find(0, 7).orElseThrow());
            assertEquals(Optional.empty(), archive.find(0, 0));
        }
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            assertEquals(1, archive.plans().size());
            assertEquals(1, archive.keep(new byte[] {9}));
            assertEquals(0, archive.keep(TestStores.PLAN));
            int[] last = {0};
            archive.replay(0, (unit, bytes) -> {
                assertEquals(++last[0], unit);
                assertArrayEquals(TestStores.result(unit), bytes);
            });
            assertEquals(2500, last[0]);
            assertTrue(replayed(archive, 1).isEmpty());
        }
        try (SampleStore store = SampleStore.open(address, StoreLogin.NONE)) {
            RenderRow render = store.choose("aaa");
            List<PlanRow> plans = store.plans(render);
            assertEquals(Map.of("Title", "a scene"), plans.get(0).texts());
            SampleStore.Facts facts = store.facts(render, plans.get(0));
            assertEquals(2500, facts.units());
            assertEquals(facts.bytes(), facts.samples());
            assertEquals(
                    List.of(new SampleStore.Worker("me", 2500, facts.samples())), store.workers(render, plans.get(0)));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sqlite", "h2"})
    void whatOneWorkerMadeOfAPlanIsForgottenWithItsSamples(String database) throws IOException {
        StoreAddress address = address(database);
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.PIXELS)) {
            assertEquals(0, archive.keep(TestStores.PLAN));
            assertEquals(1, archive.keep(new byte[] {9}));
            for (int unit = 1; unit < 40; unit++) {
                archive.keepSamples(0, unit, 0, unit, TestStores.samples(unit));
                archive.keep(0, unit, unit % 2 == 0 ? "liar" : "liar's friend", TestStores.result(unit));
            }
            archive.keepSamples(1, 2, 0, 2, TestStores.samples(2));
            archive.keep(1, 2, "liar", TestStores.result(2));
            archive.removeAll(0, "liar");
            assertEquals(20, replayed(archive, 0).size());
            assertEquals(1, replayed(archive, 1).size());
        }
        try (SampleStore store = SampleStore.open(address, StoreLogin.NONE)) {
            RenderRow render = store.choose("aaa");
            List<PlanRow> plans = store.plans(render);
            assertEquals(20, store.facts(render, plans.get(0)).blocks());
            assertEquals(1, store.facts(render, plans.get(1)).blocks());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sqlite", "h2"})
    void theSameResultTwiceIsOneAndAnotherIsAnError(String database) throws IOException {
        StoreAddress address = address(database);
        try (StoreArchive a = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE);
                StoreArchive b = database.equals("h2")
                        ? null
                        : TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            StoreArchive other = b == null ? a : b;
            a.keep(TestStores.PLAN);
            a.keep(0, 5, "a", TestStores.result(5));
            a.find(0, 5);
            a.remove(0, 99);
            other.keep(0, 5, "b", TestStores.result(5));
            other.remove(0, 99);
            // One that says more is taken, one that says less is not missed.
            byte[] longer = Arrays.copyOf(TestStores.result(5), 300);
            other.keep(0, 5, "b", longer);
            other.remove(0, 99);
            a.keep(0, 5, "a", TestStores.result(5));
            a.remove(0, 99);
            assertArrayEquals(longer, a.find(0, 5).orElseThrow());
            a.keep(0, 5, "a", TestStores.result(6));
            IOException e = assertThrows(IOException.class, () -> a.remove(0, 99));
            assertTrue(e.getMessage().contains("computes wrongly"), e.getMessage());
            a.keep(0, 5, "a", longer);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sqlite", "h2"})
    void whatWasGivenAwayAndJudgedMayBeReplaced(String database) throws IOException {
        StoreAddress address = address(database);
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            archive.keep(TestStores.PLAN);
            archive.keep(0, 5, "a", TestStores.result(6));
            assertEquals(1, replayed(archive, 0).size());
            archive.keep(0, 5, "a", TestStores.result(5));
            assertArrayEquals(TestStores.result(5), replayed(archive, 0).get(5));
            archive.remove(0, 5);
            assertTrue(replayed(archive, 0).isEmpty());
        }
    }

    /** Their process may be killed between the two transactions. */
    @ParameterizedTest
    @ValueSource(strings = {"sqlite", "h2"})
    void aUnitWhoseSamplesAreNotAllThereYetDoesNotCount(String database) throws IOException {
        StoreAddress address = address(database);
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            archive.keep(TestStores.PLAN);
            archive.keep(0, 7, "a", TestStores.result(7));
        }
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.PIXELS)) {
            assertTrue(replayed(archive, 0).isEmpty());
            archive.keepSamples(0, 7, 0, 7, TestStores.samples(7));
            archive.write();
            assertTrue(replayed(archive, 0).isEmpty());
            archive.keepSamples(0, 7, 0, 7, TestStores.samples(7));
            archive.keep(0, 7, "a", TestStores.result(7));
            assertEquals(1, replayed(archive, 0).size());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sqlite"})
    void damagedResultsAreLeftOutAndMadeAgain(String database) throws Exception {
        StoreAddress address = address(database);
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            archive.keep(TestStores.PLAN);
            for (int unit = 0; unit < 4; unit++) {
                archive.keep(0, unit, "a", TestStores.result(unit));
            }
        }
        try (Connection c = DriverManager.getConnection(address.url());
                PreparedStatement update = c.prepareStatement("UPDATE film_part SET data = ? WHERE tile = ?")) {
            update.setBytes(1, TestStores.result(9));
            update.setInt(2, 1);
            update.executeUpdate();
            update.setBytes(1, new byte[0]);
            update.setInt(2, 2);
            update.executeUpdate();
        }
        try (StoreArchive archive = TestStores.open(address, StoreLogin.NONE, TestStores.ID, StoredSamples.NONE)) {
            assertEquals(java.util.Set.of(0, 3), replayed(archive, 0).keySet());
            assertEquals(2, archive.damaged());
            archive.keep(0, 1, "b", TestStores.result(1));
            archive.keep(0, 2, "b", TestStores.result(2));
            assertEquals(4, replayed(archive, 0).size());
        }
    }
}
