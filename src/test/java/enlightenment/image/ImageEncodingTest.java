package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.codec.PngWriter;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.flip.Flip;
import enlightenment.math.InvalidValueException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What linear light becomes in files and comparisons: the sRGB curve is applied once, at output, to linear pictures alone. */
class ImageEncodingTest {
    @TempDir
    Path folder;

    private static Image linear(float... rgb) {
        return new Image(rgb.length / 3, 1, rgb, Color.Encoding.LINEAR);
    }

    private Image throughPng(Image image) throws IOException {
        Path file = folder.resolve("a.png");
        ImageFiles.writePng(image, file, ImageFiles.PngOptions.DEFAULT);
        return ImageFiles.read(file);
    }

    @Test
    void aPictureIsDisplayReferredUnlessItSaysOtherwise() {
        assertEquals(Color.Encoding.DISPLAY, new Image(1, 1, new float[3]).encoding());
        assertEquals(Color.Encoding.LINEAR, linear(0, 0, 0).encoding());
        Image display = TestImages.noise(3, 2, 1);
        assertSame(display, display.toDisplay());
        assertEquals(display.component(2, 1, 0), display.displayed(2, 1, 0));
    }

    /** IEC 61966-2-1 in whole steps: linear 0.2140 is step 127 or 128, the line ends in step 10. */
    @Test
    void aPngFileOfLinearLightHoldsWhatAScreenTakes() throws IOException {
        for (int step = 0; step <= 255; step++) {
            double encoded = step / 255.0;
            double light = encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
            Image file = throughPng(linear((float) light, 0, 1));
            assertEquals((float) encoded, file.component(0, 0, 0));
            assertEquals(0, file.component(0, 0, 1));
            assertEquals(1, file.component(0, 0, 2));
        }
    }

    /** On both sides of every place where the exact curve goes from one step to the next, and on it. */
    @ParameterizedTest
    @CsvSource({"255, 0, CLIP", "65535, 0, CLIP", "255, 1.5, FILMIC", "65535, -2, FILMIC"})
    void wholeNumbersAreThoseOfTheExactCurve(int maximum, double exposure, DisplayCurve.Tone tone) {
        DisplayCurve curve = DisplayCurve.of(exposure, tone);
        float[] rgb = new float[3 * maximum];
        for (int step = 0; step < maximum; step++) {
            float least = 0;
            float most = 16;
            while (Math.nextUp(least) < most) {
                float middle = (least + most) / 2;
                boolean isBelow = middle == least || PngWriter.quantize((float) curve.of(middle), maximum) <= step;
                least = isBelow ? (middle == least ? Math.nextUp(least) : middle) : least;
                most = isBelow ? most : middle;
            }
            rgb[3 * step] = least;
            rgb[3 * step + 1] = Math.nextUp(least);
            rgb[3 * step + 2] = 0.5f * least;
        }
        Image image = new Image(maximum, 1, rgb, curve);
        for (int i = 0; i < rgb.length; i++) {
            float exact = image.displayed(i / 3, 0, i % 3);
            float quick = image.displayedFor(maximum, i / 3, 0, i % 3);
            assertEquals(PngWriter.quantize(exact, maximum), PngWriter.quantize(quick, maximum));
            assertEquals(exact, quick, 1.2e-6);
        }
    }

    @Test
    void whatNoScreenCanShowIsClippedInAPngFile() throws IOException {
        float[] wild = {-1, 2, Float.POSITIVE_INFINITY, Float.NaN, 1e-30f, Float.NEGATIVE_INFINITY};
        assertArrayEquals(
                new float[] {0, 1, 1, 0, 0, 0}, throughPng(linear(wild)).toArray());
        assertEquals(0xff00ffff, linear(wild).toArgb()[0]);
    }

    @Test
    void pixelsForAScreenAreThoseOfThePngFile() throws IOException {
        Image light = new Image(17, 9, TestImages.noise(17, 9, 3).toArray(), Color.Encoding.LINEAR);
        assertArrayEquals(throughPng(light).toArgb(), light.toArgb());
        assertArrayEquals(light.toDisplay().toArgb(), light.toArgb());
        assertEquals(Color.Encoding.DISPLAY, light.toDisplay().encoding());
    }

    @Test
    void aFloatMapHoldsExactlyThePicturesFloats() throws IOException {
        float[] light = {0, 1e-40f, 0.5f, 3e38f, -7, 1 / 3f};
        Path file = folder.resolve("a.pfm");
        ImageFiles.writePfm(linear(light.clone()), file);
        byte[] bytes = Files.readAllBytes(file);
        ByteBuffer floats = ByteBuffer.wrap(bytes, bytes.length - 24, 24).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : light) {
            assertEquals(value, floats.getFloat());
        }
        Image back = ImageFiles.read(file, Color.Encoding.LINEAR);
        assertEquals(Color.Encoding.LINEAR, back.encoding());
        assertArrayEquals(light, back.toArray());
        assertEquals(Color.Encoding.DISPLAY, ImageFiles.read(file).encoding());
    }

    @Test
    void aFileOfWholeNumbersHoldsNoLinearLight() throws IOException {
        Path file = folder.resolve("a.png");
        ImageFiles.writePng(TestImages.noise(2, 2, 1), file);
        IOException e = assertThrows(IOException.class, () -> ImageFiles.read(file, Color.Encoding.LINEAR));
        assertTrue(e.getMessage().contains("no linear light"), e.getMessage());
    }

    @Test
    void linearLightIsNotComparedWithWhatAScreenTakes() {
        Image light = linear(0.5f, 0.5f, 0.5f);
        Image display = light.toDisplay();
        assertEquals(
                "encoding",
                assertThrows(InvalidValueException.class, () -> ImageError.between(light, display))
                        .key());
        assertEquals(
                "encoding",
                assertThrows(InvalidValueException.class, () -> Flip.between(display, light))
                        .key());
        assertEquals(
                0.25, ImageError.between(light, linear(0.75f, 0.75f, 0.75f)).rmse());
    }

    @Test
    void flipJudgesWhatAScreenShows() {
        Image a = new Image(12, 8, TestImages.noise(12, 8, 5).toArray(), Color.Encoding.LINEAR);
        float[] brighter = a.toArray();
        for (int i = 0; i < brighter.length; i++) {
            brighter[i] *= 2;
        }
        Image b = new Image(12, 8, brighter, Color.Encoding.LINEAR);
        Flip light = Flip.between(a, b);
        assertEquals(Flip.between(a.toDisplay(), b.toDisplay()).mean(), light.mean());
        assertTrue(light.mean() > 0);
        assertTrue(Arrays.equals(b.toArray(), brighter), "nothing was changed");
    }
}
