package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class ImageTest {
    private static final float NAN = Float.NaN;

    @Test
    void pixelsForAScreenAreLimitedRoundedAndOpaque() {
        float[] rgb = {0, 0.5f, 1, -3, 7, NAN, 1 / 255f, 254.4f / 255, 254.6f / 255};
        assertArrayEquals(new int[] {0xff0080ff, 0xff00ff00, 0xff01feff}, new Image(1, 3, rgb.clone()).toArgb());
        assertArrayEquals(new int[] {0xff0080ff, 0xff00ff00, 0xff01feff}, new Image(3, 1, rgb.clone()).toArgb());
    }

    @Test
    void pixelsForAScreenAreThoseOfThePngFile() throws IOException {
        Image image = TestImages.noise(17, 9, 3);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageFiles.toPng(image, png, ImageFiles.PngOptions.DEFAULT);
        BufferedImage decoded = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
        assertArrayEquals(decoded.getRGB(0, 0, 17, 9, null, 0, 17), image.toArgb());
    }

    /** Light below 0 is of a colour that no screen has; the curve's fraction has poles there, beyond which it is bright. */
    @Test
    void negativeLightIsBlackInAFileOfTheFilmicTone() throws IOException {
        float[] rgb = new float[3 * 64];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = -0.005f * (i + 1);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageFiles.toPng(
                new Image(64, 1, rgb, DisplayCurve.of(2, DisplayCurve.Tone.FILMIC)),
                png,
                ImageFiles.PngOptions.DEFAULT);
        BufferedImage decoded = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
        for (int x = 0; x < 64; x++) {
            assertEquals(0xff000000, decoded.getRGB(x, 0), "pixel " + x);
        }
    }

    @Test
    void componentsStandRowByRowAndTheArrayThatIsReturnedIsACopy() {
        Image image = new Image(2, 2, new float[] {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
        assertEquals(4, image.component(1, 0, 1));
        assertEquals(8, image.component(0, 1, 2));
        image.toArray()[0] = 99;
        assertEquals(0, image.component(0, 0, 0));
    }

    @Test
    void anArrayOfAnotherLengthIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Image(2, 2, new float[11]));
        assertThrows(IllegalArgumentException.class, () -> new Image(0, 2, new float[0]));
        assertThrows(NullPointerException.class, () -> new Image(1, 1, null));
        assertThrows(NullPointerException.class, () -> new Image(1, 1, new float[3], (Color.Encoding) null));
        // 3 · 2^16 · 2^16 is a multiple of 2^32: only longs tell it from nothing.
        assertThrows(IllegalArgumentException.class, () -> new Image(1 << 16, 1 << 16, new float[0]));
    }
}
