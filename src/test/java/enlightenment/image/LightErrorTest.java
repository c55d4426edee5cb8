package enlightenment.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.math.InvalidValueException;
import org.junit.jupiter.api.Test;

class LightErrorTest {
    private static Image image(float... rgb) {
        return new Image(rgb.length / 3, 1, rgb, Color.Encoding.LINEAR);
    }

    @Test
    void theFiguresAreThoseOfTheirDefinitions() {
        Image reference = image(1, 2, 0, 3, 2, 0);
        Image test = image(1.5f, 2, 0.25f, 3, 1, 0);
        ImageError.OfLight error = ImageError.OfLight.between(test, reference);
        assertEquals(Math.sqrt((0.25 + 0.0625 + 1) / 6), error.rmse(), 1e-15);
        // Means 2, 2, 0; squares of their twentieths .01, .01, 0.
        assertEquals(Double.POSITIVE_INFINITY, error.relative());
        Image lit = image(1, 2, 4, 3, 2, 4);
        Image other = image(1.5f, 2, 3, 3, 1, 4);
        double relative = Math.sqrt((0.25 / 1.01 + 1 / (16 + 0.04) + 1 / 4.01) / 6);
        assertEquals(relative, ImageError.OfLight.between(other, lit).relative(), 1e-15);
        assertEquals(2.25 / 2, ImageError.OfLight.between(other, lit).red(), 1e-15);
        assertEquals(1.5 / 2, ImageError.OfLight.between(other, lit).green(), 1e-15);
        assertEquals(3.5 / 4, ImageError.OfLight.between(other, lit).blue(), 1e-15);
    }

    @Test
    void equalPicturesDifferByNothingEvenWhereTheyAreBlack() {
        Image image = image(0, 1, 0, 0, 2, 0);
        ImageError.OfLight error = ImageError.OfLight.between(image, image);
        assertEquals(0, error.relative());
        assertEquals(0, error.rmse());
        assertEquals(1, error.green());
        assertTrue(Double.isNaN(error.red()));
    }

    @Test
    void onlyLinearLightIsCompared() {
        Image display = new Image(1, 1, new float[3]);
        assertThrows(IllegalArgumentException.class, () -> ImageError.OfLight.between(display, display));
        assertThrows(InvalidValueException.class, () -> ImageError.OfLight.between(image(1, 1, 1), display));
        assertThrows(
                InvalidValueException.class, () -> ImageError.OfLight.between(image(1, Float.NaN, 1), image(1, 1, 1)));
    }
}
