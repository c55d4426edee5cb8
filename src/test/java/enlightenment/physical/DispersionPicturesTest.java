package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.CauchyFormula;
import enlightenment.geometry.Cube;
import enlightenment.image.Image;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** What is known of pictures of glass that disperses without any other picture. */
class DispersionPicturesTest {
    private static final double INDEX = 1.3;
    private static final double ABBE = 8;

    private static Glass white(double index, double abbe) {
        return Glass.of(PhysicalScenes.linear(1, 1, 1), index).withDispersion(abbe);
    }

    private static Statistics band(List<Image> pictures, int left, int right, int band) {
        return Statistics.of(pictures.stream()
                .mapToDouble(image -> {
                    double sum = 0;
                    for (int y = 0; y < image.height(); y++) {
                        for (int x = left; x < right; x++) {
                            sum += image.component(x, y, band);
                        }
                    }
                    return sum / ((right - left) * image.height());
                })
                .toArray());
    }

    private static void assertSame(double expected, Statistics s) {
        assertTrue(Math.abs(s.mean() - expected) <= 5 * s.error() + 1e-6 * expected, () -> s + " for " + expected);
    }

    private static List<Image> render(Scene scene, BuiltInMethod method, int antialias, int count) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        return Rendered.seeds(scene, settings, 1, count);
    }

    /** Each wavelength loses nothing, and all of them are white. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE, 0", "BIDIRECTIONAL, 0", "RAYTRACE, 0.2"})
    void glassInAWhiteFurnaceIsWhite(BuiltInMethod method, double roughness) {
        Scene scene = PhysicalScenes.view(6, 6)
                .shading(PhysicalScenes.shading(1))
                .object(PhysicalScenes.ball(0, 1, 0, 1), white(1.6, 6).withRoughness(roughness))
                .object(PhysicalScenes.ball(0.2, 1, 0, 0.5), white(1.2, 3).withRoughness(roughness))
                .build();
        List<Image> pictures = render(scene, method, 8, 16);
        for (int c = 0; c < 3; c++) {
            Statistics s = band(pictures, 0, 6, c);
            assertTrue(Math.abs(s.mean() - 1) <= 5 * s.error() + (roughness > 0 ? 0.03 : 0), () -> s + " is not white");
        }
    }

    private static Scene caustic(Material glass) {
        return PhysicalScenes.view(8, 8)
                .camera(new Camera.Perspective(
                        PhysicalScenes.at(0.9, 0.9, -0.1), PhysicalScenes.at(0.9, 0, 0), Vec3.Y, 60))
                .light(PhysicalScenes.sphereLight(-1.5, 2.5, 0, 0.3, 20))
                .object(
                        TestScenes.rectangle(-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2),
                        PhysicalScenes.matte(0.8, 0.7, 0.6))
                .object(PhysicalScenes.ball(0, 0.6, 0, 0.5), glass)
                .build();
    }

    @Test
    void glassOfEndlessAbbeNumberIsGlassWithoutDispersion() {
        Glass plain = Glass.of(PhysicalScenes.linear(1, 1, 1), 1.6);
        List<Image> with = render(caustic(plain.withDispersion(1e12)), BuiltInMethod.RAYTRACE, 4, 12);
        List<Image> without = render(caustic(plain), BuiltInMethod.RAYTRACE, 4, 12);
        for (int c = 0; c < 3; c++) {
            for (int half = 0; half < 2; half++) {
                Statistics a = band(with, 4 * half, 4 * half + 4, c);
                Statistics b = band(without, 4 * half, 4 * half + 4, c);
                assertTrue(Math.abs(a.mean() - b.mean()) <= 5 * Math.hypot(a.error(), b.error()), () -> a + " " + b);
            }
        }
    }

    /** Of what all of them see: the floor with the rainbow on it. */
    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"LIGHT", "BIDIRECTIONAL", "METROPOLIS", "CLUSTER"})
    void otherMethodsShowTheRainbowThatRaytraceShows(BuiltInMethod method) {
        Scene scene = caustic(white(1.6, 5));
        List<Image> expected = render(scene, BuiltInMethod.RAYTRACE, 4, 16);
        List<Image> actual = render(scene, method, 4, 16);
        for (int c = 0; c < 3; c++) {
            for (int part = 0; part < 4; part++) {
                Statistics a = band(expected, 2 * part, 2 * part + 2, c);
                Statistics b = band(actual, 2 * part, 2 * part + 2, c);
                assertTrue(Math.abs(a.mean() - b.mean()) <= 5 * Math.hypot(a.error(), b.error()), () -> a + " " + b);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void bytesDependNeitherOnThreadsNorOnTiles(BuiltInMethod method) {
        Scene scene = caustic(white(1.6, 5).withRoughness(0.2));
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(method)
                .withAntialias(2)
                .withSize(24, 24)
                .withThreads(1);
        float[] one = rgb(Renderer.render(scene, settings));
        assertArrayEquals(one, rgb(Renderer.render(scene, settings.withThreads(3))));
        assertArrayEquals(one, rgb(Renderer.render(scene, settings.withTileSize(8))));
    }

    private static float[] rgb(Image image) {
        float[] rgb = new float[3 * image.width() * image.height()];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = image.component(i / 3 % image.width(), i / 3 / image.width(), i % 3);
        }
        return rgb;
    }

    /** A corner of a cube, turned so that light of a middle wavelength passes it symmetrically. */
    private static final double TURN = Math.toRadians(66.8);

    /** Degrees, of each of 16 pixels. */
    private static final double VIEW = 0.4;

    private static final double CORNER_X = 0.3;
    private static final double CORNER_Z = 0.1;

    /** The eye at (0, 0.5, -4) looks through two faces of a cube at a strip of light far behind. */
    private static Scene strip(double left, double right) {
        double toCenter = 0.5 * (Math.sin(TURN) + Math.cos(TURN));
        double along = 0.5 * (Math.sin(TURN) - Math.cos(TURN));
        return PhysicalScenes.view(16, 1)
                .camera(new Camera.Perspective(
                        PhysicalScenes.at(0, 0.5, -4), PhysicalScenes.at(0.1, 0.5, 0), Vec3.Y, VIEW))
                .object(
                        new Cube(
                                PhysicalScenes.at(CORNER_X - toCenter, 0.5, CORNER_Z - along),
                                Math.sqrt(3) / 2,
                                new Vec3(0, 90 - Math.toDegrees(TURN), 0)),
                        white(INDEX, ABBE))
                .object(
                        TestScenes.rectangle(left, -9, 9, left, 9, 9, right, 9, 9, right, -9, 9),
                        PhysicalScenes.matte(0, 0, 0).withRadiance(Rgb.gray(1)))
                .build();
    }

    /** Where a line from the eye, through both faces, meets the plane of the strip, and what share of light goes with it. */
    private static double[] through(double angle, double wavelength) {
        double n = CauchyFormula.index(INDEX, CauchyFormula.slope(INDEX, ABBE), CauchyFormula.place(wavelength));
        double dx = Math.sin(angle);
        double dz = Math.cos(angle);
        double ox = 0;
        double oz = -4;
        double share = 1;
        for (int face = 0; face < 2; face++) {
            double nx = face == 0 ? Math.sin(TURN) : Math.cos(TURN);
            double nz = face == 0 ? -Math.cos(TURN) : Math.sin(TURN);
            double c = dx * nx + dz * nz;
            double t = ((CORNER_X - ox) * nx + (CORNER_Z - oz) * nz) / c;
            ox += t * dx;
            oz += t * dz;
            double fromCorner = Math.hypot(ox - CORNER_X, oz - CORNER_Z);
            double cosine = Math.abs(c);
            double eta = face == 0 ? 1 / n : n;
            double k = 1 - eta * eta * (1 - cosine * cosine);
            // Only lines that meet both faces, from the right side, and leave.
            if (!(t > 0 && fromCorner < 1 && ox < CORNER_X && k >= 0 && (face == 0 ? c < 0 : c > 0))) {
                return new double[] {Double.NaN, 0};
            }
            double there = Math.sqrt(k);
            double side = face == 0 ? -1 : 1;
            dx = eta * dx + side * (there - eta * cosine) * nx;
            dz = eta * dz + side * (there - eta * cosine) * nz;
            double s = (eta * cosine - there) / (eta * cosine + there);
            double p = (cosine - eta * there) / (cosine + eta * there);
            share *= 1 - (s * s + p * p) / 2;
        }
        assertEquals(1, Math.hypot(dx, dz), 1e-9);
        return new double[] {ox + (9 - oz) / dz * dx, share};
    }

    /** Snell's law and Fresnel's equations for each wavelength, in closed form, and the sum over them. */
    @Test
    void aPrismShowsEachWavelengthWhereSnellsLawPutsIt() {
        double middle = through(Math.atan(0.1 / 4), 560)[0];
        double left = middle - 0.15;
        double right = middle + 0.15;
        List<Image> pictures = render(strip(left, right), BuiltInMethod.RAYTRACE, 16, 24);
        double width = 2 * Math.tan(Math.toRadians(VIEW / 2)) * 16;
        double center = Math.atan(0.1 / 4);
        double negative = 0;
        double[] sums = new double[3];
        double[] places = new double[3];
        for (int x = 0; x < 16; x++) {
            double[] expected = new double[3];
            for (int k = 0; k < 64; k++) {
                double place = ((x + (k + 0.5) / 64) / 16 - 0.5) * width;
                double angle = center + Math.atan(place);
                for (double nm = 380.5; nm < 780; nm++) {
                    double[] there = through(angle, nm);
                    if (there[0] > left && there[0] < right) {
                        for (int c = 0; c < 3; c++) {
                            expected[c] += there[1] * BandSensitivities.DAYLIGHT.sensitivity(nm, c) / 64;
                        }
                    }
                }
            }
            for (int c = 0; c < 3; c++) {
                Statistics s = band(pictures, x, x + 1, c);
                negative = Math.min(negative, s.mean());
                sums[c] += Math.max(s.mean(), 0);
                places[c] += x * Math.max(s.mean(), 0);
                double e = expected[c];
                assertTrue(Math.abs(s.mean() - e) <= 5 * s.error() + 0.01, () -> s + " for " + e);
            }
        }
        double red = places[0] / sums[0];
        double green = places[1] / sums[1];
        double blue = places[2] / sums[2];
        assertTrue(red + 2 < green && green + 2 < blue, () -> red + " " + green + " " + blue);
        assertTrue(negative < -0.03, "pure colours are beyond those of screens");
    }
}
