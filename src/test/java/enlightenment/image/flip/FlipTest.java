package enlightenment.image.flip;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.TestImages;
import enlightenment.math.InvalidValueException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FlipTest {
    @Test
    void greenAgainstBlueIsTheLargestDifference() {
        Flip flip = Flip.between(TestImages.uniform(5, 4, 0, 1, 0), TestImages.uniform(5, 4, 0, 0, 1));
        // Evenly coloured: filters change nothing but the last digits, and there is no feature.
        assertEquals(1, flip.mean(), 1e-7);
        assertEquals(1, flip.largest(), 1e-7);
    }

    @Test
    void evenGreysDifferByTheirLightnessOnly() {
        // CIELAB without chroma: linear 0.18 has L* = 116·0.18^(1/3) − 16, and Hunt's effect has nothing to scale.
        double encoded = 1.055 * Math.pow(0.18, 1 / 2.4) - 0.055;
        double lightness = 116 * Math.cbrt(0.18) - 16;
        double largest = Math.pow(greenToBlue(), 0.7);
        Flip flip =
                Flip.between(TestImages.uniform(3, 3, encoded, encoded, encoded), TestImages.uniform(3, 3, 0, 0, 0));
        double power = Math.pow(lightness, 0.7);
        assertTrue(power < 0.4 * largest);
        // The textbook's four digits.
        assertEquals(0.95 * power / (0.4 * largest), flip.mean(), 1e-4);
        Flip white = Flip.between(TestImages.uniform(3, 3, 1, 1, 1), TestImages.uniform(3, 3, 0, 0, 0));
        double beyond = (Math.pow(100, 0.7) - 0.4 * largest) / (0.6 * largest);
        assertEquals(0.95 + 0.05 * beyond, white.mean(), 1e-5);
    }

    /** From the textbook's matrix of sRGB and its white, four digits each. */
    private static double greenToBlue() {
        double[] green = lab(0.3576 / 0.9505, 0.7152, 0.1192 / 1.0890);
        double[] blue = lab(0.1805 / 0.9505, 0.0722, 0.9505 / 1.0890);
        return Math.abs(green[0] - blue[0]) + Math.hypot(green[1] - blue[1], green[2] - blue[2]);
    }

    private static double[] lab(double x, double y, double z) {
        double lightness = 116 * Math.cbrt(y) - 16;
        return new double[] {
            lightness,
            lightness / 100 * 500 * (Math.cbrt(x) - Math.cbrt(y)),
            lightness / 100 * 200 * (Math.cbrt(y) - Math.cbrt(z))
        };
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.5, 67.02, 1000})
    void equalImagesDoNotDiffer(double pixelsPerDegree) {
        Flip flip = Flip.between(TestImages.noise(17, 9, 1), TestImages.noise(17, 9, 1), pixelsPerDegree);
        assertEquals(0, flip.mean());
        assertEquals(0, flip.largest());
    }

    @Test
    void neitherImageIsTheFirst() {
        Flip there = Flip.between(TestImages.noise(33, 21, 1), TestImages.noise(33, 21, 2));
        Flip back = Flip.between(TestImages.noise(33, 21, 2), TestImages.noise(33, 21, 1));
        assertEquals(there.mean(), back.mean());
        assertArrayEquals(errors(there), errors(back));
    }

    @Test
    void aMirroredPairHasTheMirroredErrors() {
        Flip flip = Flip.between(TestImages.noise(33, 21, 1), TestImages.noise(33, 21, 2));
        Flip mirrored = Flip.between(rotated(TestImages.noise(33, 21, 1)), rotated(TestImages.noise(33, 21, 2)));
        for (int y = 0; y < 21; y++) {
            for (int x = 0; x < 33; x++) {
                // The sums run the other way; features near 0 show that as the root of the last digits.
                assertEquals(flip.error(x, y), mirrored.error(32 - x, 20 - y), 1e-7);
            }
        }
    }

    @Test
    void theMeanIsThatOfTheMapAndAllErrorsAreInTheirRange() {
        for (double pixelsPerDegree : new double[] {1, 30, 200}) {
            Flip flip = Flip.between(TestImages.noise(40, 30, 3), TestImages.noise(40, 30, 4), pixelsPerDegree);
            double sum = 0;
            float largest = 0;
            for (float e : errors(flip)) {
                assertTrue(e >= 0 && e <= 1, "" + e);
                sum += e;
                largest = Math.max(largest, e);
            }
            assertEquals(sum / 1200, flip.mean(), 1e-7);
            assertEquals(largest, flip.largest());
        }
    }

    @Test
    void fromFarAwayNoiseIsSeenLess() {
        Image grey = TestImages.uniform(64, 64, 0.5, 0.5, 0.5);
        Image noisy = TestImages.noise(64, 64, 5);
        double near = Flip.between(noisy, grey, 20).mean();
        double far = Flip.between(noisy, grey, 200).mean();
        assertTrue(far < 0.8 * near, far + " " + near);
    }

    @Test
    void theDefaultIsThatOfThePaper() {
        assertEquals(67.02, Flip.DEFAULT_PIXELS_PER_DEGREE, 0.005);
        assertEquals(
                Flip.between(TestImages.noise(9, 9, 1), TestImages.noise(9, 9, 2), 0.7 * (3840 / 0.7) * (Math.PI / 180))
                        .mean(),
                Flip.between(TestImages.noise(9, 9, 1), TestImages.noise(9, 9, 2))
                        .mean(),
                1e-12);
    }

    @Test
    void whatAScreenCannotShowIsClipped() {
        assertEquals(
                0,
                Flip.between(TestImages.uniform(3, 3, 1.5, -1, 0.5), TestImages.uniform(3, 3, 1, 0, 0.5))
                        .mean());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, 0, 0.999, -67, 1000.1, Double.POSITIVE_INFINITY})
    void otherDensitiesAreRefused(double pixelsPerDegree) {
        Image image = TestImages.uniform(2, 2, 0, 0, 0);
        InvalidValueException e =
                assertThrows(InvalidValueException.class, () -> Flip.between(image, image, pixelsPerDegree));
        assertEquals("pixelsPerDegree: must lie in 1.0..1000.0, not " + pixelsPerDegree, e.getMessage());
    }

    @Test
    void imagesThatCannotBeComparedAreRefused() {
        Image image = TestImages.uniform(2, 2, 0, 0, 0);
        assertThrows(InvalidValueException.class, () -> Flip.between(image, TestImages.uniform(2, 3, 0, 0, 0)));
        assertThrows(
                InvalidValueException.class, () -> Flip.between(image, TestImages.uniform(2, 2, Double.NaN, 0, 0)));
    }

    /** By half a turn. */
    private static Image rotated(Image image) {
        float[] rgb = new float[3 * image.width() * image.height()];
        for (int i = 0; i < rgb.length; i++) {
            int pixel = rgb.length / 3 - 1 - i / 3;
            rgb[i] = image.component(pixel % image.width(), pixel / image.width(), i % 3);
        }
        return new Image(image.width(), image.height(), rgb);
    }

    private static float[] errors(Flip flip) {
        float[] errors = new float[flip.width() * flip.height()];
        for (int i = 0; i < errors.length; i++) {
            errors[i] = flip.error(i % flip.width(), i / flip.width());
        }
        return errors;
    }
}
