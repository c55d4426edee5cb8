package enlightenment.checkpoint;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A journal as the archive of a render, but without waiting for the disk. */
class CheckpointTest {
    private static final ContentHash SCENE = ContentHash.of(new byte[] {1});
    private static final RenderIdentity RENDER = render(SCENE, "size 4x3, seed 1", "1.0");
    private static final byte[] PLAN = {1, 2, 3};
    private static final byte[] OTHER_PLAN = {4, 5};

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("c.ck");
    }

    private static RenderIdentity render(ContentHash scene, String settings, String build) {
        return new RenderIdentity(scene, settings, build);
    }

    private Checkpoint open() throws IOException {
        return Checkpoint.open(file, RENDER, true, channel -> {});
    }

    private static byte[] result(int unit) {
        byte[] bytes = new byte[8 + 2 * unit];
        new Random(unit).nextBytes(bytes);
        return bytes;
    }

    private static Map<Integer, String> replay(Checkpoint checkpoint, int plan) throws IOException {
        Map<Integer, String> all = new TreeMap<>();
        checkpoint.replay(plan, (unit, bytes) -> all.put(unit, Arrays.toString(bytes)));
        return all;
    }

    /** A file with three results of one plan and one of another. */
    private byte[] write() throws IOException {
        try (Checkpoint checkpoint = open()) {
            int plan = checkpoint.keep(PLAN);
            int other = checkpoint.keep(OTHER_PLAN);
            for (int unit : new int[] {0, 5, 2}) {
                checkpoint.keep(plan, unit, "a", result(unit));
            }
            checkpoint.keep(other, 5, "a", result(9));
        }
        return Files.readAllBytes(file);
    }

    @Test
    void whatIsKeptIsFoundAgainWithItsPlan() throws IOException {
        write();
        try (Checkpoint checkpoint = open()) {
            assertEquals(4, checkpoint.results());
            List<byte[]> plans = checkpoint.plans();
            assertArrayEquals(PLAN, plans.get(0));
            assertArrayEquals(OTHER_PLAN, plans.get(1));
            assertEquals(2, plans.size());
            assertEquals(1, checkpoint.keep(OTHER_PLAN), "it has a number already");
            assertEquals(List.of(0, 2, 5), List.copyOf(replay(checkpoint, 0).keySet()));
            assertEquals(Map.of(5, Arrays.toString(result(9))), replay(checkpoint, 1));
            assertArrayEquals(result(2), checkpoint.find(0, 2).orElseThrow());
            assertEquals(Optional.empty(), checkpoint.find(0, 1));
        }
    }

    @Test
    void aLaterResultTakesThePlaceOfAnEarlierOneAndWhatIsRemovedIsGone() throws IOException {
        write();
        try (Checkpoint checkpoint = open()) {
            checkpoint.keep(0, 2, "b", result(7));
            checkpoint.remove(0, 5);
            assertArrayEquals(result(7), checkpoint.find(0, 2).orElseThrow());
        }
        try (Checkpoint checkpoint = open()) {
            assertArrayEquals(result(7), checkpoint.find(0, 2).orElseThrow());
            assertEquals(List.of(0, 2), List.copyOf(replay(checkpoint, 0).keySet()));
            assertEquals(Optional.empty(), checkpoint.find(0, 5));
        }
    }

    @Test
    void aFlippedBitCostsOneResultAtMostAndNoPlan() throws IOException {
        byte[] whole = write();
        for (int at = 0; at < whole.length; at++) {
            byte[] damaged = whole.clone();
            damaged[at] ^= (byte) (1 << at % 8);
            Files.write(file, damaged);
            try (Checkpoint checkpoint = open()) {
                assertEquals(2, checkpoint.plans().size(), "byte " + at);
                int first = checkpoint.keep(PLAN);
                Map<Integer, String> found = replay(checkpoint, first);
                found.forEach((unit, bytes) -> assertEquals(Arrays.toString(result(unit)), bytes));
                assertTrue(checkpoint.results() >= 3, "byte " + at + " leaves " + checkpoint.results());
            }
        }
    }

    @Test
    void aFileCutAnywhereGoesOn() throws IOException {
        byte[] whole = write();
        for (int length = 0; length < whole.length; length += 3) {
            Files.write(file, Arrays.copyOf(whole, length));
            try (Checkpoint checkpoint = open()) {
                int plan = checkpoint.keep(PLAN);
                checkpoint.keep(plan, 1, "a", result(1));
            }
            try (Checkpoint checkpoint = open()) {
                assertArrayEquals(
                        result(1), checkpoint.find(checkpoint.keep(PLAN), 1).orElseThrow());
            }
        }
    }

    @Test
    void whatIsDamagedWhileItIsOpenIsNotGiven() throws IOException {
        write();
        try (Checkpoint checkpoint = open()) {
            byte[] bytes = Files.readAllBytes(file);
            bytes[bytes.length - 30] ^= 1;
            Files.write(file, bytes);
            assertEquals(Optional.empty(), checkpoint.find(1, 5));
            assertEquals(Map.of(), replay(checkpoint, 1));
        }
    }

    @Test
    void withoutBeingResumedItMustHoldNothing() throws IOException {
        Checkpoint.open(file, RENDER, false).close();
        Checkpoint.open(file, RENDER, false).close();
        byte[] whole = write();
        String message = assertThrows(IOException.class, () -> Checkpoint.open(file, RENDER, false))
                .getMessage();
        assertEquals(file + " holds results of this render already: --resume goes on with them", message);
        assertArrayEquals(whole, Files.readAllBytes(file));
    }

    @Test
    void oneThatHoldsNothingIsBegunAnewForAnyRender() throws IOException {
        try (Checkpoint checkpoint = Checkpoint.open(file, render(SCENE, "seed 9", "0.9"), false)) {
            checkpoint.keep(PLAN);
        }
        write();
        try (Checkpoint checkpoint = open()) {
            assertEquals(4, checkpoint.results());
        }
    }

    @Test
    void anotherRenderIsToldWhatDiffersAndLeavesItAsItIs() throws IOException {
        byte[] whole = write();
        ContentHash otherScene = ContentHash.of(new byte[] {2});
        Map<RenderIdentity, String> others = Map.of(
                render(otherScene, RENDER.settings(), "1.0"), "differs in the scene or one of its image files; it",
                render(SCENE, "size 4x3, crop 0 0 1 1, seed 2", "1.0"),
                        "differs in the settings (seed 1 there, 2 here; crop none there, 0 0 1 1 here); it",
                render(SCENE, RENDER.settings(), "1.1"), "differs in the version (1.0 there, 1.1 here); it",
                render(otherScene, "size 5x3, seed 1", "1.1"),
                        "differs in the version (1.0 there, 1.1 here) and the scene or one of its image files and"
                                + " the settings (size 4x3 there, 5x3 here); it");
        for (Map.Entry<RenderIdentity, String> other : others.entrySet()) {
            String message = assertThrows(IOException.class, () -> Checkpoint.open(file, other.getKey(), true))
                    .getMessage();
            assertTrue(message.contains(other.getValue()), message);
            assertArrayEquals(whole, Files.readAllBytes(file));
        }
    }

    @Test
    void whatDiffersIsToldWithoutTheRecordOfIt() throws IOException {
        byte[] whole = write();
        whole[JournalFormat.START + 30] ^= 1;
        Files.write(file, whole);
        String message = assertThrows(
                        IOException.class, () -> Checkpoint.open(file, render(SCENE, "seed 2", "1.0"), true))
                .getMessage();
        assertTrue(message.contains("differs in the settings; it"), message);
    }

    @Test
    void foldersAndOtherFilesAreNotTouched() throws IOException {
        String message = assertThrows(IOException.class, () -> Checkpoint.open(folder, RENDER, true))
                .getMessage();
        assertTrue(message.contains("is not a file"), message);
        byte[] picture = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10};
        Files.write(file, picture);
        message = assertThrows(IOException.class, () -> open()).getMessage();
        assertTrue(message.contains("is not a checkpoint"), message);
        assertArrayEquals(picture, Files.readAllBytes(file));
    }

    @Test
    void aFullDiskIsToldWithTheNameOfTheFile() {
        IOException full = new IOException("No space left on device");
        IOException e = assertThrows(
                IOException.class,
                () -> Checkpoint.open(file, RENDER, true, channel -> {
                    throw full;
                }));
        assertEquals(file + ": No space left on device", e.getMessage());
    }

    @Test
    void onlyOneRenderHasIt() throws IOException {
        try (Checkpoint first = open()) {
            String message = assertThrows(IOException.class, this::open).getMessage();
            assertEquals(file + " is in use by another render", message);
            first.keep(PLAN);
        }
        open().close();
    }

    @Test
    void whatAnExpelledMachineMadeForAServerDoesNotCount() throws IOException {
        Origin.Peer liar = Origin.Peer.of(new byte[] {1});
        Origin.Peer honest = Origin.Peer.of(new byte[] {2});
        long key = CheckpointJournal.key(PLAN);
        try (CheckpointJournal journal = CheckpointJournal.open(file, RENDER, true, 0, (plan, r, place) -> {})) {
            journal.append(0, key, new JournalRecord.Planned(PLAN));
            journal.append(0, key, new JournalRecord.Kept(1, liar, result(1)));
            journal.append(0, key, new JournalRecord.Kept(2, honest, result(2)));
            journal.append(0, 0, new JournalRecord.Expelled(liar));
        }
        try (Checkpoint checkpoint = open()) {
            assertEquals(Map.of(2, Arrays.toString(result(2))), replay(checkpoint, 0));
        }
    }
}
