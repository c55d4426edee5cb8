package enlightenment.denoise;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DenoiserTest {
    private static float[] denoised(NoisyPicture picture) {
        return Denoiser.denoise(picture, 1, () -> false);
    }

    /** What a pixel's expected light and albedo are; all bands are equal. */
    private interface Pixel {
        double at(int x, int y);
    }

    /**
     * A wall that faces the viewer. Quarters have independent errors of this relative deviation, uniform; the mean has half of it.
     */
    private static NoisyPicture wall(int width, int height, Pixel light, Pixel albedo, double noise) {
        SplittableRandom random = new SplittableRandom(7);
        int n = width * height;
        float[] mean = new float[3 * n];
        float[] quarters = new float[12 * n];
        float[] reflectance = new float[3 * n];
        float[] normal = new float[3 * n];
        float[] position = new float[3 * n];
        for (int i = 0; i < n; i++) {
            int x = i % width;
            int y = i / width;
            normal[3 * i + 2] = 1;
            position[3 * i] = x;
            position[3 * i + 1] = y;
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int q = 0; q < 4; q++) {
                    double error = noise * StrictMath.sqrt(3) * (2 * random.nextDouble() - 1);
                    float value = (float) (light.at(x, y) * (1 + error));
                    quarters[12 * i + 3 * q + c] = value;
                    sum += value;
                }
                mean[3 * i + c] = (float) (sum / 4);
                reflectance[3 * i + c] = (float) albedo.at(x, y);
            }
        }
        return new NoisyPicture(width, height, mean, quarters, reflectance, normal, position);
    }

    private static double meanSquare(float[] rgb, Pixel truth, int width) {
        double sum = 0;
        for (int k = 0; k < rgb.length; k++) {
            double off = rgb[k] - truth.at(k / 3 % width, k / 3 / width);
            sum += off * off;
        }
        return sum / rgb.length;
    }

    @Test
    void aConstantPictureLosesItsNoise() {
        NoisyPicture picture = wall(96, 64, (x, y) -> 2, (x, y) -> 0.5, 0.4);
        double before = meanSquare(picture.light(), (x, y) -> 2, 96);
        double after = meanSquare(denoised(picture), (x, y) -> 2, 96);
        assertEquals(0.16, before, 0.01, "(2 · 0.4)² / 4");
        // A window has 73 pixels or more.
        assertTrue(after < before / 24, before + " became " + after);
        double sum = 0;
        for (float value : denoised(picture)) {
            sum += value;
        }
        assertEquals(2, sum / picture.light().length, 0.02, "a picture is not darkened");
    }

    /** The first windows have 81 pixels: their means alone would leave no less than 1/81 of the squared error. */
    @Test
    void whatTheFirstWindowsLeaveIsFilteredAgain() {
        Pixel two = (x, y) -> 2;
        NoisyPicture picture = wall(128, 128, two, (x, y) -> 0.5, 0.4);
        double before = meanSquare(picture.light(), two, 128);
        double after = meanSquare(denoised(picture), two, 128);
        assertTrue(after < before / 162, before + " became " + after);
    }

    /** All pixels of a square of 8 × 8 have the same error: the squares' borders fade, and so do the errors. */
    @Test
    void errorsThatPixelsShareAreFiltered() {
        int side = 128;
        Pixel two = (x, y) -> 2;
        NoisyPicture squares = wall(side / 8, side / 8, two, (x, y) -> 0.5, 0.1);
        NoisyPicture grain = wall(side, side, two, (x, y) -> 0.5, 0.4);
        for (int i = 0; i < side * side; i++) {
            int square = i / side / 8 * (side / 8) + i % side / 8;
            for (int c = 0; c < 12; c++) {
                grain.quarters()[12 * i + c] += squares.quarters()[12 * square + c] - 2;
            }
            for (int c = 0; c < 3; c++) {
                grain.light()[3 * i + c] += squares.light()[3 * square + c] - 2;
            }
        }
        double shared = meanSquare(squares.light(), two, side / 8);
        double after = meanSquare(denoised(grain), two, side);
        assertTrue(after < shared / 3, shared + " became " + after);
    }

    @Test
    void aBorderOfTwoColoursStays() {
        Pixel albedo = (x, y) -> x < 32 ? 0.2 : 0.8;
        NoisyPicture picture = wall(64, 48, (x, y) -> 3 * albedo.at(x, y), albedo, 0.4);
        float[] rgb = denoised(picture);
        for (int y = 0; y < 48; y++) {
            assertEquals(0.6, rgb[3 * (y * 64 + 31)], 0.15, "last dark column, row " + y);
            assertEquals(2.4, rgb[3 * (y * 64 + 32)], 0.6, "first bright column, row " + y);
        }
    }

    @Test
    void aTextureStaysAtFullContrast() {
        SplittableRandom random = new SplittableRandom(3);
        double[] grey = random.doubles(64L * 64, 0.2, 0.9).toArray();
        Pixel albedo = (x, y) -> grey[y * 64 + x];
        NoisyPicture picture = wall(64, 64, albedo, albedo, 0.2);
        double before = meanSquare(picture.light(), albedo, 64);
        double after = meanSquare(denoised(picture), albedo, 64);
        assertTrue(after < before, before + " became " + after);
    }

    @Test
    void theEdgeOfAShadowStays() {
        Pixel light = (x, y) -> x < 32 ? 0.1 : 1;
        float[] rgb = denoised(wall(64, 48, light, (x, y) -> 0.5, 0.1));
        for (int y = 0; y < 48; y++) {
            assertEquals(0.1, rgb[3 * (y * 64 + 31)], 0.02, "last dark column, row " + y);
            assertEquals(1, rgb[3 * (y * 64 + 32)], 0.1, "first bright column, row " + y);
        }
    }

    @Test
    void aPictureWithoutNoiseIsUnchanged() {
        NoisyPicture picture =
                wall(50, 40, (x, y) -> 1 + 0.5 * StrictMath.sin(0.4 * x) * StrictMath.cos(0.3 * y), (x, y) -> 0.5, 0);
        float[] rgb = denoised(picture);
        for (int k = 0; k < rgb.length; k++) {
            assertEquals(picture.light()[k], rgb[k], 1e-5 * picture.light()[k], "component " + k);
        }
    }

    @Test
    void aFireflyBecomesNoBlotch() {
        NoisyPicture picture = wall(40, 40, (x, y) -> 1, (x, y) -> 0.5, 0.1);
        int at = 20 * 40 + 20;
        for (int c = 0; c < 3; c++) {
            picture.quarters()[12 * at + c] += 4000;
            picture.light()[3 * at + c] += 1000;
        }
        float[] rgb = denoised(picture);
        for (int k = 0; k < rgb.length; k++) {
            assertEquals(1, rgb[k], 0.2, "component " + k);
        }
    }

    @Test
    void aLampStaysAndDoesNotLightItsNeighbours() {
        Pixel light = (x, y) -> x == 20 && y == 20 ? 500 : 0;
        NoisyPicture picture = wall(40, 40, light, (x, y) -> 0, 0);
        int border = 20 * 40 + 21;
        for (int c = 0; c < 3; c++) {
            picture.quarters()[12 * border + c] = 400;
            picture.light()[3 * border + c] = 100;
        }
        float[] rgb = denoised(picture);
        assertEquals(500, rgb[3 * (20 * 40 + 20)], 0.01);
        for (int k = 0; k < rgb.length; k++) {
            if (k / 3 != border && k / 3 != border - 1) {
                assertEquals(0, rgb[k], 1e-3, "component " + k);
            }
        }
    }

    @Test
    void threadsHaveNoInfluence() {
        NoisyPicture picture = wall(70, 90, (x, y) -> 1 + 0.01 * x, (x, y) -> 0.5, 0.5);
        assertArrayEquals(denoised(picture), Denoiser.denoise(picture, 3, () -> false));
    }

    @Test
    void stripsLeaveNoSeam() {
        int width = 30;
        int period = 5;
        NoisyPicture one = wall(width, period, (x, y) -> 1, (x, y) -> 0.5, 0.5);
        NoisyPicture tall = wall(width, 30 * period, (x, y) -> 1, (x, y) -> 0.5, 0);
        for (int i = 0; i < width * 30 * period; i++) {
            int from = i % (width * period);
            System.arraycopy(one.light(), 3 * from, tall.light(), 3 * i, 3);
            System.arraycopy(one.quarters(), 12 * from, tall.quarters(), 12 * i, 12);
        }
        float[] rgb = denoised(tall);
        int length = 3 * width * period;
        // Whole periods that are too far from top and bottom to see them.
        for (int k = 10 * length; k < 19 * length; k++) {
            assertEquals(rgb[k], rgb[k + length], 1e-6, "component " + k);
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 40", "40, 1", "2, 2", "17, 3"})
    void smallPicturesAreFiltered(int width, int height) {
        float[] rgb = denoised(wall(width, height, (x, y) -> 1, (x, y) -> 0.5, 0.3));
        assertEquals(3 * width * height, rgb.length);
        for (float value : rgb) {
            assertEquals(1, value, 0.6);
        }
    }

    @Test
    void numbersThatAreNoneStayAndDoNotSpread() {
        NoisyPicture picture = wall(30, 30, (x, y) -> 1, (x, y) -> 0.5, 0.1);
        picture.light()[3 * 455] = Float.NaN;
        picture.light()[3 * 99 + 1] = Float.POSITIVE_INFINITY;
        picture.albedo()[3 * 200] = Float.NaN;
        picture.position()[3 * 201] = Float.POSITIVE_INFINITY;
        float[] rgb = denoised(picture);
        assertTrue(Float.isNaN(rgb[3 * 455]));
        assertEquals(Float.POSITIVE_INFINITY, rgb[3 * 99 + 1]);
        for (int k = 0; k < rgb.length; k++) {
            if (k / 3 != 455 && k / 3 != 99) {
                assertEquals(1, rgb[k], 0.4, "component " + k);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1e-30", "1e30"})
    void unitsOfLightHaveNoInfluence(double unit) {
        float[] rgb = denoised(wall(40, 30, (x, y) -> 1, (x, y) -> 0.5, 0.3));
        float[] scaled = denoised(wall(40, 30, (x, y) -> unit, (x, y) -> 0.5, 0.3));
        for (int k = 0; k < rgb.length; k++) {
            assertEquals(rgb[k], scaled[k] / unit, 1e-4, "component " + k);
        }
    }

    @Test
    void aBlackPictureStaysBlack() {
        for (float value : denoised(wall(20, 20, (x, y) -> 0, (x, y) -> 0, 0))) {
            assertEquals(0, value);
        }
    }

    @Test
    void itEndsWhenCancelled() {
        NoisyPicture picture = wall(20, 20, (x, y) -> 1, (x, y) -> 0.5, 0.1);
        assertThrows(CancellationException.class, () -> Denoiser.denoise(picture, 1, () -> true));
    }

    @Test
    void arraysOfAnotherSizeAreRefused() {
        NoisyPicture p = wall(4, 4, (x, y) -> 1, (x, y) -> 0.5, 0);
        assertThrows(
                IllegalArgumentException.class,
                () -> new NoisyPicture(4, 5, p.light(), p.quarters(), p.albedo(), p.normal(), p.position()));
    }
}
