package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.math.InvalidValueException;
import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ImageErrorTest {
    @Test
    void equalImagesHaveNoError() {
        Image image = TestImages.noise(7, 5, 1);
        ImageError error = ImageError.between(image, image);
        assertEquals(new ImageError(0, 0, 0, new ImageError.Largest(0, 0, 0, 0)), error);
        assertEquals(0, error.rmse());
        assertEquals(Double.POSITIVE_INFINITY, error.psnr());
    }

    @Test
    void aConstantDifferenceIsEveryError() {
        // All of these are exact in binary but the hundredth.
        ImageError error =
                ImageError.between(TestImages.uniform(8, 4, 0.75, 0.75, 0.75), TestImages.uniform(8, 4, 0.5, 0.5, 0.5));
        assertEquals(0.0625, error.meanSquaredError());
        assertEquals(0.25, error.rmse());
        assertEquals(0.25, error.meanAbsoluteError());
        assertEquals(0.0625 / 0.26, error.relativeMeanSquaredError(), 1e-16);
        assertEquals(12.041199826559248, error.psnr(), 1e-14); // 20 log₁₀ 4
        assertEquals(new ImageError.Largest(0.25, 0, 0, 0), error.largest());
    }

    @Test
    void oneComponentOfMany() {
        float[] rgb = new float[3 * 20 * 10];
        rgb[3 * (7 * 20 + 13) + 2] = 1;
        ImageError error = ImageError.between(new Image(20, 10, rgb), TestImages.uniform(20, 10, 0, 0, 0));
        assertEquals(1.0 / 600, error.meanSquaredError());
        assertEquals(1.0 / 600, error.meanAbsoluteError());
        assertEquals(100.0 / 600, error.relativeMeanSquaredError(), 1e-16);
        assertEquals(new ImageError.Largest(1, 13, 7, 2), error.largest());
        assertEquals("blue", error.largest().channelName());
        assertEquals(10 * Math.log10(600), error.psnr(), 1e-13);
    }

    @Test
    void onlyTheRelativeErrorKnowsWhichIsTheReference() {
        Image a = TestImages.noise(9, 6, 1);
        Image b = TestImages.uniform(9, 6, 0.25, 0.25, 0.25);
        ImageError there = ImageError.between(a, b);
        ImageError back = ImageError.between(b, a);
        assertEquals(there.meanSquaredError(), back.meanSquaredError());
        assertEquals(there.meanAbsoluteError(), back.meanAbsoluteError());
        assertEquals(there.largest(), back.largest());
        assertEquals(there.meanSquaredError() / 0.0725, there.relativeMeanSquaredError(), 1e-14);
    }

    @Test
    void sumsLoseNothing() {
        Image a = TestImages.noise(200, 150, 1);
        Image b = TestImages.noise(200, 150, 2);
        BigDecimal squares = BigDecimal.ZERO;
        float[] as = a.toArray();
        float[] bs = b.toArray();
        for (int i = 0; i < as.length; i++) {
            BigDecimal difference = new BigDecimal(as[i]).subtract(new BigDecimal(bs[i]));
            squares = squares.add(difference.multiply(difference));
        }
        double expected =
                squares.divide(new BigDecimal(as.length), MathContext.DECIMAL64).doubleValue();
        // Each square is rounded once, then the sum and the quotient.
        assertEquals(expected, ImageError.between(a, b).meanSquaredError(), 3 * Math.ulp(expected));
    }

    @Test
    void sizesMustBeEqual() {
        InvalidValueException e = assertThrows(
                InvalidValueException.class,
                () -> ImageError.between(TestImages.uniform(4, 3, 0, 0, 0), TestImages.uniform(3, 4, 0, 0, 0)));
        assertEquals("size", e.key());
        assertEquals("size: must be that of the reference, 3x4 pixels, not 4x3", e.getMessage());
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void whatIsNoNumberIsRefusedWithItsPlace(float value) {
        float[] rgb = new float[3 * 5 * 4];
        rgb[3 * (2 * 5 + 3) + 1] = value;
        Image bad = new Image(5, 4, rgb);
        Image good = TestImages.uniform(5, 4, 0, 0, 0);
        InvalidValueException e = assertThrows(InvalidValueException.class, () -> ImageError.between(bad, good));
        assertEquals("test", e.key());
        assertEquals("test: there is " + value + " in column 3, row 2, green", e.getMessage());
        e = assertThrows(InvalidValueException.class, () -> ImageError.between(good, bad));
        assertEquals("reference", e.key());
    }
}
