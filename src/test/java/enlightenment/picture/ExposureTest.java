package enlightenment.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ExposureTest {
    private static Image grey(float... values) {
        float[] rgb = new float[3 * values.length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = values[i / 3];
        }
        return new Image(values.length, 1, rgb, Color.Encoding.LINEAR);
    }

    @Test
    void aPictureOfOneGreyBecomesMiddleGrey() {
        for (float v : new float[] {1e-20f, 0.003f, 0.18f, 5, 1e20f}) {
            double stops = Exposure.automatic(grey(v, v, v));
            // Hundredths of a stop, and the ten-thousandth of the mean.
            assertEquals(0.18, v * Math.pow(2, stops), 0.18 * 0.004);
        }
    }

    @Test
    void itIsTheGeometricMeanThatBecomesMiddleGrey() {
        double stops = Exposure.automatic(grey(0.01f, 1));
        double floor = 1e-4 * 0.505;
        double mean = Math.sqrt((0.01 + floor) * (1 + floor));
        assertEquals(Math.log(0.18 / mean) / Math.log(2), stops, 0.005);
        assertEquals(stops, Math.rint(100 * stops) / 100);
    }

    @Test
    void greenCountsMoreThanBlue() {
        double green = Exposure.automatic(new Image(1, 1, new float[] {0, 1, 0}, Color.Encoding.LINEAR));
        double blue = Exposure.automatic(new Image(1, 1, new float[] {0, 0, 1}, Color.Encoding.LINEAR));
        assertEquals(Math.log(0.7152 / 0.0722) / Math.log(2), blue - green, 0.011);
    }

    @Test
    void blackAndWhatIsNoNumberHaveNoSay() {
        assertEquals(0, Exposure.automatic(grey(0, 0)));
        assertEquals(
                Exposure.automatic(grey(0.2f, 0, 0)),
                Exposure.automatic(grey(0.2f, Float.NaN, Float.POSITIVE_INFINITY)));
        double alone = Exposure.automatic(grey(0.2f, 0.4f));
        assertEquals(alone, Exposure.automatic(grey(0.2f, 0, 0.4f, 0, 0, 0)));
        assertEquals(alone, Exposure.automatic(grey(0.2f, Float.NaN, Float.POSITIVE_INFINITY, 0.4f)));
    }

    @Test
    void theMeanOfWhatIsShownFollowsTheCurve() {
        Image image = grey(0, 0.25f, 4);
        assertEquals((TransferCurve.encode(0.25) + 1) / 3, Exposure.meanDisplayed(image), 1e-7);
        Image darker = image.withCurve(DisplayCurve.SRGB.withExposure(-2));
        assertEquals((TransferCurve.encode(0.0625) + 1) / 3, Exposure.meanDisplayed(darker), 1e-7);
        float[] black = new float[12];
        Arrays.fill(black, 0);
        assertEquals(0, Exposure.meanDisplayed(new Image(2, 2, black, Color.Encoding.LINEAR)));
    }
}
