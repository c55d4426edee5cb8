package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** White things under the same light from everywhere are white (numerics, N29). */
class FurnaceTest {
    private static final Camera CAMERA =
            new Camera.Perspective(ExactPoint.of(0.31, 0.47, -4.13), ExactPoint.of(0.02, 0.01, 0), Vec3.Y, 40);
    private static final Shading.Classic ALL_AMBIENT = new Shading.Classic(1, 0, DisplayRgb.BLACK, 100_000);
    private static final Material WHITE = TestScenes.matte(1, 1, 1);

    /** A thing within a white ball; a ray that gets lost sees black. */
    private static Scene.Builder furnace(Shape thing, Material material) {
        return Scene.builder()
                .size(32, 32)
                .camera(CAMERA)
                .shading(ALL_AMBIENT)
                .object(Sphere.of(ExactPoint.of(0.2, -0.1, 0.3), 9), WHITE)
                .object(thing, material);
    }

    private static void assertWhite(Scene scene, double tolerance, String what) {
        DoublePicture p = DoublePicture.of(scene, 2, 4);
        assertEquals(1, p.least(), tolerance, what);
        assertEquals(1, p.greatest(), tolerance, what);
    }

    @Test
    void everyWhiteShapeIsExactlyWhite() {
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            assertWhite(furnace(e.getValue(), WHITE).build(), 0, e.getKey());
        }
    }

    @Test
    void anyNumberOfLightsKeepsWhiteExactlyWhite() {
        for (int n = 1; n <= 60; n++) {
            Scene.Builder b = furnace(Solids.solid().get("torus"), WHITE).size(4, 4);
            for (int i = 0; i < n; i++) {
                b.light(new Light.Point(ExactPoint.of(3, i * 0.1, -3), DisplayRgb.WHITE));
            }
            assertWhite(b.build(), 0, n + " lights");
        }
    }

    @Test
    void aMirrorOfAnyShapeShowsWhite() {
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            assertWhite(furnace(e.getValue(), TestScenes.mirror(1)).build(), 1e-12, e.getKey());
        }
    }

    @Test
    void clearGlassOfAnyShapeShowsWhite() {
        for (double ior : new double[] {1.5, 1, 1 + 1e-15, 1 - 1e-15, 0.5, 2.4, 1e6, 1e-6}) {
            for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
                if (ior == 1e6 && (e.getKey().equals("cone") || e.getKey().equals("frustum"))) {
                    // Light enters at right angles to one side of a wedge and can leave it at no other: it is trapped.
                    continue;
                }
                Material glass = Glass.of(Texture.of(DisplayRgb.WHITE), ior);
                assertWhite(furnace(e.getValue(), glass).build(), 1e-12, e.getKey() + " of index " + ior);
            }
        }
    }

    @Test
    void glassThatIsPartlyOpaqueShowsWhite() {
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            Material glass = new Glass(Texture.of(DisplayRgb.WHITE), 1.5, 0.3, 0, true);
            assertWhite(furnace(e.getValue(), glass).build(), 1e-12, e.getKey());
        }
    }

    @Test
    void insideALightEveryDirectionShowsItsColor() {
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            for (Material m : new Material[] {TestScenes.mirror(1), Glass.of(Texture.of(DisplayRgb.WHITE), 1.5)}) {
                Scene scene = inside(e.getValue(), m, ExactPoint.of(0.2, -0.1, 0.3), CAMERA);
                assertWhite(scene, 1e-12, e.getKey() + " " + m.type());
            }
        }
    }

    /** A thing and the camera within a ball of light, with nothing but direct light. */
    private static Scene inside(Shape thing, Material material, ExactPoint middle, Camera camera) {
        return Scene.builder()
                .size(32, 32)
                .camera(camera)
                .shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 100_000))
                .object(thing, material)
                .light(new Light.Sphere(middle, 9, DisplayRgb.WHITE))
                .build();
    }

    @Test
    void insideALightAConvexThingGetsAQuarterOfIt() {
        // Over all directions alike, the mean of max(cosθ, 0) is 1/4 and that of its square 1/6.
        double deviation = Math.sqrt(1.0 / 6 - 1.0 / 16);
        Camera close =
                new Camera.Perspective(ExactPoint.of(0.21, 0.27, -4.13), ExactPoint.of(0.05, 0.05, 0), Vec3.Y, 4);
        int shadowSamples = 64;
        for (Map.Entry<String, Shape> e : Solids.all().entrySet()) {
            if (e.getKey().equals("torus") || e.getKey().startsWith("open")) {
                continue;
            }
            for (ExactPoint middle : new ExactPoint[] {ExactPoint.of(0, 0, 0), ExactPoint.of(1.5, -2, 2.5)}) {
                DoublePicture p = DoublePicture.of(inside(e.getValue(), WHITE, middle, close), 1, shadowSamples);
                double sum = 0;
                for (int y = 0; y < p.height; y++) {
                    for (int x = 0; x < p.width; x++) {
                        sum += p.at(x, y, 0);
                    }
                }
                int pixels = p.width * p.height;
                double mean = sum / pixels;
                double sigma = deviation / Math.sqrt(shadowSamples);
                assertEquals(0.25, mean, 4 * sigma / Math.sqrt(pixels), e.getKey());
                assertTrue(p.least() > 0.25 - 6 * sigma && p.greatest() < 0.25 + 6 * sigma, e.getKey());
            }
        }
    }
}
