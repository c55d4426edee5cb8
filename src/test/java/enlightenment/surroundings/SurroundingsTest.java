package enlightenment.surroundings;

import static enlightenment.surroundings.Pictures.grey;
import static enlightenment.surroundings.Pictures.pfm;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.math.InvalidValueException;
import java.io.IOException;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SurroundingsTest {
    private static final Surroundings.Texels BILINEAR = new Surroundings.Texels(false, false);

    private static Surroundings picture(int width, int height, double degrees, Pictures.Texel texels) {
        return picture(width, height, degrees, BILINEAR, texels);
    }

    private static Surroundings nearest(int width, int height, double degrees, Pictures.Texel texels) {
        return picture(width, height, degrees, new Surroundings.Texels(false, true), texels);
    }

    private static Surroundings picture(
            int width, int height, double degrees, Surroundings.Texels meaning, Pictures.Texel texels) {
        try {
            return Surroundings.of(pfm(width, height, texels), Rgb.WHITE, degrees, meaning);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static Surroundings sky(double elevation, double azimuth, boolean sun) {
        return Surroundings.sky(elevation, azimuth, 3, Rgb.gray(0.2), sun, Rgb.WHITE);
    }

    static Stream<Surroundings> several() {
        return Stream.of(
                picture(1, 1, 0, (x, y) -> grey(2)),
                picture(3, 2, 0, (x, y) -> new double[] {x, y, x * y}),
                picture(17, 9, 77.7, (x, y) -> grey(x == 4 && y == 6 ? 1e6 : 1)),
                picture(64, 32, -200, (x, y) -> grey(x == 20 && y == 10 ? 5 : 0)),
                picture(32, 16, 0, (x, y) -> grey(y < 8 ? 1 : 0)),
                nearest(17, 9, 77.7, (x, y) -> grey(x == 4 && y == 6 ? 1e6 : 0)),
                sky(35, 40, true),
                sky(0, -100, false));
    }

    private static double[] unit(SplittableRandom random) {
        double z = 2 * random.nextDouble() - 1;
        double phi = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(1 - z * z);
        return new double[] {r * Math.cos(phi), z, r * Math.sin(phi)};
    }

    @ParameterizedTest
    @MethodSource("several")
    void theDensityIsThatOfTheSampleAndGreaterThanZeroWhereverThereIsLight(Surroundings s) {
        SplittableRandom random = new SplittableRandom(1);
        double[] d = new double[3];
        double[] rgb = new double[3];
        for (int i = 0; i < 20_000; i++) {
            double density = s.sample(random.nextDouble(), random.nextDouble(), d);
            assertEquals(1, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1e-12);
            assertTrue(density > 0);
            assertEquals(density, s.density(d[0], d[1], d[2]), 1e-12 * density);
            double[] e = unit(random);
            s.radiance(e[0], e[1], e[2], rgb);
            assertTrue(s.density(e[0], e[1], e[2]) > 0 || rgb[0] + rgb[1] + rgb[2] == 0);
        }
    }

    /** Bins of equal solid angle: 12 around by 8 high. The density's integral over a bin is by 64 × 64 points; chi² at one in a million. */
    @ParameterizedTest
    @MethodSource("several")
    void directionsComeAsOftenAsTheDensitySays(Surroundings s) {
        int around = 12;
        int high = 8;
        int fine = 96;
        double[] expected = new double[around * high];
        double sum = 0;
        for (int i = 0; i < around * fine; i++) {
            for (int j = 0; j < high * fine; j++) {
                double phi = 2 * Math.PI * (i + 0.5) / (around * fine);
                double y = 1 - 2 * (j + 0.5) / (high * fine);
                double r = Math.sqrt(1 - y * y);
                double share = s.density(r * Math.sin(phi), y, r * Math.cos(phi))
                        * 4
                        * Math.PI
                        / (around * fine * high * fine);
                expected[i / fine * high + j / fine] += share;
                sum += share;
            }
        }
        assertEquals(1, sum, 0.02);
        int n = 200_000;
        int[] found = new int[around * high];
        SplittableRandom random = new SplittableRandom(7);
        double[] d = new double[3];
        for (int k = 0; k < n; k++) {
            s.sample(random.nextDouble(), random.nextDouble(), d);
            double phi = Math.atan2(d[0], d[2]);
            int i = (int) ((phi < 0 ? phi + 2 * Math.PI : phi) / (2 * Math.PI) * around) % around;
            found[i * high + Math.min((int) ((1 - d[1]) / 2 * high), high - 1)]++;
        }
        double off = 0;
        for (int b = 0; b < found.length; b++) {
            double mean = expected[b] * n / sum;
            // The quadrature of cells that a bin cuts is off by about a cell's share of a bin.
            double slack = 4 * Math.sqrt(mean) + 0.05 * mean + 1;
            assertTrue(Math.abs(found[b] - mean) < slack + 2 * Math.sqrt(mean), b + ": " + found[b] + ", not " + mean);
            off += found[b] - mean;
        }
        assertEquals(0, off, 1e-3 * n);
    }

    @Test
    void aPictureOfOneColourIsChosenEvenlyAndHasItsRadianceEverywhere() {
        Surroundings s = picture(31, 13, 12, (x, y) -> new double[] {1, 2, 3});
        SplittableRandom random = new SplittableRandom(3);
        double[] rgb = new double[3];
        for (int i = 0; i < 1000; i++) {
            double[] d = unit(random);
            s.radiance(d[0], d[1], d[2], rgb);
            assertArrayEquals(new double[] {1, 2, 3}, rgb, 1e-12);
            assertEquals(1 / (4 * Math.PI), s.density(d[0], d[1], d[2]), 1e-12);
        }
        assertEquals(6 * 4 * Math.PI, s.power(), 1e-9);
    }

    @Test
    void theMiddleIsAheadTheRightIsToTheRightAndTheUpperEdgeIsAbove() {
        double[] rgb = new double[3];
        Surroundings s = picture(4, 2, 0, (x, y) -> new double[] {x, y, 1});
        // Between the columns 1 and 2 is the direction of z; the middle of column 2 is an eighth of a turn from it to
        // x.
        s.radiance(0, 0, 1, rgb);
        assertArrayEquals(new double[] {1.5, 0.5, 1}, rgb, 1e-12);
        s.radiance(Math.sqrt(0.5), 0, Math.sqrt(0.5), rgb);
        assertArrayEquals(new double[] {2, 0.5, 1}, rgb, 1e-12);
        s.radiance(0, 1, 0, rgb);
        assertEquals(0, rgb[1]);
        s.radiance(0, -1, 0, rgb);
        assertEquals(1, rgb[1]);
    }

    @Test
    void aRotatedPictureShowsWhatItShowedElsewhere() {
        Pictures.Texel texels = (x, y) -> new double[] {x * x, 7 * y + x, x * y};
        Surroundings s = picture(12, 6, 0, texels);
        Surroundings turned = picture(12, 6, 70, texels);
        double angle = Math.toRadians(70);
        SplittableRandom random = new SplittableRandom(3);
        double[] a = new double[3];
        double[] b = new double[3];
        for (int i = 0; i < 1000; i++) {
            double[] d = unit(random);
            // Azimuths grow from z to x.
            double x = d[0] * Math.cos(angle) + d[2] * Math.sin(angle);
            double z = d[2] * Math.cos(angle) - d[0] * Math.sin(angle);
            s.radiance(d[0], d[1], d[2], a);
            turned.radiance(x, d[1], z, b);
            assertArrayEquals(a, b, 1e-9);
            assertEquals(s.density(d[0], d[1], d[2]), turned.density(x, d[1], z), 1e-9);
        }
    }

    /** The integral of radiance over directions by samples, and by the table. */
    @ParameterizedTest
    @MethodSource("several")
    void radianceOverDensityHasTheMeanThatTheTableKnowsAndABoundedVariance(Surroundings s) {
        double[] d = new double[3];
        double[] rgb = new double[3];
        SplittableRandom random = new SplittableRandom(11);
        double sum = 0;
        double most = 0;
        int n = 100_000;
        double total = s.power() - s.suns.stream().mapToDouble(Sun::power).sum();
        for (int i = 0; i < n; i++) {
            double density = s.sample(random.nextDouble(), random.nextDouble(), d);
            s.radiance(d[0], d[1], d[2], rgb);
            double value = (rgb[0] + rgb[1] + rgb[2]) / density;
            sum += value / n;
            most = Math.max(most, value / total);
        }
        assertEquals(total, sum, 0.02 * total);
        // In a cell beside a bright texel's corner the radiance is at most 16 times the mean of the cell.
        assertTrue(most <= 16 * 16.0 / 15 + 1e-9, "at most " + most);
    }

    @Test
    void theSunIsADiskOfItsSizeWhereItIsSaidToBe() {
        Sun sun = sky(35, 40, true).suns.get(0);
        assertEquals(Math.sin(Math.toRadians(35)), sun.y, 1e-15);
        assertEquals(Math.tan(Math.toRadians(40)), sun.x / sun.z, 1e-12);
        double radius = Math.toRadians(0.265);
        assertEquals(2 * Math.PI * (1 - Math.cos(radius)), sun.solidAngle, 1e-10 * sun.solidAngle * 1e3);
        SplittableRandom random = new SplittableRandom(1);
        double[] d = new double[3];
        int inner = 0;
        for (int i = 0; i < 10_000; i++) {
            sun.sample(random.nextDouble(), random.nextDouble(), d);
            double cross = Math.hypot(
                    d[1] * sun.z - d[2] * sun.y, Math.hypot(d[2] * sun.x - d[0] * sun.z, d[0] * sun.y - d[1] * sun.x));
            assertTrue(Math.asin(cross) <= radius * (1 + 1e-9));
            inner += Math.asin(cross) <= radius / 2 ? 1 : 0;
            assertTrue(sun.contains(d[0], d[1], d[2]) || Math.asin(cross) > radius * (1 - 1e-9));
        }
        assertEquals(2500, inner, 4 * Math.sqrt(10_000 * 0.25 * 0.75));
        assertTrue(!sun.contains(sun.x, sun.y + 0.01, sun.z));
    }

    /** A matte plain under a sky without sun reflects its albedo of what falls, evenly: below the horizon. */
    @Test
    void theGroundIsThatOfAPlainInThisLight() {
        Surroundings s = sky(50, 10, true);
        double[] d = new double[3];
        double[] rgb = new double[3];
        double[] falls = new double[3];
        int n = 200;
        for (int i = 0; i < n; i++) {
            double theta = (i + 0.5) / n * Math.PI / 2;
            for (int j = 0; j < 4 * n; j++) {
                double phi = (j + 0.5) / n * Math.PI / 2;
                s.radiance(Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi), rgb);
                double weight = Math.cos(theta) * Math.sin(theta) * Math.PI / 2 / n * Math.PI / 2 / n;
                for (int c = 0; c < 3; c++) {
                    falls[c] += rgb[c] * weight;
                }
            }
        }
        double sine = Math.sin(Math.toRadians(0.265));
        double direct = Math.PI * sine * sine * Math.sin(Math.toRadians(50));
        s.radiance(0.6, -0.8, 0, rgb);
        double[] sun = {s.suns.get(0).r, s.suns.get(0).g, s.suns.get(0).b};
        for (int c = 0; c < 3; c++) {
            assertEquals(0.2 / Math.PI * (falls[c] + direct * sun[c]), rgb[c], 2e-3 * rgb[c]);
        }
    }

    /** The picture that a sky becomes is interpolated. */
    @Test
    void theSkyIsThatOfTheModelToAThousandth() {
        Daylight model = new Daylight(25, 4);
        Surroundings s = Surroundings.sky(25, -30, 4, Rgb.BLACK, true, Rgb.WHITE);
        SplittableRandom random = new SplittableRandom(1);
        double[] a = new double[3];
        double[] b = new double[3];
        for (int i = 0; i < 10_000; i++) {
            double[] d = unit(random);
            if (d[1] > 0.006) {
                s.radiance(d[0], d[1], d[2], a);
                model.sky(d[1], d[0] * s.suns.get(0).x + d[1] * s.suns.get(0).y + d[2] * s.suns.get(0).z, b);
                for (int c = 0; c < 3; c++) {
                    assertEquals(b[c], a[c], 1e-3 * b[1]);
                }
            }
        }
    }

    @Test
    void texelsThatAreNotInterpolatedHaveOneRadianceUpToTheirEdges() {
        Surroundings s = nearest(4, 3, 0, (x, y) -> new double[] {x, y, 1});
        double[] rgb = new double[3];
        for (int i = 0; i < 400; i++) {
            double turn = (i % 40 + 0.5) / 40;
            double theta = (i / 40 + 0.5) / 10 * Math.PI;
            double phi = 2 * Math.PI * (turn - 0.5);
            s.radiance(Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi), rgb);
            double row = Math.floor((i / 40 + 0.5) / 10 * 3);
            assertArrayEquals(new double[] {Math.floor(turn * 4), row, 1}, rgb);
        }
        s.radiance(0, -1, 0, rgb);
        assertEquals(2, rgb[1]);
        // The integral over all directions, by texels: rows of three equal angles have cosines of 1, 1/2, -1/2 and -1.
        double byColumn = 2 * Math.PI * 2 * 1.5;
        double byRow = 2 * Math.PI * (1 * 1 + 2 * 0.5);
        assertEquals(byColumn + byRow + 4 * Math.PI, s.power(), 1e-12 * s.power());
    }

    @Test
    void theEstimateOfIrradianceIsAboutRightAndNowhereZero() {
        Surroundings s = picture(32, 16, 0, (x, y) -> grey(y < 8 ? 1 : 0));
        // Half of a sphere of three bands of 1, and a sixteenth of all of it.
        double floor = s.power() / 16;
        assertEquals(3 * Math.PI, s.irradiance(0, 1, 0) - floor, 0.4);
        assertEquals(0.5 * 3 * Math.PI, s.irradiance(1, 0, 0) - floor, 0.2);
        assertTrue(s.irradiance(0, -1, 0) > 0);
    }

    /** Beyond floats in any texel: a texel of 1 times 2^128, and 2^-10 times 2^140. */
    @Test
    void moreLightThanFloatsHoldIsBlamedOnWhatItIsMultipliedBy() {
        byte[] ones = pfm(4, 2, (x, y) -> grey(1));
        byte[] dim = pfm(4, 2, (x, y) -> grey(0x1p-10));
        for (Executable maker : List.<Executable>of(
                () -> Surroundings.of(ones, new Rgb(1, 1, 0x1p128), 0, BILINEAR),
                () -> Surroundings.of(dim, Rgb.gray(0x1p140), 0, BILINEAR),
                () -> Surroundings.sky(40, 0, 3, Rgb.BLACK, false, Rgb.gray(1e45)),
                () -> Surroundings.sky(40, 0, 3, Rgb.BLACK, true, new Rgb(1e100, 1, 1)))) {
            InvalidValueException e = assertThrows(InvalidValueException.class, maker);
            assertEquals("radiance", e.key());
            assertTrue(e.problem().contains("beyond the range of floats"), e.problem());
        }
    }

    /** A unit of light is arbitrary: in one that is a power of two, all is the same but the last of the numbers that no float can be. */
    @Test
    void howDimTheLightIsDoesNotMatter() throws IOException {
        Rgb dim = Rgb.gray(0x1p-200);
        byte[] file = pfm(16, 8, (x, y) -> grey((x + 1) * (y + 1)));
        Surroundings[] bright = {
            Surroundings.sky(30, 20, 3, Rgb.gray(0.2), true, Rgb.WHITE), Surroundings.of(file, Rgb.WHITE, 10, BILINEAR)
        };
        Surroundings[] dark = {
            Surroundings.sky(30, 20, 3, Rgb.gray(0.2), true, dim), Surroundings.of(file, dim, 10, BILINEAR)
        };
        SplittableRandom random = new SplittableRandom(4);
        double[] a = new double[3];
        double[] b = new double[3];
        for (int k = 0; k < 2; k++) {
            assertEquals(bright[k].power() * 0x1p-200, dark[k].power(), 1e-12 * dark[k].power());
            Surroundings half = dark[k].filtered(Rgb.gray(0.5));
            for (int i = 0; i < 100; i++) {
                double[] d = unit(random);
                bright[k].all(d[0], d[1], d[2], a);
                dark[k].all(d[0], d[1], d[2], b);
                assertEquals(a[1] * 0x1p-200, b[1], 1e-12 * b[1]);
                assertTrue(b[1] > 0);
                half.all(d[0], d[1], d[2], a);
                assertEquals(b[1] / 2, a[1], 1e-12 * b[1]);
                assertEquals(
                        bright[k].density(d[0], d[1], d[2]),
                        dark[k].density(d[0], d[1], d[2]),
                        1e-12 * bright[k].density(d[0], d[1], d[2]));
            }
        }
    }

    @Test
    void numbersThatAreNoRadianceAreToldWithTheirPlace() {
        for (double wrong : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            byte[] file = pfm(4, 3, (x, y) -> grey(x == 2 && y == 1 ? wrong : 1));
            IOException e = assertThrows(IOException.class, () -> Surroundings.of(file, Rgb.WHITE, 0, BILINEAR));
            assertEquals("the number " + (float) wrong + " in column 2, row 1 is no radiance", e.getMessage());
        }
        // What conversions between colour spaces leave a little below 0 is black.
        assertEquals(0, picture(2, 2, 0, (x, y) -> grey(-0.01)).power());
    }
}
