package enlightenment.emitter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.photometry.IesFile;
import enlightenment.photometry.IntensityTable;
import enlightenment.sampling.Hash;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Profiles of intensity: value, samples and density belong together, and their integral is what a quadrature over the sphere finds. */
class IntensityProfileTest {
    private static final int ROWS = 1200;
    private static final int COLUMNS = 600;

    static List<IntensityProfile> profiles() {
        return List.of(
                new SpotProfile(Vec3.Y.negated(), 30, 20),
                new SpotProfile(new Vec3(0.3, -0.5, 0.7).normalized(), 75, 0),
                new SpotProfile(new Vec3(-1, 2, 0.1).normalized(), 140, 100),
                new SpotProfile(Vec3.Z, 180, 10),
                new SpotProfile(Vec3.X, 40, 40),
                new TableProfile(table("0 30 60 90", "0", "9 7 8 1"), Vec3.Y.negated(), 0),
                new TableProfile(
                        table("0 45 90 180", "0 45 90", "1 5 2 0 1 9 3 1 1 4 0 0"),
                        new Vec3(0.3, -0.5, 0.7).normalized(),
                        33),
                new TableProfile(table("90 135 180", "0 90 180 270 360", "0 3 9 0 6 9 0 1 9 0 0 9 0 3 9"), Vec3.Z, -20),
                new PictureProfile(new Tiles(2, 2, true), Vec3.Z, Vec3.Y, 70),
                new PictureProfile(new Tiles(5, 3, false), Vec3.X.negated(), Vec3.Z, 130),
                new PictureProfile(new Tiles(1, 4, false), Vec3.Y, Vec3.X, 20));
    }

    /** Texels of which some are dark, others coloured. */
    record Tiles(int width, int height, boolean isNearest) implements PictureProfile.Picture {
        private double texel(int x, int y, int band) {
            int column = Math.min(Math.max(x, 0), width - 1);
            int row = Math.min(Math.max(y, 0), height - 1);
            int k = row * width + column;
            return k % 3 == 1 ? 0 : (1 + (k * 7 + band * 3) % 5) / 5.0;
        }

        @Override
        public void lookUp(double u, double v, double[] rgb) {
            double x = u * width - (isNearest ? 0 : 0.5);
            double y = v * height - (isNearest ? 0 : 0.5);
            int left = (int) Math.floor(x);
            int top = (int) Math.floor(y);
            double fx = isNearest ? 0 : x - left;
            double fy = isNearest ? 0 : y - top;
            for (int band = 0; band < 3; band++) {
                double above = (1 - fx) * texel(left, top, band) + fx * texel(left + 1, top, band);
                double below = (1 - fx) * texel(left, top + 1, band) + fx * texel(left + 1, top + 1, band);
                rgb[band] = (1 - fy) * above + fy * below;
            }
        }

        @Override
        public double[] identity() {
            return new double[] {width, height};
        }
    }

    /** One texel of four is lit: seen along the axis, with y up, that at the top left lies towards −x and +y where the axis is z. */
    @Test
    void aPictureStandsUprightAndIsNotMirrored() {
        PictureProfile.Picture lit = new PictureProfile.Picture() {
            @Override
            public int width() {
                return 2;
            }

            @Override
            public int height() {
                return 2;
            }

            @Override
            public void lookUp(double u, double v, double[] rgb) {
                Arrays.fill(rgb, u < 0.5 && v < 0.5 ? 1 : 0);
            }

            @Override
            public double[] identity() {
                return new double[0];
            }
        };
        IntensityProfile profile = new PictureProfile(lit, Vec3.Z, Vec3.Y, 90);
        double third = 1 / Math.sqrt(3);
        double inside = 1 / Math.sqrt(1.5);
        assertEquals(1, profile.luminance(-0.5 * inside, 0.5 * inside, inside), 1e-12);
        assertEquals(0, profile.luminance(0.5 * inside, 0.5 * inside, inside));
        assertEquals(0, profile.luminance(-0.5 * inside, -0.5 * inside, inside));
        assertEquals(0, profile.luminance(third, -third, -third));
        assertEquals(0, profile.luminance(-0.8, 0.36, 0.48));
        // A square of a quarter of a face of the cube around it.
        assertEquals(4 * Math.PI / 24, profile.solidAngle(), 2e-6);
    }

