package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HdrReaderTest {
    private static byte[] file(String head, int... pixels) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(("#?RADIANCE\n" + head + "\n").getBytes(StandardCharsets.US_ASCII));
        for (int b : pixels) {
            out.write(b);
        }
        return out.toByteArray();
    }

    private static float[] read(byte[] file) throws IOException {
        return RasterFiles.decode(file).floats();
    }

    private static String refusal(byte[] file) {
        return assertThrows(IOException.class, () -> RasterFiles.decode(file)).getMessage();
    }

    private static final String FORMAT = "FORMAT=32-bit_rle_rgbe\n\n";

    /** Mitsuba 3.9.1 wrote the one by runs of components; the other has plain pixels, and two exposures of 1/2 in all. */
    @ParameterizedTest
    @CsvSource({"new-rle.hdr, 1", "plain.hdr, 2"})
    void aWholePictureIsReadAsFarAsEightBitsHoldIt(String name, float factor) throws IOException {
        Raster raster = RasterFiles.decode(ExrReaderTest.file(name));
        for (int i = 0; i < raster.floats().length; i++) {
            int y = i / 3 / ExrReaderTest.WIDTH;
            float exact = factor * ExrReaderTest.expected(i / 3 % ExrReaderTest.WIDTH, y, i % 3);
            // The largest component is at most 20: its mantissa has steps of an eighth at most.
            assertEquals(exact, raster.floats()[i], factor / 8.0);
        }
    }

    @Test
    void mantissasAreMultipliedByTheCommonPowerOfTwo() throws IOException {
        float[] rgb = read(file(FORMAT + "-Y 1 +X 2", 128, 64, 255, 129, 3, 2, 1, 0));
        assertArrayEquals(new float[] {1, 0.5f, 255 / 128f, 0, 0, 0}, rgb);
    }

    @Test
    void theOlderCodeRepeatsThePixelBefore() throws IOException {
        // Once, then 2 more; then 1 + 256 · 1 more by a second run behind the first.
        float[] rgb =
                read(file(FORMAT + "-Y 1 +X 261", 128, 0, 0, 129, 1, 1, 1, 3, 0, 128, 0, 129, 1, 1, 1, 0, 1, 1, 1, 1));
        assertEquals(3 * 261, rgb.length);
        for (int x = 0; x < 261; x++) {
            assertEquals(x < 4 ? 1f : 0f, rgb[3 * x]);
            assertEquals(x < 4 ? 0f : 1f, rgb[3 * x + 1]);
        }
    }

    @ParameterizedTest
    @CsvSource({"-Y 2 +X 2, 1, 2, 3, 4", "+Y 2 +X 2, 3, 4, 1, 2", "-Y 2 -X 2, 2, 1, 4, 3", "+Y 2 -X 2, 4, 3, 2, 1"})
    void rowsAndColumnsMayRunTheOtherWay(String size, float a, float b, float c, float d) throws IOException {
        float[] rgb = read(file(FORMAT + size, 1, 0, 0, 136, 2, 0, 0, 136, 3, 0, 0, 136, 4, 0, 0, 136));
        assertArrayEquals(new float[] {a, b, c, d}, new float[] {rgb[0], rgb[3], rgb[6], rgb[9]});
    }

    @Test
    void whatCannotBeReadIsRefusedWithItsPlace() {
        assertEquals(
                "line 2 of its head: pixels as \"32-bit_rle_xyze\" cannot be read, only as 32-bit_rle_rgbe",
                refusal(file("FORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1", 0, 0, 0, 0)));
        assertEquals("its head does not say FORMAT=32-bit_rle_rgbe", refusal(file("\n-Y 1 +X 1", 0, 0, 0, 0)));
        assertEquals(
                "line 4 of its head: \"+X 4 -Y 4\" is no size that can be read: it is written like -Y 512 +X 1024",
                refusal(file(FORMAT + "+X 4 -Y 4")));
        assertEquals("line 2 of its head: \"0\" is no exposure", refusal(file("EXPOSURE=0\n" + FORMAT + "-Y 1 +X 1")));
        assertEquals("it ends in row 1 of 2", refusal(file(FORMAT + "-Y 2 +X 1", 1, 2, 3, 4)));
        assertEquals(
                "4 bytes are too few for 20000 x 10000 pixels",
                refusal(file(FORMAT + "-Y 10000 +X 20000", 2, 2, 78, 32)));
        assertEquals("it has no pixels: 0 x 5", refusal(file(FORMAT + "-Y 5 +X 0")));
        assertEquals(
                "row 0 is damaged: a run of 100 where 8 pixels are missing",
                refusal(file(FORMAT + "-Y 1 +X 8", 2, 2, 0, 8, 228, 0)));
        assertEquals("row 0 says that it has another width", refusal(file(FORMAT + "-Y 1 +X 8", 2, 2, 0, 9, 228, 0)));
    }
}
