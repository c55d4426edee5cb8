package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.zip.DataFormatException;
import org.junit.jupiter.api.Test;

class ExrWriterTest {
    private static final int WIDTH = 19;
    private static final int HEIGHT = 37;
    private static final ExrWindow WINDOW = new ExrWindow(5, 7, WIDTH, HEIGHT, 100, 60);

    /** Not in the order of their names. */
    private static final List<ExrChannel> CHANNELS = List.of(
            new ExrChannel("R", false),
            new ExrChannel("G", true),
            new ExrChannel("depth.Z", false),
            new ExrChannel("B", false));

    /** Rows of numbers, by channel and column: smooth, but for the last rows of noise. */
    private static float[][][] picture() {
        SplittableRandom random = new SplittableRandom(11);
        float[][][] rows = new float[HEIGHT][CHANNELS.size()][WIDTH];
        for (int y = 0; y < HEIGHT; y++) {
            for (int c = 0; c < CHANNELS.size(); c++) {
                for (int x = 0; x < WIDTH; x++) {
                    rows[y][c][x] = y < 32 ? (x / 4 + y / 3 - 5) / 8f + c : Float.intBitsToFloat(random.nextInt());
                }
            }
        }
        rows[3][0][2] = Float.NaN;
        rows[3][1][2] = Float.NaN;
        rows[4][2][1] = Float.POSITIVE_INFINITY;
        rows[4][0][1] = -0f;
        return rows;
    }

    private static byte[] written(ExrWindow window, List<ExrChannel> channels, float[][][] rows) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ExrWriter writer = new ExrWriter(out, window, channels, Map.of("Software", "Größe", "A", ""));
        for (float[][] row : rows) {
            writer.add(row);
        }
        writer.finish();
        return out.toByteArray();
    }

    @Test
    void theHeadSaysWhatTheLayoutAsksFor() throws IOException, DataFormatException {
        ParsedExr exr = new ParsedExr(written(WINDOW, CHANNELS, picture()));
        assertEquals(new ArrayList<>(new TreeSet<>(exr.types.keySet())), new ArrayList<>(exr.types.keySet()));
        assertEquals(List.of(5, 7, 5 + WIDTH - 1, 7 + HEIGHT - 1), exr.integers("dataWindow"));
        assertEquals(List.of(0, 0, 99, 59), exr.integers("displayWindow"));
        assertArrayEquals(new byte[] {3}, exr.attributes.get("compression"));
        assertArrayEquals(new byte[] {0}, exr.attributes.get("lineOrder"));
        int one = Float.floatToIntBits(1);
        assertEquals(List.of(one), exr.integers("pixelAspectRatio"));
        assertEquals(List.of(0, 0), exr.integers("screenWindowCenter"));
        assertEquals(List.of(one), exr.integers("screenWindowWidth"));
        assertEquals(
                List.of("chlist", "box2i", "compression", "lineOrder", "float", "v2f", "string"),
                List.of(
                        exr.types.get("channels"),
                        exr.types.get("displayWindow"),
                        exr.types.get("compression"),
                        exr.types.get("lineOrder"),
                        exr.types.get("screenWindowWidth"),
                        exr.types.get("screenWindowCenter"),
                        exr.types.get("Software")));
        assertEquals("Größe", exr.string("Software"));
        assertEquals("", exr.string("A"));
        assertEquals(List.of("B", "G", "R", "depth.Z"), new ArrayList<>(exr.kinds.keySet()));
        assertEquals(List.of(2, 1, 2, 2), new ArrayList<>(exr.kinds.values()));
        assertEquals(List.of(0, 16, 32), exr.firstRows);
        assertEquals(1, exr.plainChunks, "noise becomes no shorter and stands as it is");
    }

    @Test
    void everyNumberIsThereAndNoneIsNotANumber() throws IOException, DataFormatException {
        float[][][] rows = picture();
        ParsedExr exr = new ParsedExr(written(WINDOW, CHANNELS, rows));
        int zeros = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int c = 0; c < CHANNELS.size(); c++) {
                for (int x = 0; x < WIDTH; x++) {
                    float value = rows[y][c][x];
                    zeros += Float.isNaN(value) ? 1 : 0;
                    int raw = Float.isNaN(value) ? 0 : Float.floatToRawIntBits(value);
                    int expected = c == 1 ? Half.of(Float.intBitsToFloat(raw)) & 0xffff : raw;
                    assertEquals(expected, exr.bits.get(CHANNELS.get(c).name())[y * WIDTH + x]);
                }
            }
        }
        assertTrue(zeros >= 2);
    }

    @Test
    void ourOwnReaderReadsThePicture() throws IOException {
        for (int height : new int[] {1, 15, 16, 17, HEIGHT}) {
            float[][][] rows = Arrays.copyOf(picture(), height);
            Raster raster =
                    RasterFiles.decode(written(new ExrWindow(0, 0, WIDTH, height, WIDTH, height), CHANNELS, rows));
            assertEquals(WIDTH, raster.width());
            assertEquals(height, raster.height());
            for (int i = 0; i < raster.floats().length; i++) {
                int c = new int[] {0, 1, 3}[i % 3];
                float value = rows[i / 3 / WIDTH][c][i / 3 % WIDTH];
                float expected = Float.isNaN(value) ? 0 : c == 1 ? Half.toFloat(Half.of(value)) : value;
                assertEquals(expected, raster.floats()[i]);
            }
        }
    }

    @Test
    void whatCannotBeAFileIsRefused() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<ExrChannel> twice = List.of(new ExrChannel("R", false), new ExrChannel("R", true));
        assertThrows(IllegalArgumentException.class, () -> new ExrWriter(out, WINDOW, twice, Map.of()));
        for (String name : List.of("channels", "dataWindow", "", "two words", "a".repeat(32))) {
            Map<String, String> texts = Map.of(name, "text");
            assertThrows(IllegalArgumentException.class, () -> new ExrWriter(out, WINDOW, CHANNELS, texts), name);
        }
        for (String name : List.of("", "ä", "a b", "a\0", "a".repeat(32))) {
            assertThrows(IllegalArgumentException.class, () -> new ExrChannel(name, true), name);
        }
        assertThrows(IllegalArgumentException.class, () -> new ExrWindow(90, 0, 11, 1, 100, 1));
        assertThrows(IllegalArgumentException.class, () -> new ExrWindow(-1, 0, 11, 1, 100, 1));
        assertThrows(IllegalArgumentException.class, () -> new ExrWindow(0, 1, 1, 1, 1, 1));
        ExrWriter writer = new ExrWriter(out, ExrWindow.whole(1, 1), ExrChannel.rgb(true), Map.of());
        assertThrows(IllegalStateException.class, writer::finish);
        writer.add(new float[3][1]);
        assertThrows(IllegalStateException.class, () -> writer.add(new float[3][1]));
        assertEquals(0, out.size());
        writer.finish();
        assertTrue(out.size() > 0);
    }
}
