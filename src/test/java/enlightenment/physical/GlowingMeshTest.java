package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Triangle;
import enlightenment.image.Image;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Meshes of many small triangles that glow, and solids that do: each triangle is a lamp, and half of them are behind the others. */
class GlowingMeshTest {
    private static final int SIZE = 4;
    private static final double RADIANCE = 5;
    private static final Camera EYE = new Camera.Perspective(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 40);
    private static final Material GLOW = matte(0, 0, 0).withRadiance(Rgb.gray(RADIANCE));

    /** The side of a pixel in the distance 10. */
    private static final double PIXEL = 20 * Math.tan(Math.toRadians(20)) / SIZE;

    private static Scene.Builder view() {
        return Scene.builder().size(SIZE, SIZE).shading(shading(0)).camera(EYE);
    }

    /** A ball of so many circles of latitude, and twice as many of longitude. */
    private static Scene.Builder mesh(Scene.Builder to, int n, Vec3 center, double radius) {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < 2 * n; j++) {
                if (i < n - 1) {
                    to.object(triangle(n, center, radius, i, j, i + 1, j, i + 1, j + 1), GLOW);
                }
                if (i > 0) {
                    to.object(triangle(n, center, radius, i, j, i + 1, j + 1, i, j + 1), GLOW);
                }
            }
        }
        return to;
    }

    private static Triangle triangle(int n, Vec3 center, double radius, int... at) {
        Vec3[] v = new Vec3[3];
        for (int k = 0; k < 3; k++) {
            double down = Math.PI * at[2 * k] / n;
            double around = Math.PI * (at[2 * k + 1] % (2 * n)) / n;
            v[k] = center.plus(
                    new Vec3(Math.sin(down) * Math.cos(around), Math.cos(down), Math.sin(down) * Math.sin(around))
                            .times(radius));
        }
        return new Triangle(at(v[0]), at(v[1]), at(v[2]));
    }

    /** The mesh is a ball around the pixel's corners: all rays through the pixel meet it, and it reflects nothing. */
    @Test
    void aPixelThatAGlowingMeshCoversHasItsRadianceWithoutNoise() {
        Vec3 center = new Vec3(-PIXEL / 2, PIXEL / 2, 10);
        Scene scene = mesh(view(), 20, center, 0.95 * PIXEL).build();
        for (BuiltInMethod method : BuiltInMethod.values()) {
            for (long seed = 1; seed <= 3; seed++) {
                double seen = Rendered.zoomed(scene, 1, 8, method, seed).component(1, 1, 0);
                assertEquals(RADIANCE, seen, 1e-5, method.word() + ", seed " + seed);
            }
        }
    }

    /** All that the picture's noise can come from are the edges of the ball, where each of n samples meets it or not: at most r²/4n. */
    @Test
    void aGlowingMeshHasNoMoreNoiseThanSamplesThatMeetItOrNot() {
        Scene scene = mesh(view(), 12, new Vec3(0.3, -0.4, 10), 0.9 * PIXEL).build();
        int seeds = 16;
        int samples = 8;
        List<Image> pictures = IntStream.rangeClosed(1, seeds)
                .mapToObj(seed -> Rendered.zoomed(scene, 1, samples, BuiltInMethod.RAYTRACE, seed))
                .toList();
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            double sum = 0;
            double squares = 0;
            for (Image picture : pictures) {
                double v = picture.component(pixel % SIZE, pixel / SIZE, 0);
                sum += v;
                squares += v * v;
            }
            double variance = (squares - sum * sum / seeds) / (seeds - 1);
            assertTrue(variance <= RADIANCE * RADIANCE / (4 * samples), "pixel " + pixel + ": " + variance);
        }
    }

    /** Behind faces that the eye sees are others that it does not: only those that it sees count, and together they are all of the box. */
    @Test
    void aGlowingBoxSmallerThanAPixelHasNoNoise() {
        Scene scene =
                view().object(new Box(at(0.5, 0.5, 10), at(1, 1, 10.5)), GLOW).build();
        Image large = Rendered.zoomed(scene, 64, 16, BuiltInMethod.RAYTRACE, 1);
        double expected = mean(large, 64, 2, 1);
        assertTrue(expected > 0.05 * RADIANCE && expected < 0.5 * RADIANCE, "seen: " + expected);
        for (long seed = 1; seed <= 3; seed++) {
            Image small = Rendered.zoomed(scene, 1, 8, BuiltInMethod.RAYTRACE, seed);
            assertEquals(expected, small.component(2, 1, 0), 0.005 * expected, "seed " + seed);
        }
    }

    private static double mean(Image image, int zoom, int column, int row) {
        double sum = 0;
        for (int y = zoom * row; y < zoom * (row + 1); y++) {
            for (int x = zoom * column; x < zoom * (column + 1); x++) {
                sum += image.component(x, y, 0);
            }
        }
        return sum / (zoom * zoom);
    }

    /** In the larger picture each lamp covers many pixels, or its edges, and camera rays alone find it. */
    @Test
    void theMeanIsTheSameHoweverSmallTheTrianglesAre() {
        Scene.Builder b = view().object(
                        TestScenes.rectangle(0.5, -4, 15, 0.5, -0.5, 15, 4, -0.5, 15, 4, -4, 15),
                        Material.Mirror.of(PhysicalScenes.linear(0.9, 0.9, 0.9)))
                .object(TestScenes.rectangle(-1, -1, 8, -1, 1.2, 8, -0.3, 1.2, 8, -0.3, -1, 8), matte(0, 0, 0))
                // A lamp smaller than a pixel before the mesh, and one apart.
                .light(sphereLight(-1.4, 0.9, 6, 0.02, 9000))
                .object(ball(2, 2, 10, 0.3), GLOW)
                .object(new Box(at(-3, -3, 10), at(-2.4, -2.5, 10.5)), GLOW);
        mesh(b, 3, new Vec3(-1.6, 1.3, 10), 1.5);
        mesh(b, 6, new Vec3(1.2, 0.5, 10), 0.4);
        mesh(b, 4, new Vec3(2.5, -2.6, -8), 1.5);
        Scene scene = b.build();
        int zoom = 64;
        Image large = Rendered.zoomed(scene, zoom, 16, BuiltInMethod.RAYTRACE, 1);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            Image small = Rendered.zoomed(scene, 1, 1 << 12, method, 2);
            for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                double expected = mean(large, zoom, pixel % SIZE, pixel / SIZE);
                double actual = small.component(pixel % SIZE, pixel / SIZE, 0);
                assertEquals(expected, actual, 0.03 * Math.max(expected, 1), method.word() + ", pixel " + pixel);
            }
        }
    }
}
