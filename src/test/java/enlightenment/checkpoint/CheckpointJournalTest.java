package enlightenment.checkpoint;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import enlightenment.net.schedule.Peers;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CheckpointJournalTest {
    private static final RenderIdentity RENDER =
            new RenderIdentity(ContentHash.of(new byte[] {1}), "method raytrace, seed 1", "1.0");
    private static final RenderIdentity OTHER =
            new RenderIdentity(ContentHash.of(new byte[] {1}), "method raytrace, seed 2", "1.0");

    /** The key of a plan. */
    private static final long PLAN = 0x1122334455667788L;

    /** Before and after the body of a record, and before what it says. */
    private static final int AROUND = 20 + Long.BYTES;

    /** Where what was written begins: behind the record that says what the journal is of. */
    private static final int START =
            JournalFormat.START + AROUND + new JournalRecord.About(RENDER.settings(), RENDER.build()).encode().length;

    private static final List<JournalRecord> RECORDS = List.of(
            new JournalRecord.Kept(3, Peers.machine("machine-ü"), new byte[] {1, 2, 3, 4, 5}),
            new JournalRecord.Kept(9, Peers.machine("b"), new byte[0]),
            new JournalRecord.Confirmed(3, Origin.SERVER, ContentHash.of(new byte[] {1, 2, 3, 4, 5})),
            new JournalRecord.Expelled(Peers.machine("b")),
            new JournalRecord.Pardoned(Peers.machine("b")),
            new JournalRecord.Revoked(9),
            new JournalRecord.Kept(9, Origin.SERVER, new byte[40]));

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("job.journal");
    }

    /** As a server opens it, but without waiting for the disk. */
    private CheckpointJournal journal(RenderIdentity job, CheckpointJournal.Reader reader) throws IOException {
        CheckpointJournal.Reader rest = (plan, record, place) -> {
            if (!(record instanceof JournalRecord.About)) {
                assertEquals(PLAN, plan);
                reader.record(plan, record, place);
            }
        };
        return CheckpointJournal.open(file, job, true, 0, rest, channel -> {});
    }

    private List<String> open(RenderIdentity job) throws IOException {
        List<String> found = new ArrayList<>();
        journal(job, (plan, r, p) -> found.add(text(r))).close();
        return found;
    }

    private static String text(JournalRecord record) {
        return record instanceof JournalRecord.Kept kept
                ? kept.tile() + kept.origin().toString() + Arrays.toString(kept.data())
                : record.toString();
    }

    private static List<String> texts(List<JournalRecord> records) {
        return records.stream().map(CheckpointJournalTest::text).toList();
    }

    private byte[] write() throws IOException {
        try (CheckpointJournal journal = journal(RENDER, (plan, r, p) -> {})) {
            for (JournalRecord record : RECORDS) {
                journal.append(0, PLAN, record);
            }
        }
        return Files.readAllBytes(file);
    }

    @Test
    void whatWasWrittenIsReadInItsOrder() throws IOException {
        write();
        assertEquals(texts(RECORDS), open(RENDER));
    }

    @Test
    void aFileCutAtAnyByteKeepsEveryRecordThatIsWholeAndGoesOn() throws IOException {
        byte[] whole = write();
        List<Integer> ends = new ArrayList<>();
        int at = START;
        for (JournalRecord record : RECORDS) {
            at += AROUND + record.encode().length;
            ends.add(at);
        }
        assertEquals(whole.length, at);
        JournalRecord more = new JournalRecord.Revoked(1);
        for (int cut = 0; cut <= whole.length; cut++) {
            Files.write(file, Arrays.copyOf(whole, cut));
            int length = cut;
            int complete = (int) ends.stream().filter(end -> end <= length).count();
            List<String> found = new ArrayList<>();
            try (CheckpointJournal journal = journal(RENDER, (plan, r, p) -> found.add(text(r)))) {
                int good = complete > 0 ? ends.get(complete - 1) : cut >= START ? START : JournalFormat.START;
                assertEquals(Math.max(cut - good, 0), journal.cutBytes(), "cut at " + cut);
                journal.append(0, PLAN, more);
            }
            assertEquals(texts(RECORDS.subList(0, complete)), found, "cut at " + cut);
            List<JournalRecord> expected = new ArrayList<>(RECORDS.subList(0, complete));
            expected.add(more);
            assertEquals(texts(expected), open(RENDER), "cut at " + cut);
        }
    }

    /** Number of the record that a byte belongs to; -1 for the headers and the record about the render. */
    private static int recordAt(int at) {
        int end = START;
        int record = -1;
        while (at >= end) {
            end += AROUND + RECORDS.get(++record).encode().length;
        }
        return record;
    }

    private static List<JournalRecord> without(int from, int to) {
        List<JournalRecord> rest = new ArrayList<>(RECORDS);
        rest.subList(from, to).clear();
        return rest;
    }

    @Test
    void aFlippedBitAnywhereCostsTheRecordThatItIsInAndNoOther() throws IOException {
        checkFlippedBits(4);
    }

    @Test
    @Tag("full")
    void eachFlippedBitCostsTheRecordThatItIsInAndNoOther() throws IOException {
        checkFlippedBits(1);
    }

    /** Every byte, and of its bits one in so many; the next byte begins with another one. */
    private void checkFlippedBits(int step) throws IOException {
        byte[] whole = write();
        for (int at = 0; at < whole.length; at++) {
            for (int bit = at % step; bit < 8; bit += step) {
                byte[] damaged = whole.clone();
                damaged[at] ^= (byte) (1 << bit);
                Files.write(file, damaged);
                int lost = recordAt(at);
                List<JournalRecord> rest = lost < 0 ? RECORDS : without(lost, lost + 1);
                String place = "bit " + bit + " of byte " + at;
                assertEquals(texts(rest), open(RENDER), place);
                boolean isLast = lost == RECORDS.size() - 1;
                try (CheckpointJournal journal = journal(RENDER, (plan, r, p) -> {})) {
                    assertEquals(at < JournalFormat.START || isLast ? 0 : 1, journal.gaps(), place);
                    journal.append(0, PLAN, RECORDS.get(0));
                }
                List<JournalRecord> more = new ArrayList<>(rest);
                more.add(RECORDS.get(0));
                assertEquals(texts(more), open(RENDER), place);
            }
        }
    }

    @Test
    void bytesThatAreMissingOrOverwrittenCostTheRecordsThatTheyWereIn() throws IOException {
        checkMissing(7, 64);
    }

    @Test
    @Tag("full")
    void anyNumberOfBytesThatAreMissingOrOverwrittenCostsTheRecordsThatTheyWereIn() throws IOException {
        checkMissing(1, 7, 30, 64);
    }

    private void checkMissing(int... lengths) throws IOException {
        byte[] whole = write();
        for (int at = START; at < whole.length; at++) {
            for (int length : lengths) {
                int end = Math.min(at + length, whole.length);
                byte[] overwritten = whole.clone();
                for (int i = at; i < end; i++) {
                    // Another byte for certain, whatever stood there.
                    overwritten[i] ^= 0x5a;
                }
                Files.write(file, overwritten);
                List<JournalRecord> rest = without(recordAt(at), recordAt(end - 1) + 1);
                assertEquals(texts(rest), open(RENDER), length + " bytes at " + at + " overwritten");
                byte[] cut = Arrays.copyOf(whole, whole.length - (end - at));
                System.arraycopy(whole, end, cut, at, whole.length - end);
                Files.write(file, cut);
                // Where the same bytes follow, the others seem to be the ones that are missing.
                List<String> found = open(RENDER);
                assertTrue(
                        found.containsAll(
                                texts(without(recordAt(at), Math.min(recordAt(end - 1) + 2, RECORDS.size())))),
                        "cut at " + at);
            }
        }
    }

    @Test
    void nobodyCanPutRecordsIntoTheBytesOfATile() throws IOException {
        byte[] planted = JournalFormat.Header.of(RENDER, 0x0123456789abcdefL)
                .record(new JournalRecord.Expelled(Peers.machine("honest")).encode())
                .array();
        List<byte[]> signs = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Files.deleteIfExists(file);
            try (CheckpointJournal journal = journal(RENDER, (plan, r, p) -> {})) {
                journal.append(0, PLAN, new JournalRecord.Kept(0, Peers.machine("liar"), planted));
                journal.append(0, PLAN, new JournalRecord.Revoked(1));
            }
            byte[] damaged = Files.readAllBytes(file);
            signs.add(Arrays.copyOfRange(damaged, JournalFormat.START, JournalFormat.START + 8));
            damaged[START + 8] ^= 1;
            Files.write(file, damaged);
            assertEquals(List.of(text(new JournalRecord.Revoked(1))), open(RENDER));
        }
        assertFalse(Arrays.equals(signs.get(0), signs.get(1)), "the sign cannot be known");
    }

    @Test
    void aHeaderThatIsDamagedTwiceIsRefusedAndTheFileIsLeftAsItIs() throws IOException {
        byte[] whole = write();
        for (int at = 0; at < JournalFormat.HEADER_BYTES; at++) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 4;
            damaged[JournalFormat.HEADER_BYTES + at] ^= 8;
            Files.write(file, damaged);
            assertThrows(JournalException.class, () -> open(RENDER), "byte " + at);
            assertArrayEquals(damaged, Files.readAllBytes(file));
        }
    }

    @Test
    void aDamagedHeaderIsMended() throws IOException {
        byte[] whole = write();
        for (int at : new int[] {3, 20, JournalFormat.HEADER_BYTES + 50}) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 4;
            Files.write(file, damaged);
            open(RENDER);
            assertArrayEquals(whole, Files.readAllBytes(file));
        }
    }

    @Test
    void aCheckpointOfAnotherVersionIsRefusedByThatNameAndLeftAsItIs() throws IOException {
        byte[] old = Arrays.copyOf("ENLJRN01".getBytes(), 48);
        Files.write(file, old);
        String message =
                assertThrows(JournalException.class, () -> open(RENDER)).getMessage();
        assertTrue(message.contains("is a checkpoint of another version"), message);
        assertArrayEquals(old, Files.readAllBytes(file));
    }

    @Test
    void aConfirmationIsOfWhatWasConfirmedOnly() {
        ContentHash right = ContentHash.of(new byte[] {7});
        Restored.Builder builder = new Restored.Builder();
        builder.add(new JournalRecord.Kept(1, Peers.machine("liar"), new byte[] {6}));
        builder.add(new JournalRecord.Expelled(Peers.machine("liar")));
        // Here stood what an honest machine made of the tile; the record is lost.
        builder.add(new JournalRecord.Confirmed(1, Peers.machine("honest"), right));
        assertEquals(List.of(), builder.build().tiles());
    }

    @Test
    void theJournalOfAnotherRenderIsRefusedWithWhatDiffers() throws IOException {
        byte[] whole = write();
        String message = assertThrows(JournalException.class, () -> open(OTHER)).getMessage();
        assertTrue(message.contains("the settings (seed 1 there, 2 here)"), message);
        assertArrayEquals(whole, Files.readAllBytes(file));
    }

    @Test
    void aFileThatIsNoJournalIsNotTouched() throws IOException {
        byte[] letter = "Dear Ryan, here is the picture of the spheres that you wanted to see.".getBytes();
        Files.write(file, letter);
        String message =
                assertThrows(JournalException.class, () -> open(RENDER)).getMessage();
        assertTrue(message.contains("is not a checkpoint"), message);
        assertArrayEquals(letter, Files.readAllBytes(file));
    }

    @Test
    void twoServersCannotHaveTheSameJournal() throws IOException {
        CheckpointJournal first = journal(RENDER, (plan, r, p) -> {});
        try (first) {
            String message =
                    assertThrows(JournalException.class, () -> open(RENDER)).getMessage();
            assertTrue(message.contains("in use"), message);
        }
        assertEquals(List.of(), open(RENDER));
    }

    @Test
    void writesAreForcedAtMostEveryFifthOfASecondAndWhenItIsClosed() throws IOException {
        long millis = 1_000_000;
        long start = Long.MAX_VALUE - 100 * millis;
        AtomicInteger forced = new AtomicInteger();
        try (CheckpointJournal journal = CheckpointJournal.open(
                file, RENDER, true, start, (plan, r, at) -> {}, channel -> forced.incrementAndGet())) {
            assertEquals(1, forced.get(), "the header");
            journal.append(start + 199 * millis, PLAN, RECORDS.get(0));
            journal.tick(start + 200 * millis - 1);
            assertEquals(1, forced.get());
            journal.tick(start + 200 * millis);
            assertEquals(2, forced.get());
            journal.tick(start + 500 * millis);
            assertEquals(2, forced.get(), "nothing was written");
            journal.append(start + 399 * millis, PLAN, RECORDS.get(1));
            assertEquals(2, forced.get());
            journal.append(start + 400 * millis, PLAN, RECORDS.get(2));
            assertEquals(3, forced.get());
            journal.append(start + 401 * millis, PLAN, RECORDS.get(3));
        }
        assertEquals(4, forced.get());
        assertEquals(texts(RECORDS.subList(0, 4)), open(RENDER));
    }

    @Test
    void whatRestsOnAnExpelledMachineAloneIsNotRestoredAndAPardonDoesNotBringItBack() {
        Origin.Peer liar = Peers.machine("liar");
        Origin.Peer honest = Peers.machine("honest");
        Restored.Builder builder = new Restored.Builder();
        builder.add(new JournalRecord.Kept(1, liar, new byte[] {1}));
        builder.add(new JournalRecord.Kept(2, liar, new byte[] {2}));
        builder.add(new JournalRecord.Confirmed(2, honest, ContentHash.of(new byte[] {2})));
        builder.add(new JournalRecord.Kept(3, honest, new byte[] {3}));
        builder.add(new JournalRecord.Confirmed(3, liar, ContentHash.of(new byte[] {3})));
        builder.add(new JournalRecord.Kept(4, honest, new byte[] {4}));
        builder.add(new JournalRecord.Revoked(4));
        builder.add(new JournalRecord.Kept(5, liar, new byte[] {5}));
        builder.add(new JournalRecord.Confirmed(5, Origin.SERVER, ContentHash.of(new byte[] {5})));
        builder.add(new JournalRecord.Expelled(liar));
        List<Restored.Tile> left = List.of(
                new Restored.Tile(2, honest, ContentHash.of(new byte[] {2}), null),
                new Restored.Tile(3, honest, ContentHash.of(new byte[] {3}), null),
                new Restored.Tile(5, Origin.SERVER, ContentHash.of(new byte[] {5}), null));
        assertEquals(left, builder.build().tiles());
        assertEquals(Set.of(liar), builder.build().expelled());
        builder.add(new JournalRecord.Pardoned(liar));
        assertEquals(left, builder.build().tiles());
        assertEquals(Set.of(), builder.build().expelled());
    }

    @Test
    void noMachineIsReadAsTheServer() throws IOException {
        for (String name : new String[] {"local", "", "the server", "\0"}) {
            JournalRecord kept = new JournalRecord.Kept(1, Peers.machine(name), new byte[9]);
            JournalRecord.Kept read = (JournalRecord.Kept) JournalRecord.decode(ByteBuffer.wrap(kept.encode()));
            assertEquals(Peers.machine(name), read.origin());
        }
        byte[] expelled = new JournalRecord.Expelled(Peers.machine("x")).encode();
        byte[] server = Arrays.copyOf(expelled, 2);
        server[1] = Origin.SERVER_KIND;
        assertThrows(JournalException.class, () -> JournalRecord.decode(ByteBuffer.wrap(server)));
    }
}
