package enlightenment.world.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which faces are taken for coincident. */
class CoincidentSurfacesTest {
    private static final Material WHITE = Material.Matte.of(Texture.of(DisplayRgb.WHITE));
    private static final int SMALL = 200;

    /** With a negative half side the corners begin at the other end. */
    private static Rectangle flat(double x, double y, double z, double half) {
        return new Rectangle(
                ExactPoint.of(x - half, y, z - half),
                ExactPoint.of(x - half, y, z + half),
                ExactPoint.of(x + half, y, z + half),
                ExactPoint.of(x + half, y, z - half));
    }

    /**
     * A wide floor, and so small faces near the eye above or below it that the boxes of the hierarchy are not rounded to floats. The tolerance
     * of the floor is some 2⁻⁴⁷, theirs a 500th of it, and their gaps are from 2⁻⁵³ to 2⁻⁴⁵.
     */
    private static CompiledScene scene(double half, boolean withBvh) {
        double floor = -0x1p-10;
        Scene.Builder b = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, floor, 1), Vec3.Y, 40))
                .object(flat(0, floor, 0, half), WHITE);
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < SMALL; i++) {
            double gap = Math.scalb(1 + random.nextDouble(), -53 + i % 8);
            double x = Math.scalb(i % 20 - 9.5, -18);
            double z = Math.scalb(i / 20 - 4.5, -18);
            b.object(flat(x, i / 8 % 2 == 0 ? floor + gap : floor - gap, z, 0x1p-20), WHITE);
        }
        Scene scene = b.build();
        return SceneCompiler.compile(scene, RenderSettings.of(scene), withBvh);
    }

    private static Set<String> pairs(CompiledScene scene) {
        Set<String> pairs = new TreeSet<>();
        for (int id = 0; id < scene.primitives.length; id++) {
            CoincidentFaces of = scene.coincident.of(id);
            for (int k = 0; of != null && k < of.size(); k++) {
                pairs.add(id + "." + of.face(k) + " " + of.other(k) + "." + of.otherFace(k));
            }
        }
        return pairs;
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, 1})
    void theHierarchyFindsThoseThatLieWithinTheToleranceOfTheGreaterOneOnly(double half) {
        // The floor is the first primitive, or the last.
        Set<String> all = pairs(scene(half, false));
        assertTrue(
                all.size() > SMALL && all.size() < 2 * SMALL,
                all.size() + " of " + SMALL + " pairs, told from both sides");
        CompiledScene hierarchy = scene(half, true);
        assertTrue(hierarchy.accelerator.getClass().getSimpleName().equals("DoubleBvh"));
        assertEquals(all, pairs(hierarchy));
    }
}
