package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Films are taken apart again, by the specification. */
class ApngWriterTest {
    private static final int WIDTH = 7;
    private static final int HEIGHT = 5;

    private record Chunk(String type, byte[] content) {}

    private static byte[] frame(int number, int width, int depth) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Components noise = (x, y, c) -> ((x * 31 + y * 17 + c * 7 + number * 13) * 2654435761L >>> 8 & 255) / 255f;
        new PngWriter(out, width, HEIGHT, depth)
                .write(noise, Map.of("Title", "A film", "Settings", "frame=" + number, "Frame digest", "" + number));
        return out.toByteArray();
    }

    private static byte[] film(List<byte[]> frames) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ApngWriter writer = new ApngWriter(out, frames.size(), 125, 2997);
        for (byte[] frame : frames) {
            writer.add(frame);
        }
        return out.toByteArray();
    }

    private static List<Chunk> chunks(byte[] file) throws IOException {
        PngChunks all = new PngChunks(file);
        List<Chunk> chunks = new ArrayList<>();
        do {
            ByteBuffer content = all.next();
            byte[] bytes = new byte[content.remaining()];
            content.get(bytes);
            chunks.add(new Chunk(all.type(), bytes));
        } while (!all.type().equals("IEND"));
        return chunks;
    }

    private static byte[] joined(List<byte[]> parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        parts.forEach(all::writeBytes);
        return all.toByteArray();
    }

    private static byte[] data(byte[] png) throws IOException {
        return joined(chunks(png).stream()
                .filter(c -> c.type.equals("IDAT"))
                .map(Chunk::content)
                .toList());
    }

    @Test
    void everyFramesDataIsThatOfItsFileUnderOneSequenceOfNumbers() throws IOException {
        List<byte[]> frames = List.of(frame(0, WIDTH, 8), frame(1, WIDTH, 8), frame(2, WIDTH, 8));
        List<List<byte[]>> found = new ArrayList<>();
        int sequence = 0;
        for (Chunk chunk : chunks(film(frames))) {
            ByteBuffer content = ByteBuffer.wrap(chunk.content);
            switch (chunk.type) {
                case "acTL" -> assertEquals(List.of(3, 0), List.of(content.getInt(), content.getInt()));
                case "fcTL" -> {
                    assertEquals(sequence++, content.getInt());
                    assertEquals(
                            List.of(WIDTH, HEIGHT, 0, 0),
                            List.of(content.getInt(), content.getInt(), content.getInt(), content.getInt()));
                    assertEquals(List.of(125, 2997), List.of((int) content.getShort(), (int) content.getShort()));
                    assertEquals(0, content.getShort(), "disposal and blending");
                    found.add(new ArrayList<>());
                }
                case "IDAT" -> found.get(found.size() - 1).add(chunk.content);
                case "fdAT" -> {
                    assertEquals(sequence++, content.getInt());
                    byte[] rest = new byte[content.remaining()];
                    content.get(rest);
                    found.get(found.size() - 1).add(rest);
                }
                default -> {}
            }
        }
        assertEquals(frames.size(), found.size());
        for (int i = 0; i < frames.size(); i++) {
            assertArrayEquals(data(frames.get(i)), joined(found.get(i)), "frame " + i);
        }
    }

    @Test
    void whoKnowsNothingOfAnimationSeesTheFirstFrame() throws IOException {
        byte[] first = frame(0, WIDTH, 16);
        byte[] film = film(List.of(first, frame(1, WIDTH, 16)));
        assertArrayEquals(
                RasterFiles.decode(first).components(), RasterFiles.decode(film).components());
    }

    @Test
    void onlyCommentsThatAreTrueOfTheWholeFilmAreTakenOver() throws IOException {
        byte[] film = film(List.of(frame(0, WIDTH, 8), frame(1, WIDTH, 8)));
        assertEquals(Optional.of("A film"), PngChunks.comment(film, "Title"));
        assertEquals(Optional.empty(), PngChunks.comment(film, "Settings"));
        assertEquals(Optional.empty(), PngChunks.comment(film, "Frame digest"));
    }

    @Test
    void framesOfAnotherSizeOrDepthAreRefused() throws IOException {
        byte[] first = frame(0, WIDTH, 8);
        for (byte[] other : List.of(frame(1, WIDTH + 1, 8), frame(1, WIDTH, 16))) {
            IOException e = assertThrows(IOException.class, () -> film(List.of(first, other)));
            assertEquals("it has another size or depth than the first frame", e.getMessage());
        }
    }

    /** A file that was torn off, or in which one bit fell over, says nothing of itself. */
    @Test
    void onlyAWholeFileTellsItsComments() throws IOException {
        byte[] png = frame(3, WIDTH, 8);
        assertEquals(Optional.of("3"), PngChunks.comment(png, "Frame digest"));
        for (int length = 0; length < png.length; length++) {
            assertEquals(Optional.empty(), PngChunks.comment(java.util.Arrays.copyOf(png, length), "Frame digest"));
        }
        for (int bit = 8; bit < 8 * png.length; bit++) {
            byte[] flipped = png.clone();
            flipped[bit / 8] ^= (byte) (1 << bit % 8);
            assertEquals(Optional.empty(), PngChunks.comment(flipped, "Frame digest"), "bit " + bit);
        }
    }
}
