package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that a few lines of Python wrote by the published layout, and that Mitsuba 3.9.1 reads as the same numbers. */
class ExrReaderTest {
    static final int WIDTH = 12;
    static final int HEIGHT = 20;

    static byte[] file(String name) throws IOException {
        try (InputStream in = ExrReaderTest.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    /** What all of the pictures show: numbers that halves hold exactly. */
    static float expected(int x, int y, int band) {
        return switch (band) {
            case 0 -> (float) Math.pow(2, x % 8 - 4);
            case 1 -> y + 1;
            default -> Math.floorDiv(x + y, 5) / 8f;
        };
    }

    @ParameterizedTest
    @ValueSource(strings = {"none-float.exr", "rle-half.exr", "zips-float.exr", "zip-half.exr", "piz.exr"})
    void everyNumberIsRead(String name) throws IOException {
        Raster raster = RasterFiles.decode(file(name));
        assertEquals(WIDTH, raster.width());
        assertEquals(HEIGHT, raster.height());
        for (int i = 0; i < raster.floats().length; i++) {
            assertEquals(expected(i / 3 % WIDTH, i / 3 / WIDTH, i % 3), raster.floats()[i]);
        }
    }

    /** PIZ and PXR24 by the OpenEXR library, which wrote the same numbers in ZIP, too: {@code openexr/make.py}. */
    @ParameterizedTest
    @ValueSource(
            strings = {"half-piz", "float-piz", "mixed-piz", "many-piz", "half-pxr24", "float-pxr24", "mixed-pxr24"})
    void anyCodeHoldsTheNumbersOfTheZipFile(String name) throws IOException {
        float[] zip = RasterFiles.decode(file("openexr/" + name.substring(0, name.indexOf('-')) + "-zip.exr"))
                .floats();
        byte[] packed = file("openexr/" + name + ".exr");
        float[] found = RasterFiles.decode(packed).floats();
        int bytesPerPixel = name.startsWith("many") ? 2 : name.startsWith("half") ? 6 : 12;
        // What became no shorter would stand as it is, and show nothing of the code.
        assertTrue(packed.length < bytesPerPixel * (zip.length / 3), "not packed");
        for (int i = 0; i < zip.length; i++) {
            boolean isCut = name.equals("float-pxr24") || name.equals("mixed-pxr24") && i % 3 == 1;
            int bits = Float.floatToRawIntBits(zip[i]);
            int expected = isCut ? bits + 0x80 & ~0xff : bits;
            assertEquals(expected, Float.floatToRawIntBits(found[i]), name + " " + i);
        }
    }

    private static String refusal(byte[] file) {
        return assertThrows(IOException.class, () -> RasterFiles.decode(file)).getMessage();
    }

    private static byte[] with(byte[] file, int at, int value) {
        byte[] changed = file.clone();
        changed[at] = (byte) value;
        return changed;
    }

    private static int find(byte[] file, String text) {
        return new String(file, java.nio.charset.StandardCharsets.ISO_8859_1).indexOf(text);
    }

    @Test
    void whatCannotBeReadIsRefusedByName() throws IOException {
        byte[] zip = file("zip-half.exr");
        int code = find(zip, "compression\0compression\0") + 24 + 4;
        assertEquals(
                "compression B44 cannot be read, only NONE, RLE, ZIPS, ZIP, PIZ and PXR24",
                refusal(with(zip, code, 6)));
        assertEquals(
                "compression DWAB cannot be read, only NONE, RLE, ZIPS, ZIP, PIZ and PXR24",
                refusal(with(zip, code, 9)));
        assertEquals(
                "compression number 77 cannot be read, only NONE, RLE, ZIPS, ZIP, PIZ and PXR24",
                refusal(with(zip, code, 77)));
        assertEquals("OpenEXR files of tiles cannot be read, only one part of scan lines", refusal(with(zip, 5, 2)));
        assertEquals(
                "OpenEXR files of deep pixels cannot be read, only one part of scan lines", refusal(with(zip, 5, 8)));
        assertEquals(
                "OpenEXR files of several parts cannot be read, only one part of scan lines",
                refusal(with(zip, 5, 16)));
        assertEquals("version 3 of OpenEXR cannot be read, only 2", refusal(with(zip, 4, 3)));
        assertTrue(refusal(with(zip, find(zip, "B\0"), 'Z')).startsWith("it has neither channels R, G and B nor Y"));
    }

    @Test
    void aFewBytesThatClaimALargePictureTakeNoMemory() throws IOException {
        byte[] zip = file("zip-half.exr");
        int box = find(zip, "dataWindow\0box2i\0") + 17 + 4;
        ByteBuffer.wrap(zip)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(box + 8, 16383)
                .putInt(box + 12, 16383);
        assertTrue(refusal(zip).contains("it ends in the table of its 1024 chunks")
                || refusal(zip).contains("too few"));
        ByteBuffer.wrap(zip)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(box + 8, (1 << 23) - 1)
                .putInt(box + 12, 15);
        assertTrue(refusal(zip).contains("bytes are too few for 8388608 x 16 pixels"), refusal(zip));
        ByteBuffer.wrap(zip).order(ByteOrder.LITTLE_ENDIAN).putInt(box + 8, -9);
        assertTrue(refusal(zip).startsWith("it has no pixels"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "none-float.exr",
                "rle-half.exr",
                "zips-float.exr",
                "zip-half.exr",
                "openexr/half-piz.exr",
                "openexr/mixed-piz.exr",
                "openexr/half-pxr24.exr",
                "new-rle.hdr",
                "plain.hdr"
            })
    void damageIsToldAndNothingElse(String name) throws IOException {
        byte[] whole = file(name);
        for (int length = 4; length < whole.length; length += 7) {
            byte[] part = Arrays.copyOf(whole, length);
            String message = refusal(part);
            assertTrue(message != null && !message.isEmpty());
        }
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 3000; i++) {
            byte[] changed = whole.clone();
            for (int k = 0; k < 1 + i % 4; k++) {
                changed[4 + random.nextInt(whole.length - 4)] = (byte) random.nextInt();
            }
            try {
                RasterFiles.decode(changed);
            } catch (IOException e) {
                assertTrue(e.getMessage() != null, "damage " + i);
            }
        }
    }
}
