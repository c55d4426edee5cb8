package enlightenment.status;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import enlightenment.color.Color;
import enlightenment.image.Image;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

class QuickPngTest {
    @Test
    void thePixelsAreThoseOfTheFileThatWillBeWritten() throws Exception {
        Random random = new Random(1);
        for (int[] size : new int[][] {{1, 1}, {1, 7}, {7, 1}, {33, 20}, {300, 100}}) {
            for (Color.Encoding encoding : Color.Encoding.values()) {
                float[] rgb = new float[3 * size[0] * size[1]];
                for (int i = 0; i < rgb.length; i++) {
                    rgb[i] = 1.5F * random.nextFloat() - 0.2F;
                }
                Image image = new Image(size[0], size[1], rgb, encoding);
                BufferedImage read = ImageIO.read(new ByteArrayInputStream(QuickPng.of(image)));
                assertArrayEquals(image.toArgb(), read.getRGB(0, 0, size[0], size[1], null, 0, size[0]));
            }
        }
    }
}
