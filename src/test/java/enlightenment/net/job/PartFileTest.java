package enlightenment.net.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.engine.RenderOutline;
import enlightenment.file.ContentHash;
import enlightenment.file.ScratchFile;
import enlightenment.net.parts.RenderParts;
import enlightenment.render.RenderRequest;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A damaged part is refused with its name and a reason, or it is none: also where whoever damaged it wrote a hash that fits.
 */
class PartFileTest {
    /** More bytes than come before the first tile. */
    private static final int HEAD = 500;

    @TempDir
    Path folder;

    private Path file;
    private byte[] good;

    @BeforeEach
    void part() throws IOException {
        Scene scene = SceneReader.readString(
                """
                { "name": "part", "image": { "width": 11, "height": 9 },
                  "camera": { "type": "isometric", "lookAt": [0, 0, 0], "height": 3 },
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1,
                    "material": { "type": "matte", "color": "#80c0ff" } } ] }
                """,
                folder,
                "part");
        file = folder.resolve("part.film");
        RenderSettings settings = RenderSettings.of(scene).withAntialias(1).withThreads(1);
        RenderParts.render(RenderRequest.of(scene, settings), 1, 1, samples -> Map.of("Title", "part"), file);
        good = Files.readAllBytes(file);
        assertEquals(
                List.of(), RenderParts.merge(List.of(file), Optional.empty()).missing());
    }

    private Scene other(double radius) {
        return SceneReader.readString(
                """
                { "name": "part", "image": { "width": 11, "height": 9 },
                  "camera": { "type": "isometric", "lookAt": [0, 0, 0], "height": 3 },
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": %s,
                    "material": { "type": "matte", "color": "#80c0ff" } } ] }
                """
                        .formatted(radius),
                folder,
                "part");
    }

    private void renders(double radius, int part, int parts) throws IOException {
        Scene scene = other(radius);
        RenderSettings settings = RenderSettings.of(scene).withAntialias(1).withThreads(1);
        RenderParts.render(RenderRequest.of(scene, settings), part, parts, samples -> Map.of("Title", "part"), file);
    }

    @Test
    void aFileThatHoldsAnotherPartIsNotReplaced() throws IOException {
        renders(1, 1, 1);
        for (int[] wanted : new int[][] {{1, 2}, {2, 2}}) {
            IOException e = assertThrows(IOException.class, () -> renders(1, wanted[0], wanted[1]));
            assertTrue(e.getMessage().startsWith(file + ": holds part 1 of 1"), e.getMessage());
        }
        assertEquals(good.length, Files.size(file));
        // The same part of a scene that has changed, and what is no part, are replaced as any output is.
        renders(1.5, 1, 1);
        Files.write(file, new byte[] {1, 2, 3});
        renders(1.5, 1, 1);
    }

    /** The bytes with the hash that they should have. */
    private byte[] withHash(byte[] content) {
        byte[] bytes = Arrays.copyOf(content, content.length + ContentHash.BYTES);
        System.arraycopy(ContentHash.of(content).toBytes(), 0, bytes, content.length, ContentHash.BYTES);
        return bytes;
    }

    private byte[] content() {
        return Arrays.copyOf(good, good.length - ContentHash.BYTES);
    }

    /** Whether the file is refused; fails where that is done in another way than by an exception that names the file. */
    private boolean isRefused(byte[] bytes, String what) throws IOException {
        Files.write(file, bytes);
        try {
            RenderParts.merge(List.of(file), Optional.empty());
            return false;
        } catch (IOException e) {
            assertTrue(e.getMessage().startsWith(file + ": "), () -> what + ": " + e.getMessage());
            return true;
        } catch (RuntimeException e) {
            throw new AssertionError(what, e);
        }
    }

    @Test
    void everyFlippedByteIsFound() throws IOException {
        for (int at = 0; at < good.length; at += at < HEAD ? 1 : 5) {
            byte[] bad = good.clone();
            bad[at] ^= (byte) (1 << at % 8);
            assertTrue(isRefused(bad, "byte " + at), "byte " + at);
        }
    }

    @Test
    void everyFlippedByteWithAHashThatFitsIsFoundOrHarmless() throws IOException {
        int refused = 0;
        for (int at = 0; at < good.length - ContentHash.BYTES; at += at < HEAD ? 1 : 5) {
            for (int mask : at < HEAD ? new int[] {1, 0x20, 0x80} : new int[] {0x40}) {
                byte[] bad = content();
                bad[at] ^= (byte) mask;
                refused += isRefused(withHash(bad), "byte " + at + " with " + mask) ? 1 : 0;
            }
        }
        assertTrue(refused > 300, refused + " refused");
    }

    @Test
    void everyLengthIsFound() throws IOException {
        for (int length = 0; length < good.length; length += length < HEAD || good.length - length < 99 ? 1 : 5) {
            assertTrue(isRefused(Arrays.copyOf(good, length), "cut to " + length), "cut to " + length);
            if (length < good.length - ContentHash.BYTES) {
                byte[] cut = withHash(Arrays.copyOf(good, length));
                assertTrue(isRefused(cut, "cut to " + length + ", with a hash"), "cut to " + length);
            }
        }
        byte[] longer = Arrays.copyOf(content(), good.length - ContentHash.BYTES + 7);
        assertTrue(isRefused(withHash(longer), "longer"));
    }

    /** A size that neither memory nor disk can have takes nothing of either. */
    @Test
    void aSizeThatFitsNowhereIsRefusedBeforeAnythingIsTaken() throws IOException {
        int side = 1 << 16;
        PartFile.Head head;
        try (PartFile part = PartFile.open(file)) {
            head = part.head();
        }
        RenderOutline o = head.outline();
        RenderOutline huge = new RenderOutline(
                        o.sceneName(), o.settings().withSize(side, side), o.plan(), o.features(), o.kinds())
                .withDisplay(DisplayCurve.SRGB);
        PartFile.write(file, new PartFile.Head(head.job(), huge, head.text(), 1, 1), new int[0], tile -> new byte[0]);
        for (long memory : new long[] {Long.MAX_VALUE, 0}) {
            assumeTrue(memory > 0 || ScratchFile.usableSpace(folder) < 100L * side * side, "the disk is larger");
            Optional<RenderRequest.ScratchFolder> scratch =
                    Optional.of(new RenderRequest.ScratchFolder(folder, memory));
            IOException e = assertThrows(IOException.class, () -> RenderParts.merge(List.of(file), scratch));
            assertTrue(e.getMessage().startsWith(file + ": "), e.getMessage());
            assertTrue(e.getMessage().contains(" needs "), e.getMessage());
        }
    }

    /** Two parts of one picture that tell of it in two ways are not both whole. */
    @Test
    void partsThatDisagreeAreRefused() throws IOException {
        Path other = Files.write(folder.resolve("other.film"), good);
        byte[] bad = content();
        int at = new String(bad, StandardCharsets.ISO_8859_1).indexOf("part");
        bad[at] = 'P';
        Files.write(file, withHash(bad));
        IOException e =
                assertThrows(IOException.class, () -> RenderParts.merge(List.of(other, file), Optional.empty()));
        assertTrue(e.getMessage().contains("part.film: "), e.getMessage());
    }
}
