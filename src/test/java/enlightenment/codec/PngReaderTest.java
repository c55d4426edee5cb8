package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.ImageFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PngReaderTest {
    private static final int[][] KINDS = { // colour type, depth, channels
        {0, 1, 1},
        {0, 2, 1},
        {0, 4, 1},
        {0, 8, 1},
        {0, 16, 1},
        {2, 8, 3},
        {2, 16, 3},
        {3, 1, 1},
        {3, 2, 1},
        {3, 4, 1},
        {3, 8, 1},
        {4, 8, 2},
        {4, 16, 2},
        {6, 8, 4},
        {6, 16, 4}
    };
    private static final int[][] PASSES = {
        {0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}
    };

    @TempDir
    Path folder;

    private static byte[] chunk(String type, byte[] content) {
        ByteBuffer buffer = ByteBuffer.allocate(content.length + 12);
        buffer.putInt(content.length)
                .put(type.getBytes(StandardCharsets.US_ASCII))
                .put(content);
        CRC32 crc = new CRC32();
        crc.update(buffer.array(), 4, content.length + 4);
        return buffer.putInt((int) crc.getValue()).array();
    }

    private static byte[] header(int width, int height, int depth, int type, int interlace) {
        ByteBuffer buffer = ByteBuffer.allocate(13).putInt(width).putInt(height);
        return chunk(
                "IHDR",
                buffer.put(new byte[] {(byte) depth, (byte) type, 0, 0, (byte) interlace})
                        .array());
    }

    private static byte[] join(byte[]... parts) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(PngWriter.SIGNATURE);
        for (byte[] part : parts) {
            out.writeBytes(part);
        }
        return out.toByteArray();
    }

    private static byte[] deflate(byte[] raw) {
        Deflater deflater = new Deflater();
        deflater.setInput(raw);
        deflater.finish();
        byte[] out = new byte[raw.length + 100];
        int length = deflater.deflate(out);
        deflater.end();
        return Arrays.copyOf(out, length);
    }

    /** One reduced picture after the other, each row with the next of the five filters, two IDAT chunks. */
    private static byte[] file(int[] samples, int width, int height, int[] kind, boolean interlaced, byte[] palette) {
        int channels = kind[2];
        int depth = kind[1];
        ByteArrayOutputStream raw = new ByteArrayOutputStream();
        for (int[] pass : interlaced ? PASSES : new int[][] {{0, 0, 1, 1}}) {
            int columns = Math.max(0, (width - pass[0] + pass[2] - 1) / pass[2]);
            if (columns == 0) {
                continue;
            }
            byte[] above = new byte[(columns * channels * depth + 7) / 8];
            for (int y = pass[1]; y < height; y += pass[3]) {
                byte[] row = new byte[above.length];
                int bit = 0;
                for (int x = pass[0]; x < width; x += pass[2]) {
                    for (int c = 0; c < channels; c++) {
                        int sample = samples[(y * width + x) * channels + c];
                        for (int b = depth - 1; b >= 0; b--, bit++) {
                            row[bit / 8] |= (byte) ((sample >> b & 1) << 7 - bit % 8);
                        }
                    }
                }
                raw.writeBytes(filtered(raw.size() % 5, row, above, Math.max(1, channels * depth / 8)));
                above = row;
            }
        }
        byte[] data = deflate(raw.toByteArray());
        byte[] head = header(width, height, depth, kind[0], interlaced ? 1 : 0);
        byte[] first = chunk("IDAT", Arrays.copyOf(data, data.length / 2));
        byte[] second = chunk("IDAT", Arrays.copyOfRange(data, data.length / 2, data.length));
        byte[] colors = palette == null ? new byte[0] : chunk("PLTE", palette);
        byte[] transparent = kind[0] == 3 ? chunk("tRNS", new byte[] {0, 1}) : new byte[0];
        return join(head, colors, transparent, first, second, chunk("IEND", new byte[0]));
    }

    /** The filters as the specification writes them down. */
    private static byte[] filtered(int type, byte[] row, byte[] above, int distance) {
        byte[] out = new byte[row.length + 1];
        out[0] = (byte) type;
        for (int i = 0; i < row.length; i++) {
            int a = i < distance ? 0 : row[i - distance] & 255;
            int b = above[i] & 255;
            int c = i < distance ? 0 : above[i - distance] & 255;
            int p = a + b - c;
            int pa = Math.abs(p - a);
            int pb = Math.abs(p - b);
            int pc = Math.abs(p - c);
            int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
            out[i + 1] = (byte) (row[i] - new int[] {0, a, b, (a + b) / 2, paeth}[type]);
        }
        return out;
    }

    @Test
    void everyKindOfFileIsDecodedToItsNumbers() throws IOException {
        Random random = new Random(4);
        int[][] sizes = {{1, 1}, {3, 2}, {5, 9}, {8, 8}, {17, 13}, {2, 40}};
        for (int[] kind : KINDS) {
            byte[] palette = kind[0] == 3 ? new byte[3 << kind[1]] : null;
            if (palette != null) {
                random.nextBytes(palette);
            }
            for (int[] size : sizes) {
                int[] samples = random.ints((long) size[0] * size[1] * kind[2], 0, 1 << kind[1])
                        .toArray();
                for (boolean interlaced : new boolean[] {false, true}) {
                    Raster raster = PngReader.read(file(samples, size[0], size[1], kind, interlaced, palette));
                    assertEquals(size[0], raster.width());
                    assertEquals(size[1], raster.height());
                    for (int i = 0; i < size[0] * size[1]; i++) {
                        for (int c = 0; c < 3; c++) {
                            assertEquals(
                                    expected(samples, i, c, kind, palette),
                                    component(raster, i, c),
                                    () -> Arrays.toString(kind) + Arrays.toString(size) + interlaced);
                        }
                    }
                }
            }
        }
    }

    private static int expected(int[] samples, int pixel, int c, int[] kind, byte[] palette) {
        int sample = samples[pixel * kind[2] + (kind[2] >= 3 ? c : 0)];
        if (palette != null) {
            return palette[3 * sample + c] & 255;
        }
        return kind[1] < 8 ? sample * 255 / ((1 << kind[1]) - 1) : sample;
    }

    private static int component(Raster raster, int pixel, int c) {
        return raster.deep() != null ? raster.deep()[3 * pixel + c] : raster.packed()[pixel] >> 16 - 8 * c & 255;
    }

    private String refusal(byte[] bytes) throws IOException {
        Path file = folder.resolve("damaged.png");
        Files.write(file, bytes);
        String message =
                assertThrows(IOException.class, () -> ImageFiles.read(file)).getMessage();
        assertTrue(message.startsWith("cannot read " + file + ": "), message);
        return message.substring(("cannot read " + file + ": ").length());
    }

    @Test
    void everyTruncationAndEveryFlippedBitIsNoticed() throws IOException {
        byte[] whole = file(new int[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 2, 2, KINDS[5], false, null);
        assertEquals(2, PngReader.read(whole).width());
        for (int length = 0; length < whole.length; length++) {
            refusal(Arrays.copyOf(whole, length));
        }
        for (int bit = 0; bit < 8 * whole.length; bit++) {
            byte[] damaged = whole.clone();
            damaged[bit / 8] ^= (byte) (1 << bit % 8);
            refusal(damaged);
        }
    }

    @Test
    void damageBehindMatchingChecksumsIsNoticed() throws IOException {
        byte[] end = chunk("IEND", new byte[0]);
        byte[] data = chunk("IDAT", deflate(new byte[] {0, 1, 2, 3}));
        assertEquals("its header is missing", refusal(join(data, end)));
        assertEquals("its pixels are missing", refusal(join(header(4000, 1, 8, 2, 0), end)));
        assertEquals("some of its pixels are missing", refusal(join(header(2, 2, 8, 2, 0), data, end)));
        assertEquals(
                "it is damaged: there is no filter 9",
                refusal(join(header(1, 1, 8, 2, 0), chunk("IDAT", deflate(new byte[] {9, 1, 2, 3})), end)));
        assertTrue(refusal(join(header(1, 1, 8, 2, 0), chunk("IDAT", new byte[] {1, 2, 3, 4}), end))
                .startsWith("it is damaged: "));
        assertEquals("its palette is missing", refusal(join(header(1, 1, 8, 3, 0), data, end)));
        assertEquals(
                "it is damaged: there is no colour 7 in its palette",
                refusal(join(
                        header(1, 1, 8, 3, 0),
                        chunk("PLTE", new byte[3]),
                        chunk("IDAT", deflate(new byte[] {0, 7})),
                        end)));
        assertEquals(
                "it is of an unknown kind: there is a chunk \"ABCD\"",
                refusal(join(header(1, 1, 8, 2, 0), chunk("ABCD", new byte[3]), data, end)));
        assertTrue(refusal(join(header(1, 1, 3, 2, 0), data, end)).startsWith("it is of an unknown kind: depth 3"));
        assertEquals("it has no pixels: 0 x 5", refusal(join(header(0, 5, 8, 2, 0), data, end)));
    }

    @Test
    void hugePicturesAreRefusedBeforeMemoryIsTaken() throws IOException {
        byte[] end = chunk("IEND", new byte[0]);
        byte[] data = chunk("IDAT", deflate(new byte[1000]));
        String tooMany = refusal(join(header(1 << 16, (1 << 12) + 1, 8, 2, 0), data, end));
        assertEquals("65536 x 4097 pixels are more than the 268435456 allowed", tooMany);
        refusal(join(header(Integer.MAX_VALUE, Integer.MAX_VALUE, 16, 6, 1), data, end));
        assertEquals("its pixels are missing", refusal(join(header(1 << 16, 1 << 12, 16, 6, 0), data, end)));
    }

    @Test
    void otherFilesAreRefusedByNameAndReason() throws IOException {
        assertEquals("it is empty", refusal(new byte[0]));
        assertEquals(
                "it is neither PNG, JPEG, BMP, PFM, HDR nor EXR",
                refusal("GIF89a......".getBytes(StandardCharsets.US_ASCII)));
        Path missing = folder.resolve("missing.png");
        assertEquals(
                "cannot read " + missing + ": there is no such file",
                assertThrows(IOException.class, () -> ImageFiles.read(missing)).getMessage());
        assertEquals(
                "cannot read " + folder + ": it is a folder",
                assertThrows(IOException.class, () -> ImageFiles.read(folder)).getMessage());
    }

    @Test
    void pixelsAreTheSameWhereverTheFileIsCut() throws IOException {
        // Many tiny IDAT chunks: the decoder is fed byte by byte.
        byte[] data = deflate(new byte[] {0, 10, 20, 30, 40, 50, 60});
        byte[][] parts = new byte[data.length + 2][];
        parts[0] = header(2, 1, 8, 2, 0);
        for (int i = 0; i < data.length; i++) {
            parts[i + 1] = chunk("IDAT", new byte[] {data[i]});
        }
        parts[data.length + 1] = chunk("IEND", new byte[0]);
        assertArrayEquals(
                new int[] {0x0a141e, 0x28323c}, PngReader.read(join(parts)).packed());
    }
}
