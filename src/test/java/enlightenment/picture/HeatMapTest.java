package enlightenment.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.TestImages;
import enlightenment.image.flip.Flip;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HeatMapTest {
    @Test
    void theMapRunsFromBlackToPaleYellowAndGetsLighterAtAnEvenPace() {
        assertArrayEquals(new float[] {0, 0, 4 / 255f}, color(0));
        assertArrayEquals(new float[] {252 / 255f, 253 / 255f, 191 / 255f}, color(1));
        double[] lightness = new double[256];
        for (int i = 0; i < 256; i++) {
            float[] c = color(i / 255.0);
            double y = 0.2126 * TransferCurve.decode(c[0])
                    + 0.7152 * TransferCurve.decode(c[1])
                    + 0.0722 * TransferCurve.decode(c[2]);
            // L* of CIELAB.
            lightness[i] = y > 216 / 24389.0 ? 116 * Math.cbrt(y) - 16 : y * 24389 / 27;
        }
        double mean = (lightness[255] - lightness[0]) / 255;
        for (int i = 1; i < 256; i++) {
            assertTrue(lightness[i] > lightness[i - 1], "" + i);
        }
        for (int i = 48; i < 256; i++) {
            // The map is even in CAM02-UCS, not quite in L*, least of all near black.
            assertEquals(mean, (lightness[i] - lightness[i - 16]) / 16, 0.3 * mean, "" + i);
        }
    }

    private static float[] color(double value) {
        float[] rgb = new float[3];
        Magma.write(value, rgb, 0);
        return rgb;
    }

    @Test
    void eachPixelHasTheColorOfItsError() {
        Flip flip = Flip.between(TestImages.noise(40, 9, 1), TestImages.noise(40, 9, 2));
        Image map = HeatMap.of(flip);
        assertEquals(40, map.width());
        assertEquals(9, map.height());
        Image scaled = HeatMap.withScale(flip);
        for (int y = 0; y < 9; y++) {
            for (int x = 0; x < 40; x++) {
                float[] expected = color(flip.error(x, y));
                for (int c = 0; c < 3; c++) {
                    assertEquals(expected[c], map.component(x, y, c));
                    assertEquals(expected[c], scaled.component(x, y, c));
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {32, 119, 120, 399, 400})
    void theScaleShowsAllColorsAndItsNumbersStayInside(int width) {
        Image black = TestImages.uniform(width, 3, 0, 0, 0);
        Image map = HeatMap.withScale(Flip.between(black, black));
        int dot = width < 400 ? 1 : 2;
        assertEquals(3 + 15 * dot, map.height());
        float[] ends = new float[6];
        Magma.write(0, ends, 0);
        Magma.write(1, ends, 3);
        for (int c = 0; c < 3; c++) {
            assertEquals(ends[c], map.component(0, 3 + 2 * dot, c));
            assertEquals(ends[3 + c], map.component(width - 1, 3 + 2 * dot, c));
        }
        int ink = 0;
        for (int x = 0; x < width; x++) {
            for (int y = 3 + 8 * dot; y < 3 + 13 * dot; y++) {
                ink += map.component(x, y, 0) > 0 ? 1 : 0;
            }
            assertEquals(0, map.component(x, 3 + 7 * dot, 0));
            assertEquals(0, map.component(x, 3 + 13 * dot, 0));
        }
        // 0 has 12 dots, 1 has 8, a point 1, 5 and 2 have 11, 7 has 7.
        int dots = width < 120 ? 12 + 24 + 8 : 12 + 35 + 24 + 31 + 8;
        assertEquals(dots * dot * dot, ink);
    }

    @Test
    void aPictureWithoutRoomForNumbersGetsNoScale() {
        Image black = TestImages.uniform(31, 3, 0, 0, 0);
        assertEquals(3, HeatMap.withScale(Flip.between(black, black)).height());
        assertTrue(
                HeatMap.withScale(Flip.between(TestImages.uniform(32, 1, 0, 0, 0), TestImages.uniform(32, 1, 0, 0, 0)))
                                .height()
                        > 1);
    }

    @Test
    void anyNumbersCanBeShownWithTheirOwnScale() {
        float[] shares = new float[200 * 2];
        shares[1] = 1;
        shares[2] = 7;
        shares[3] = Float.NaN;
        Image map = HeatMap.withScale(200, 2, shares, List.of("0", "3", "6.48", "9"));
        assertEquals(2 + 15, map.height());
        assertEquals(color(1)[0], map.component(1, 0, 0));
        assertEquals(color(1)[0], map.component(2, 0, 0));
        assertEquals(color(0)[2], map.component(3, 0, 2));
        // 0 has 12 dots, 3 and 9 have 10 and 12, 6.48 has 12 + 1 + 9 + 13.
        assertEquals(12 + 10 + 35 + 12, ink(map, 2));
        // No room for all, then none for any.
        Image narrow = HeatMap.withScale(40, 1, new float[40], List.of("0", "3", "6.4809", "9"));
        assertEquals(12 + 12, ink(narrow, 1));
        Image none = HeatMap.withScale(32, 1, new float[32], List.of("0.125", "1000000"));
        assertEquals(0, ink(none, 1));
    }

    private static int ink(Image map, int top) {
        int ink = 0;
        for (int y = top + 8; y < top + 13; y++) {
            for (int x = 0; x < map.width(); x++) {
                ink += map.component(x, y, 0) > 0 ? 1 : 0;
            }
        }
        return ink;
    }

    @Test
    void aScaleOfOtherThingsThanNumbersIsRefused() {
        float[] one = {0};
        for (List<String> labels : List.of(List.of("0"), List.of("0", "1e3"), List.<String>of())) {
            assertThrows(IllegalArgumentException.class, () -> HeatMap.withScale(1, 1, one, labels));
        }
        assertThrows(IllegalArgumentException.class, () -> HeatMap.withScale(2, 1, one, List.of("0", "1")));
    }
}
