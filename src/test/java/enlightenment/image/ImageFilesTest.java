package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.codec.PngWriter;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImageFilesTest {
    @TempDir
    Path folder;

    /** Smooth with noise on a part of it; only exact operations, so that it is the same everywhere. */
    static Image picture(int width, int height) {
        float[] rgb = new float[3 * width * height];
        int noise = 1;
        for (int i = 0; i < rgb.length; i++) {
            noise = noise * 1664525 + 1013904223;
            int x = i / 3 % width;
            int y = i / 3 / width;
            float grain = (x / 16 + y / 16) % 2 == 0 ? (noise >>> 24) / 4096f : 0;
            rgb[i] = x * y % 257 / 400f + (i % 3) * 0.1f + grain;
        }
        return new Image(width, height, rgb);
    }

    @Test
    void picturesOfAllShapesComeBackThroughImageIoAndThroughOurOwnDecoder() throws IOException {
        int[][] sizes = {{1, 1}, {1, 4096}, {4096, 1}, {16384, 2}, {3, 7}, {257, 64}, {800, 500}};
        for (int[] size : sizes) {
            Image image = picture(size[0], size[1]);
            for (int depth : new int[] {8, 16}) {
                Path file = folder.resolve("a.png");
                ImageFiles.writePng(image, file, ImageFiles.PngOptions.DEFAULT.withDepth(depth));
                BufferedImage other = ImageIO.read(file.toFile());
                Image own = ImageFiles.read(file);
                int maximum = (1 << depth) - 1;
                int[] samples = other.getRaster().getPixels(0, 0, size[0], size[1], (int[]) null);
                for (int i = 0; i < samples.length; i++) {
                    int x = i / 3 % size[0];
                    int y = i / 3 / size[0];
                    int expected = (int) Math.floor((double) image.component(x, y, i % 3) * maximum + 0.5);
                    assertEquals(expected, samples[i]);
                    assertEquals((float) (expected / (double) maximum), own.component(x, y, i % 3));
                }
            }
        }
    }

    @Test
    void componentsAreLimitedAndRoundedHalfUp() {
        assertEquals(0, PngWriter.quantize(Float.NaN, 255));
        assertEquals(0, PngWriter.quantize(Float.NEGATIVE_INFINITY, 255));
        assertEquals(255, PngWriter.quantize(Float.POSITIVE_INFINITY, 255));
        assertEquals(0, PngWriter.quantize(-0.0f, 255));
        assertEquals(0, PngWriter.quantize(-0.3f, 65535));
        assertEquals(255, PngWriter.quantize(1.0001f, 255));
        assertEquals(128, PngWriter.quantize(0.5f, 255)); // 127.5
        assertEquals(127, PngWriter.quantize(Math.nextDown(0.5f), 255));
        assertEquals(32768, PngWriter.quantize(0.5f, 65535)); // 32767.5
        for (int value = 0; value <= 65535; value++) {
            assertEquals(value, PngWriter.quantize((float) (value / 65535.0), 65535));
            assertEquals(value / 257, PngWriter.quantize((float) (value / 257 / 255.0), 255));
        }
    }

    @Test
    void theBytesOfAFileAreTheSameOnEveryMachine() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.toPng(picture(640, 360), out, ImageFiles.PngOptions.DEFAULT.withText("Software", "Enlightenment"));
        ImageFiles.toPng(picture(640, 360), out, new ImageFiles.PngOptions(16, Map.of()));
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(out.toByteArray());
        // Whoever changes the encoder on purpose changes this number, and every picture that was compared by its bytes.
        assertEquals(
                "dba2b5fdea4a94eb4b97ec9542bd40d5",
                HexFormat.of().formatHex(digest).substring(0, 32));
    }

    @Test
    void commentsAreWrittenInOrderBeforeThePixels() throws IOException {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "Fire & Ice");
        text.put("Author", "Jos\u00e9");
        text.put("Comment", "\u03b1 < \u03b2 \ud83d\udd25");
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.toPng(picture(2, 2), out, new ImageFiles.PngOptions(8, text));
        ByteBuffer png = ByteBuffer.wrap(out.toByteArray(), 8, out.size() - 8);
        StringBuilder chunks = new StringBuilder();
        while (png.hasRemaining()) {
            byte[] content = new byte[png.getInt()];
            byte[] type = new byte[4];
            png.get(type).get(content).getInt();
            String name = new String(type, StandardCharsets.US_ASCII);
            chunks.append(name).append(' ');
            if (name.equals("tEXt")) {
                chunks.append(new String(content, StandardCharsets.ISO_8859_1)).append(' ');
            } else if (name.equals("iTXt")) {
                chunks.append(new String(content, StandardCharsets.UTF_8)).append(' ');
            }
        }
        assertEquals(
                "IHDR sRGB tEXt Title\0Fire & Ice tEXt Author\0Jos\u00e9 iTXt Comment\0\0\0\0\0\u03b1 < \u03b2 \ud83d\udd25 "
                        + "IDAT IEND ",
                chunks.toString());
    }

    @Test
    void unusableOptionsAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new ImageFiles.PngOptions(12, Map.of()));
        for (String keyword : new String[] {"", " a", "a ", "a  b", "a\nb", "\u03b1", "\u00a0", "x".repeat(80)}) {
            assertThrows(
                    IllegalArgumentException.class,
                    () -> ImageFiles.PngOptions.DEFAULT.withText(keyword, "text"),
                    keyword);
        }
        assertThrows(IllegalArgumentException.class, () -> ImageFiles.PngOptions.DEFAULT.withText("a", "b\0c"));
    }

    @Test
    void theExtensionChoosesTheFormat() throws IOException {
        Image image = picture(5, 4);
        ImageFiles.write(image, folder.resolve("a.PNG"), ImageFiles.PngOptions.DEFAULT);
        ImageFiles.write(image, folder.resolve("a.pfm"), ImageFiles.PngOptions.DEFAULT);
        assertEquals(5, ImageIO.read(folder.resolve("a.PNG").toFile()).getWidth());
        assertArrayEquals(
                image.toArray(), ImageFiles.read(folder.resolve("a.pfm")).toArray());
        for (String name : new String[] {"a.bmp", "png", "a.png.bak", "a"}) {
            String message = assertThrows(
                            IllegalArgumentException.class,
                            () -> ImageFiles.write(image, folder.resolve(name), ImageFiles.PngOptions.DEFAULT),
                            name)
                    .getMessage();
            assertTrue(message.contains(".png") && message.contains(".pfm"), message);
        }
    }

    @Test
    void floatsComeBackBitByBitWithTheBottomRowFirst() throws IOException {
        float[] rgb = {0f, -0f, 1f, Float.NaN, Float.POSITIVE_INFINITY, -3.4e38f, Float.MIN_VALUE, 0.1f, 1e-30f, 2, 3, 4
        };
        Path file = folder.resolve("a.pfm");
        ImageFiles.writePfm(new Image(2, 2, rgb.clone()), file);
        byte[] bytes = Files.readAllBytes(file);
        String head = "PF\n2 2\n-1.0\n";
        assertEquals(head, new String(bytes, 0, head.length(), StandardCharsets.US_ASCII));
        assertEquals(head.length() + 48, bytes.length);
        int firstFloat =
                ByteBuffer.wrap(bytes).order(java.nio.ByteOrder.LITTLE_ENDIAN).getInt(head.length());
        assertEquals(Float.floatToRawIntBits(rgb[6]), firstFloat); // the lower row comes first
        float[] back = ImageFiles.read(file).toArray();
        for (int i = 0; i < rgb.length; i++) {
            assertEquals(Float.floatToRawIntBits(rgb[i]), Float.floatToRawIntBits(back[i]));
        }
    }

    @Test
    void greyAndBigEndianFloatMapsAreRead() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(64);
        bytes.put("Pf 2 1\n1.0\n".getBytes(StandardCharsets.US_ASCII))
                .putFloat(0.25f)
                .putFloat(7);
        Path file = folder.resolve("grey.pfm");
        Files.write(file, java.util.Arrays.copyOf(bytes.array(), bytes.position()));
        assertArrayEquals(
                new float[] {0.25f, 0.25f, 0.25f, 7, 7, 7},
                ImageFiles.read(file).toArray());
    }

    @Test
    void damagedFloatMapsAreRefusedByName() throws IOException {
        Random random = new Random(2);
        String[] contents = {"PF\n2 2\n-1.0\nabc", "PF\n", "PF\nx 2\n1\n", "PF\n0 0\n1\n", "PF\n-1 5\n1\n", "PNG", "P"};
        for (String content : contents) {
            Path file = folder.resolve("damaged-" + random.nextInt(1000) + ".pfm");
            Files.writeString(file, content);
            String message = assertThrows(IOException.class, () -> ImageFiles.read(file), content)
                    .getMessage();
            assertTrue(message.startsWith("cannot read " + file + ": "), message);
        }
    }
}
