package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.frame.Bounds;
import enlightenment.geometry.Box;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SupportSurface;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.PhysicalLight;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What lights lie on, found by a hierarchy of boxes, against a loop over all primitives. */
class TouchedBoxesTest {
    private static final Material BLACK = Material.Matte.of(Texture.of(Rgb.BLACK));
    private static final Material GLOW =
            Material.Matte.of(Texture.of(Rgb.BLACK)).withRadiance(Rgb.WHITE);

    private static Scene.Builder empty() {
        return Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.BLACK));
    }

    /** Shapes at places of a coarse grid, so that many faces lie on others; some reach far. */
    private static Shape shape(SplittableRandom r) {
        double s = r.nextInt(8) == 0 ? 1000 : 1 + r.nextInt(2);
        double x = r.nextInt(6);
        double y = r.nextInt(6);
        double z = r.nextInt(6);
        return switch (r.nextInt(4)) {
            case 0 -> new Box(ExactPoint.of(x, y, z), ExactPoint.of(x + s, y + 1, z + 1));
            case 1 -> Sphere.of(ExactPoint.of(x, y, z), 1);
            case 2 -> new Triangle(ExactPoint.of(x, y, z), ExactPoint.of(x + s, y, z), ExactPoint.of(x, y + 1, z));
            default ->
                new Rectangle(
                        ExactPoint.of(x, y, z),
                        ExactPoint.of(x, y + 1, z),
                        ExactPoint.of(x + s, y + 1, z),
                        ExactPoint.of(x + s, y, z));
        };
    }

    private static Scene random(long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        Scene.Builder b = empty();
        for (int k = 0; k < 60; k++) {
            b.object(shape(r), r.nextBoolean() ? GLOW : BLACK);
        }
        for (int k = 0; k < 5; k++) {
            ExactPoint at = ExactPoint.of(r.nextInt(6), r.nextInt(6) + 0.5, r.nextInt(6) + 0.25);
            b.light(new Light.Point(at, Rgb.WHITE, Emission.power(Rgb.WHITE)));
        }
        return b.build();
    }

    /** What the definition says. */
    private static boolean liesOn(PhysicalLight light, Primitive p, int face) {
        Bounds own = light.bounds();
        Bounds box = p.bounds();
        double tolerance = CoincidentSurfaces.tolerance(own, box);
        if (!CoincidentSurfaces.widened(own, tolerance).overlaps(box)) {
            return false;
        }
        SupportSurface s = p.support(face);
        if (light.isPoint) {
            return s.passes(new Vec3(light.x, light.y, light.z), tolerance);
        }
        SupportSurface shape = light.surface.support(light.face);
        return s.coincides(shape, tolerance) && s.overlaps(shape, tolerance);
    }

    @Test
    void lightsLieOnTheFacesThatALoopOverAllPrimitivesFinds() {
        int found = 0;
        for (long seed = 1; seed <= 30; seed++) {
            Scene scene = random(seed);
            CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene), true);
            for (PhysicalLight light : compiled.physical.lights) {
                for (int id = 0; id < compiled.primitives.length; id++) {
                    for (int face = 0; face < compiled.primitives[id].faceCount(); face++) {
                        boolean expected = liesOn(light, compiled.primitives[id], face);
                        assertEquals(expected, light.lyingOn().has(id, face));
                        found += expected && id != light.id ? 1 : 0;
                    }
                }
            }
        }
        assertTrue(found > 300, "faces: " + found);
    }

    /** Each triangle of a sheet has few neighbours, however many there are. */
    @Test
    void aTriangleOfALargeMeshIsComparedWithFewOthers() {
        int n = 40;
        Scene.Builder b = empty();
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                double wave = (i + k) % 3;
                b.object(
                        new Triangle(
                                ExactPoint.of(i, k, wave), ExactPoint.of(i + 0.9, k, 0), ExactPoint.of(i, k + 0.9, 0)),
                        GLOW);
            }
        }
        Scene scene = b.build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        assertEquals(n * n, compiled.physical.lights.length);
        TouchedBoxes near = new TouchedBoxes(compiled.primitives, compiled.kind, 1, compiled.accelerator);
        long all = 0;
        for (PhysicalLight light : compiled.physical.lights) {
            int count = near.find(light.bounds());
            all += count;
            for (int k = 1; k < count; k++) {
                assertTrue(near.ids()[k - 1] < near.ids()[k]);
            }
        }
        // Boxes of neighbours do not touch: what is found is the light's own, and what is in a leaf with it, which has
        // at most 7 places.
        assertTrue(all <= 7L * n * n, all + " of " + n * n);
    }
}
