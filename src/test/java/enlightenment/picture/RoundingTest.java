package enlightenment.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RoundingTest {
    @TempDir
    Path folder;

    private static Image random(int width, int height, double lo, double hi) {
        SplittableRandom random = new SplittableRandom(5);
        float[] rgb = new float[3 * width * height];
        for (int k = 0; k < rgb.length; k++) {
            rgb[k] = (float) random.nextDouble(lo, hi);
        }
        return new Image(width, height, rgb);
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void evenlySpreadValuesChangeByTheTwelfthRootOfAStep(int depth) {
        double step = 1.0 / ((1 << depth) - 1);
        // The mean of 120,000 squares of relative deviation √(4/5).
        assertEquals(1, Rounding.of(random(200, 200, 0, 1), depth) / (step / Math.sqrt(12)), 0.008);
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void itIsTheDifferenceToTheFileThatIsWritten(int depth) throws IOException {
        Image image = random(40, 30, -0.2, 1.2);
        Path file = folder.resolve("p.png");
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageFiles.toPng(image, bytes, new ImageFiles.PngOptions(depth, java.util.Map.of()));
        Files.write(file, bytes.toByteArray());
        Image read = ImageFiles.read(file);
        double sum = 0;
        for (int k = 0; k < 3 * 40 * 30; k++) {
            double shown = Math.min(Math.max(image.toArray()[k], 0), 1);
            sum += (read.toArray()[k] - shown) * (read.toArray()[k] - shown);
        }
        // What is read are floats.
        assertEquals(Math.sqrt(sum / (3 * 40 * 30)), Rounding.of(image, depth), 1e-7);
    }

    @Test
    void nothingIsRoundedInFloatsNorWhatIsExact() {
        assertEquals(0, Rounding.of(random(9, 9, 0, 1), 0));
        assertEquals(0, Rounding.of(new Image(3, 2, new float[18]), 8));
        assertEquals(0, Rounding.square(1, 8));
        assertEquals(0, Rounding.square(7.5f, 8));
        assertEquals(0, Rounding.square(-1, 16));
        assertEquals(0.25 / (255.0 * 255), Rounding.square(0.5f, 8), 1e-18);
    }
}
