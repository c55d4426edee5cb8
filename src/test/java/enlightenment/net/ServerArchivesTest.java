package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.CheckpointJournal;
import enlightenment.checkpoint.JournalRecord;
import enlightenment.checkpoint.Origin;
import enlightenment.job.Build;
import enlightenment.job.RenderIdentity;
import enlightenment.job.SceneDocument;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What a server keeps in archives, beside its checkpoint and without one. */
@Timeout(600)
class ServerArchivesTest {
    private static final RenderSettings SETTINGS = Farm.SETTINGS.withBudget(RenderSettings.Budget.NONE.withSamples(4));

    @TempDir
    Path folder;

    /** In memory; knows who made what, and is as slow as a latch. */
    private static final class Memory implements RenderResult.Archive {
        private final List<byte[]> plans = new ArrayList<>();
        private final Map<Integer, byte[]> results = new TreeMap<>();
        private final Map<Integer, String> workers = new TreeMap<>();
        private final CountDownLatch gate;
        private int given;

        Memory(CountDownLatch gate) {
            this.gate = gate;
        }

        Memory() {
            this(new CountDownLatch(0));
        }

        @Override
        public String name() {
            return "memory";
        }

        @Override
        public List<byte[]> plans() {
            return plans;
        }

        @Override
        public int keep(byte[] plan) {
            assertTrue(plans.isEmpty() || Arrays.equals(plans.get(0), plan), "one plan");
            plans.add(plan);
            return 0;
        }

        @Override
        public void replay(int plan, Replay to) throws IOException {
            for (Map.Entry<Integer, byte[]> result : results.entrySet()) {
                to.result(result.getKey(), result.getValue().clone());
            }
        }

        @Override
        public Optional<byte[]> find(int plan, int unit) {
            return Optional.ofNullable(results.get(unit));
        }

        @Override
        public void keep(int plan, int unit, String worker, byte[] result) throws IOException {
            try {
                gate.await();
            } catch (InterruptedException e) {
                throw new IOException("interrupted", e);
            }
            given++;
            results.put(unit, result);
            workers.put(unit, worker);
        }

        @Override
        public void remove(int plan, int unit) {
            results.remove(unit);
        }

        @Override
        public void removeAll(int plan, String worker) {
            results.keySet().removeIf(unit -> worker.equals(workers.get(unit)));
        }

        @Override
        public void close() {}
    }

    private static Farm farm(ServerOptions.Builder options) throws Exception {
        return new Farm(Farm.SCENE, SETTINGS, options).begin();
    }

    private ServerOptions.Builder with(RenderResult.Archive archive) {
        return Farm.options().localThreads(2).archives(List.of(archive));
    }

    private ServerOptions.Builder keeping(Path checkpoint) {
        return Farm.options().localThreads(2).checkpoint(checkpoint);
    }

    /** A database may be busy for many seconds: workers that were not answered so long would be taken for lost. */
    @Test
    void aRenderGoesOnWhileAnArchiveIsBusyAndEndsWhenItHasEverything() throws Exception {
        CountDownLatch gate = new CountDownLatch(1);
        Memory archive = new Memory(gate);
        RenderServer server =
                RenderServer.start(Farm.SCENE, SETTINGS, with(archive).build(), () -> false);
        int[] told = new int[1];
        try (server) {
            var result = server.await(
                    (done, all, image) -> {
                        if (done == all) {
                            told[0] = archive.given;
                            gate.countDown();
                        }
                    },
                    () -> false);
            assertTrue(result.complete());
        }
        assertEquals(0, told[0], "all was rendered before anything was kept");
        int units = archive.results.size();
        assertTrue(units > 1);
        try (Farm again = farm(with(archive))) {
            assertTrue(again.result().complete());
            assertTrue(again.logHas("memory: " + units + " of " + units + " tiles are done already"));
        }
        assertEquals(units, archive.given);
    }

    @Test
    void checkpointAndArchiveGiveEachOtherWhatTheyHave() throws Exception {
        Path checkpoint = folder.resolve("checkpoint");
        byte[] picture;
        try (Farm first = farm(keeping(checkpoint))) {
            picture = Farm.png(first.result().image());
        }
        Memory archive = new Memory();
        try (Farm second = farm(keeping(checkpoint).archives(List.of(archive)))) {
            assertArrayEquals(picture, Farm.png(second.result().image()));
        }
        int units = archive.results.size();
        assertEquals(units, archive.given);
        assertEquals("the server", archive.workers.get(0));
        try (Farm third = farm(with(archive))) {
            assertArrayEquals(picture, Farm.png(third.result().image()));
            assertTrue(third.logHas("memory: " + units + " of " + units + " tiles are done already"));
        }
        Path other = folder.resolve("other");
        try (Farm fourth = farm(keeping(other).archives(List.of(archive)))) {
            assertArrayEquals(picture, Farm.png(fourth.result().image()));
        }
        try (Farm fifth = farm(keeping(other))) {
            assertArrayEquals(picture, Farm.png(fifth.result().image()));
            assertTrue(fifth.logHas("checkpoint: " + units + " of " + units + " tiles are done already"));
        }
        assertEquals(units, archive.given);
    }

    /** The server may have ended between an expulsion and what follows from it. */
    @Test
    void whatAnExpelledMachineMadeIsForgottenByTheArchive() throws Exception {
        Memory archive = new Memory();
        try (Farm first = farm(with(archive))) {
            assertTrue(first.result().complete());
        }
        Origin.Peer liar = Origin.Peer.of(new byte[] {1, 2, 3});
        archive.workers.put(1, liar.toString());
        Path checkpoint = folder.resolve("checkpoint");
        RenderIdentity render = RenderIdentity.of(SceneDocument.of(Farm.SCENE).hash(), SETTINGS, Build.number());
        try (CheckpointJournal journal =
                CheckpointJournal.open(checkpoint, render, true, 0, (plan, record, place) -> {})) {
            journal.append(0, 0, new JournalRecord.Expelled(liar));
        }
        int units = archive.results.size();
        try (Farm second = farm(keeping(checkpoint).archives(List.of(archive)))) {
            assertTrue(second.result().complete());
            assertTrue(second.logHas("memory: " + (units - 1) + " of " + units + " tiles are done already"));
        }
        assertEquals(units + 1, archive.given);
        assertEquals("the server", archive.workers.get(1));
    }
}
