package enlightenment.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.SceneFixture;
import enlightenment.cli.terminal.ShutdownSignal;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MergeCommandTest extends SceneFixture {
    private Path merged;

    MergeCommandTest() {
        super(50, 34);
    }

    @BeforeEach
    void files() {
        merged = folder.resolve("merged.png");
    }

    private Path part(int part, int parts, Object... more) {
        Path file = folder.resolve("part-" + part + "-" + parts + ".film");
        Object[] args = new Object[8 + more.length];
        Object[] first = {"render", scene, "-o", file, "--part", part + "/" + parts, "--progress", "none"};
        System.arraycopy(first, 0, args, 0, 8);
        System.arraycopy(more, 0, args, 8, more.length);
        CliRun run = CliRun.of(args);
        assertEquals("", run.err());
        assertEquals(0, run.code());
        return file;
    }

    private void assertSays(CliRun run, int code, String words) {
        assertTrue(run.err().contains(words), run.err());
        assertEquals(code, run.code());
    }

    @ParameterizedTest
    @ValueSource(strings = {"raytrace", "cluster"})
    void partsInAnyOrderAndFromAnyThreadsMakeTheBytesOfOneMachine(String method) throws IOException {
        CliRun whole = CliRun.of("render", scene, "-o", picture, "--method", method, "--progress", "none");
        assertEquals(0, whole.code(), whole.err());
        Path a = part(1, 3, "--method", method, "--threads", "1");
        Path b = part(2, 3, "--method", method, "--threads", "3");
        Path c = part(3, 3, "--method", method);
        CliRun run = CliRun.of("merge", c, a, b, a, "-o", merged, "--stats");
        assertEquals(0, run.code(), run.err());
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(merged));
        assertTrue(run.out().contains("estimated error"), run.out());
    }

    @Test
    void partsOfDifferentDivisionsGoTogether() throws IOException {
        assertEquals(
                0,
                CliRun.of("render", scene, "-o", picture, "--progress", "none").code());
        Path a = part(1, 2);
        Path b = part(2, 4);
        Path c = part(4, 4);
        assertEquals(0, CliRun.of("merge", a, b, c, "-o", merged).code());
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(merged));
    }

    @Test
    void whatIsMissingIsNamedAndNothingIsWrittenUnlessAskedFor() {
        Path a = part(1, 3);
        assertSays(CliRun.of("merge", a, "-o", merged), 1, "missing: part 2/3, part 3/3");
        assertFalse(Files.exists(merged));
        assertSays(CliRun.of("merge", a, "-o", merged, "--partial"), 1, "missing: part 2/3, part 3/3");
        assertTrue(Files.exists(merged));
    }

    @Test
    void partsOfOtherPicturesAreRefused() throws IOException {
        Path a = part(1, 2);
        Path seed = part(2, 2, "--seed", "7");
        assertSays(CliRun.of("merge", a, seed, "-o", merged), 1, "seed=7");
        Files.writeString(scene, Files.readString(scene).replace("\"radius\": 1,", "\"radius\": 2,"));
        Path other = part(2, 2);
        assertSays(CliRun.of("merge", a, other, "-o", merged), 1, "the scenes differ");
    }

    @Test
    void damageIsFoundWhereverItIs() throws IOException {
        Path a = part(1, 1);
        byte[] good = Files.readAllBytes(a);
        for (int at = 0; at < good.length; at += 1 + good.length / 200) {
            byte[] bad = good.clone();
            bad[at] ^= 4;
            Files.write(a, bad);
            CliRun run = CliRun.of("merge", a, "-o", merged);
            assertEquals(1, run.code(), "byte " + at);
            assertTrue(run.err().contains("part-1-1.film: is "), run.err());
        }
        Files.write(a, Arrays.copyOf(good, good.length - 40));
        assertSays(CliRun.of("merge", a, "-o", merged), 1, "cut short");
        Files.write(a, new byte[5]);
        assertSays(CliRun.of("merge", a, "-o", merged), 1, "is not a part of a render");
        Files.write(a, good);
        assertEquals(0, CliRun.of("merge", a, "-o", merged).code());
    }

    /** Damage that has a hash that fits, as from a program that writes parts and has a fault. */
    @Test
    void aMethodThatThereIsNotIsRefusedWithTheFile() throws Exception {
        Path a = part(1, 1);
        byte[] bad = Files.readAllBytes(a);
        int content = bad.length - 32;
        int at = new String(bad, StandardCharsets.ISO_8859_1).indexOf("raytrace");
        bad[at + 3] = 'x';
        byte[] hash = MessageDigest.getInstance("SHA-256").digest(Arrays.copyOf(bad, content));
        System.arraycopy(hash, 0, bad, content, hash.length);
        Files.write(a, bad);
        CliRun run = CliRun.of("merge", a, "-o", merged);
        assertSays(run, 1, "part-1-1.film: makes no sense: ");
        assertTrue(run.err().contains("\"rayxrace\""), run.err());
    }

    /** Asked between tiles, and often within each: long after the first there are some left. */
    @Test
    void aPartThatIsStoppedHoldsWhatIsDone() {
        AtomicInteger polls = new AtomicInteger();
        Path whole = folder.resolve("whole.film");
        render(polls, Integer.MAX_VALUE, whole);
        int half = polls.getAndSet(0) / 2;
        Path file = folder.resolve("stopped.film");
        assertSays(render(polls, half, file), 1, "holds only some of part 1/2");
        CliRun merge = CliRun.of("merge", file, "-o", merged);
        assertSays(merge, 1, " tiles of part 1/2, part 2/2");
        assertTrue(merge.err().startsWith("enlightenment: missing: "), merge.err());
    }

    /** Renders a part until it has been asked so often whether to stop. */
    private CliRun render(AtomicInteger polls, int most, Path file) {
        ShutdownSignal stop = new ShutdownSignal() {
            @Override
            public boolean getAsBoolean() {
                return polls.incrementAndGet() > most;
            }
        };
        return CliRun.of(stop, "render", scene, "-o", file, "--part", "1/2", "--threads", "1", "--progress", "none");
    }

    /** No part knows the whole picture: whoever puts it together finds out whether it keeps the error. */
    @Test
    void anErrorThatTheWholeDoesNotKeepIsAFailureAndThePictureIsWritten() throws IOException {
        Path a = part(1, 2, "--error", "0.02", "--samples", "2", "--depth", "16");
        Path b = part(2, 2, "--error", "0.02", "--samples", "2", "--depth", "16");
        assertSays(CliRun.of("merge", a, b, "-o", merged, "--depth", "16"), 1, "more than --error 0.02");
        assertTrue(Files.exists(merged));
        Path c = part(1, 1, "--error", "0.5");
        assertEquals(new CliRun(0, "", ""), CliRun.of("merge", c, "-o", merged));
        CliRun.of("render", scene, "-o", picture, "--error", "0.5", "--progress", "none");
        assertArrayEquals(Files.readAllBytes(picture), Files.readAllBytes(merged));
    }

    /** Parts have no further rounds, so that a picture too small for trials of some blocks is tried as a whole. */
    @Test
    void aSmallPictureOfPartsKeepsTheError() throws IOException {
        Path room = Path.of("scenes/cornell-box.json").toAbsolutePath();
        Path a = folder.resolve("a.film");
        assertEquals(
                0,
                CliRun.of("render", room, "-o", a, "--part", "1/1", "--size", "40x30", "--error", "0.03")
                        .code());
        assertEquals(0, CliRun.of("merge", a, "-o", merged).code());
        CliRun light = CliRun.of(
                "render", room, "-o", a, "--part", "1/1", "--size", "40x30", "--error", "0.03", "--method", "light");
        assertSays(light, 2, "--samples must be given beside the error: light has no trials");
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        Path film = folder.resolve("x.film");
        assertSays(CliRun.of("render", scene, "-o", film, "--part", "3/2"), 2, "--part must be I/N");
        assertSays(CliRun.of("render", scene, "-o", picture, "--part", "1/2"), 2, "ends in .film");
        assertSays(CliRun.of("render", scene, "-o", film, "--part", "1/2", "--time", "3"), 2, "give --samples");
        assertSays(CliRun.of("render", scene, "-o", film, "--part", "1/2", "--stats"), 2, "no picture yet");
        assertSays(CliRun.of("merge", folder.resolve("none.film"), "-o", merged), 1, "none.film");
        assertSays(CliRun.of("merge", film, "-o", film), 2, "ends in .png, .jpg, .pfm or .exr");
    }
}
