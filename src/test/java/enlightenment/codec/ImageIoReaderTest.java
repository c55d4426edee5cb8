package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ImageIoReaderTest {
    @TempDir
    Path folder;

    private static byte[] encode(BufferedImage image, String format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertTrue(ImageIO.write(image, format, out));
        return out.toByteArray();
    }

    private Raster read(byte[] bytes) throws IOException {
        return RasterFiles.read(Files.write(folder.resolve("picture"), bytes), RasterFiles::decode);
    }

    @Test
    void bitmapsComeBackExactly() throws IOException {
        BufferedImage image = new BufferedImage(13, 7, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(1);
        for (int i = 0; i < 13 * 7; i++) {
            image.setRGB(i % 13, i / 13, random.nextInt(1 << 24));
        }
        Raster raster = read(encode(image, "bmp"));
        assertEquals(13, raster.width());
        for (int i = 0; i < 13 * 7; i++) {
            assertEquals(image.getRGB(i % 13, i / 13) & 0xffffff, raster.packed()[i]);
        }
    }

    @Test
    void bitmapsWithAPaletteComeBackExactly() throws IOException {
        BufferedImage image = new BufferedImage(9, 5, BufferedImage.TYPE_BYTE_INDEXED);
        for (int i = 0; i < 45; i++) {
            image.setRGB(i % 9, i / 9, 0xff000000 | i * 0x050301);
        }
        Raster raster = read(encode(image, "bmp"));
        for (int i = 0; i < 45; i++) {
            assertEquals(image.getRGB(i % 9, i / 9) & 0xffffff, raster.packed()[i]);
        }
    }

    @Test
    void greyPhotographsKeepTheirNumbers() throws IOException {
        BufferedImage image = new BufferedImage(32, 8, BufferedImage.TYPE_BYTE_GRAY);
        for (int x = 0; x < 32; x++) {
            for (int y = 0; y < 8; y++) {
                image.getRaster().setSample(x, y, 0, x / 8 * 60 + 20); // constant in each block of 8 x 8: no loss
            }
        }
        Raster raster = read(encode(image, "jpeg"));
        for (int i = 0; i < 32 * 8; i++) {
            int expected = i % 32 / 8 * 60 + 20;
            int packed = raster.packed()[i];
            assertEquals(expected, packed & 255, 1);
            assertEquals(0x010101 * (packed & 255), packed);
        }
    }

    @Test
    void colourPhotographsAreReadAsRedGreenBlue() throws IOException {
        BufferedImage image = new BufferedImage(32, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 32 * 16; i++) {
            image.setRGB(i % 32, i / 32, i % 32 < 16 ? 0xe02040 : 0x20c0f0);
        }
        Raster raster = read(encode(image, "jpeg"));
        for (int i = 0; i < 32 * 16; i++) {
            if (i % 32 / 2 == 7 || i % 32 / 2 == 8) {
                continue; // JPEG keeps hues at half resolution: they mix where the colours meet
            }
            int expected = i % 32 < 16 ? 0xe02040 : 0x20c0f0;
            for (int shift = 0; shift < 24; shift += 8) {
                assertEquals(expected >> shift & 255, raster.packed()[i] >> shift & 255, 3);
            }
        }
    }

    @Test
    void damagedFilesGiveAMessageThatNamesThemOrPixelsButNothingElse() throws IOException {
        BufferedImage image = new BufferedImage(24, 24, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 576; i++) {
            image.setRGB(i % 24, i / 24, i * 0x12345);
        }
        Path file = folder.resolve("picture");
        Random random = new Random(8);
        for (String format : new String[] {"jpeg", "bmp"}) {
            byte[] whole = encode(image, format);
            for (int i = 0; i < 300; i++) {
                byte[] damaged = whole.clone();
                damaged[2 + random.nextInt(i < 200 ? 60 : damaged.length - 2)] = (byte) random.nextInt(256);
                try {
                    read(damaged);
                } catch (IOException e) {
                    assertTrue(e.getMessage().startsWith("cannot read " + file + ": "), e.getMessage());
                }
            }
            for (int length : new int[] {3, 20, 60, whole.length / 2, whole.length - 30}) {
                byte[] cut = Arrays.copyOf(whole, length);
                String message = assertThrows(IOException.class, () -> read(cut), format + " cut to " + length)
                        .getMessage();
                assertTrue(message.startsWith("cannot read " + file + ": ") && !message.endsWith("null"), message);
            }
        }
    }

    private static byte[] photograph(boolean isProgressive) throws IOException {
        BufferedImage image = new BufferedImage(96, 64, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(7);
        for (int i = 0; i < 96 * 64; i++) {
            image.setRGB(i % 96, i / 96, random.nextInt(1 << 24));
        }
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageWriteParam param = writer.getDefaultWriteParam();
        if (isProgressive) {
            param.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
        }
        writer.setOutput(new MemoryCacheImageOutputStream(out));
        writer.write(null, new IIOImage(image, null, null), param);
        ((MemoryCacheImageOutputStream) writer.getOutput()).flush();
        writer.dispose();
        return out.toByteArray();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void photographsThatWereCutAreRefusedWhereverThatWas(boolean isProgressive) throws IOException {
        byte[] whole = photograph(isProgressive);
        assertEquals(96, read(whole).width());
        for (int k = 1; k <= 64; k++) {
            byte[] cut = Arrays.copyOf(whole, (int) ((long) whole.length * k / 65));
            assertTrue(assertThrows(IOException.class, () -> read(cut))
                    .getMessage()
                    .startsWith("cannot read "));
        }
        byte[] lacksItsEnd = Arrays.copyOf(whole, whole.length - 2);
        String message =
                assertThrows(IOException.class, () -> read(lacksItsEnd)).getMessage();
        assertTrue(message.endsWith("it ends too early, in the middle of its pixels"), message);
    }

    @Test
    void noRefusalOfABitmapShowsAClassOfJava() throws IOException {
        byte[] whole = encode(new BufferedImage(3, 3, BufferedImage.TYPE_INT_RGB), "bmp");
        for (int at = 2; at < 54; at++) {
            for (int value : new int[] {0, 1, 3, 12, 127, 128, 255}) {
                byte[] changed = whole.clone();
                changed[at] = (byte) value;
                try {
                    read(changed);
                } catch (IOException e) {
                    assertTrue(!e.getMessage().contains("java."), e.getMessage());
                }
            }
        }
    }
}