    private static IntensityTable table(String vertical, String horizontal, String candela) {
        int rows = vertical.split(" ").length;
        int columns = horizontal.split(" ").length;
        String text = "TILT=NONE\n1 1 1 " + rows + " " + columns + " 1 2 0 0 0 1 1 1\n" + vertical + "\n" + horizontal
                + "\n" + candela;
        try {
            return IesFile.of(text.getBytes(StandardCharsets.ISO_8859_1));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Seen along −y, the file's horizontal angles grow from +x towards −z; a rotation turns the luminaire in that sense. */
    @Test
    void aTableStandsInTheSpaceOfTheScene() {
        IntensityTable table = table("0 90", "0 90 180 270 360", "8 1 8 2 8 3 8 4 8 1");
        IntensityProfile down = new TableProfile(table, Vec3.Y.negated(), 0);
        assertEquals(1, down.luminance(0, -1, 0), 1e-12);
        assertEquals(1.0 / 8, down.luminance(1, 0, 0), 1e-12);
        assertEquals(2.0 / 8, down.luminance(0, 0, -1), 1e-12);
        assertEquals(3.0 / 8, down.luminance(-1, 0, 0), 1e-12);
        assertEquals(4.0 / 8, down.luminance(0, 0, 1), 1e-12);
        assertEquals(0, down.luminance(0, 1, 0));
        IntensityProfile turned = new TableProfile(table, Vec3.Y.negated(), 90);
        assertEquals(1.0 / 8, turned.luminance(0, 0, -1), 1e-12);
        assertEquals(4.0 / 8, turned.luminance(1, 0, 0), 1e-12);
        // The least turn from −y to x takes x to y, and leaves z.
        IntensityProfile aside = new TableProfile(table, Vec3.X, 0);
        assertEquals(1.0 / 8, aside.luminance(0, 1, 0), 1e-12);
        assertEquals(2.0 / 8, aside.luminance(0, 0, -1), 1e-12);
    }

    /** A hemisphere of equal intensity, and one that falls evenly with the angle: 2π ∫ (1 − 2θ/π) sin θ dθ = 2π (1 − 2/π). */
    @Test
    void theSolidAngleOfATableIsExact() {
        assertEquals(2 * Math.PI, new TableProfile(table("0 90", "0", "7 7"), Vec3.X, 0).solidAngle(), 1e-14);
        double expected = 2 * Math.PI * (1 - 2 / Math.PI);
        assertEquals(expected, new TableProfile(table("0 90", "0", "7 0"), Vec3.X, 0).solidAngle(), 1e-14);
        assertEquals(expected, new TableProfile(table("0 9 90", "0", "10 9 0"), Vec3.X, 0).solidAngle(), 1e-14);
    }

    /** The mean over a ring of equal heights around the axis of a profile, of what is sought. */
    interface Value {
        double at(double x, double y, double z);
    }

    /** The integral over the cone of a profile by the midpoint rule, in rows of equal solid angle. */
    private static double integral(IntensityProfile profile, Value value) {
        Vec3 axis = profile.axis();
        Basis basis = new Basis();
        basis.around(axis.x(), axis.y(), axis.z());
        double all = 1 - Math.cos(profile.coneAngle());
        double sum = 0;
        for (int row = 0; row < ROWS; row++) {
            double height = (row + 0.5) / ROWS * all;
            double cos = 1 - height;
            double sin = Math.sqrt(height * (2 - height));
            for (int column = 0; column < COLUMNS; column++) {
                double turn = (column + 0.5) / COLUMNS * 2 * Math.PI;
                double a = sin * Math.cos(turn);
                double b = sin * Math.sin(turn);
                sum += value.at(
                        a * basis.ax + b * basis.bx + cos * axis.x(),
                        a * basis.ay + b * basis.by + cos * axis.y(),
                        a * basis.az + b * basis.bz + cos * axis.z());
            }
        }
        return sum * 2 * Math.PI * all / ROWS / COLUMNS;
    }

    @ParameterizedTest
    @MethodSource("profiles")
    void theSolidAngleIsTheIntegralOfTheLuminance(IntensityProfile profile) {
        double expected = integral(profile, profile::luminance);
        assertEquals(expected, profile.solidAngle(), 2e-4 * expected);
    }

    @ParameterizedTest
    @MethodSource("profiles")
    void theDensityIntegratesToOne(IntensityProfile profile) {
        assertEquals(1, integral(profile, profile::density), 2e-3);
    }

    @ParameterizedTest
    @MethodSource("profiles")
    void thereIsADensityWhereverThereIsLight(IntensityProfile profile) {
        double[] rgb = new double[3];
        double holes = integral(profile, (x, y, z) -> {
            profile.intensity(x, y, z, rgb);
            double luminance = profile.luminance(x, y, z);
            assertEquals(luminance, 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2], 1e-12);
            return luminance > 0 && !(profile.density(x, y, z) > 0) ? 1 : 0;
        });
        assertEquals(0, holes);
    }

    /** Estimates by samples of integrals that a quadrature knows: six standard errors. */
    @ParameterizedTest
    @MethodSource("profiles")
    void samplesHaveTheirDensity(IntensityProfile profile) {
        List<Value> functions = List.of((x, y, z) -> 1 + x, (x, y, z) -> y * y, (x, y, z) -> Math.max(z, x));
        for (Value f : functions) {
            double expected = integral(profile, (x, y, z) -> f.at(x, y, z) * profile.density(x, y, z));
            int n = 100_000;
            double sum = 0;
            double squares = 0;
            double[] d = new double[3];
            for (int i = 0; i < n; i++) {
                double density = profile.sample(Hash.unit(Hash.of(1, i)), Hash.unit(Hash.of(2, i)), d);
                assertTrue(density > 0, "a sample without a density");
                assertEquals(1, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1e-14);
                assertEquals(density, profile.density(d[0], d[1], d[2]), 1e-9 * density);
                double value = f.at(d[0], d[1], d[2]);
                sum += value;
                squares += value * value;
            }
            double mean = sum / n;
            double error = Math.sqrt((squares / n - mean * mean) / n);
            assertEquals(expected, mean, 6 * error + 2e-3);
        }
    }

    @Test
    void aSpotFallsBySmoothstepOfTheCosine() {
        IntensityProfile spot = new SpotProfile(Vec3.Z, 60, 30);
        double inner = Math.cos(Math.toRadians(30));
        double outer = 0.5;
        for (int degrees = 0; degrees <= 180; degrees += 5) {
            double cos = Math.cos(Math.toRadians(degrees));
            double t = Math.min(Math.max((cos - outer) / (inner - outer), 0), 1);
            double expected = t * t * (3 - 2 * t);
            assertEquals(expected, spot.luminance(Math.sin(Math.toRadians(degrees)), 0, cos), 1e-14);
        }
    }

    /** Half of it in the inner cone: Ω = π (1 − cos) (1 + 1/2) of half the angle in 1 − cos. */
    @ParameterizedTest
    @CsvSource({"90, 60, 4.71238898038469", "180, 0, 6.283185307179586", "90, 90, 6.283185307179586"})
    void theSolidAngleOfASpotHasAClosedForm(double angle, double innerAngle, double expected) {
        assertEquals(expected, new SpotProfile(Vec3.X, angle, innerAngle).solidAngle(), 1e-14 * expected);
    }

    /** In a cone of a second of arc all of the cosine's digits would be lost. */
    @Test
    void aNarrowSpotKeepsItsDigits() {
        double angle = 1.0 / 3600;
        IntensityProfile spot = new SpotProfile(Vec3.Z, angle, 0.5 * angle);
        double radians = Math.toRadians(angle);
        assertEquals(Math.PI * radians * radians * 0.625, spot.solidAngle(), 1e-9 * spot.solidAngle());
        double[] d = new double[3];
        for (int i = 0; i < 1000; i++) {
            assertTrue(spot.sample(Hash.unit(Hash.of(3, i)), Hash.unit(Hash.of(4, i)), d) > 0);
            assertTrue(Math.hypot(d[0], d[1]) <= radians * (1 + 1e-9));
        }
        assertEquals(1, spot.luminance(0.4 * radians, 0, 1));
        assertEquals(0.5, spot.luminance(Math.sqrt(0.625) * radians, 0, 1), 1e-6);
        assertEquals(0, spot.luminance(1.001 * radians, 0, 1));
    }
}
