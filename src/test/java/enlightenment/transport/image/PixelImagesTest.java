package enlightenment.transport.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.ClippedPolygon;
import enlightenment.world.light.LightImage;
import enlightenment.world.light.PhysicalLight;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** Which images of a pixel are sampled apart, and how they are found again. */
class PixelImagesTest {
    private final List<LightImage> images = new ArrayList<>();

    private static PhysicalLight lamp(double radiance) {
        Scene scene = Scene.builder()
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -9), ExactPoint.of(0, 0, 0), Vec3.Y, 60))
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.BLACK))
                .light(new Light.Sphere(ExactPoint.of(0, 0, 5), 1, Rgb.WHITE, Emission.radiance(Rgb.gray(radiance))))
                .build();
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        return compiled.physical.lights[0];
    }

    /** Adds images of a radiance that are strips across the pixel (3, 2), of so much of its area. */
    private void add(int count, double radiance, double area) {
        PhysicalLight from = lamp(radiance);
        for (int k = 0; k < count; k++) {
            double[] x = {2.5, 4.5, 4.5, 2.5};
            double[] y = {2.1, 2.1, 2.1 + area, 2.1 + area};
            images.add(new LightImage(images.size(), from, x, y));
        }
    }

    private PixelImages pixel() {
        return PixelImages.of(3, 2, images.toArray(new LightImage[0]), images.size(), new ClippedPolygon());
    }

    @Test
    void manyImagesThatAreNoMoreThanThePixelTogetherAreAllTaken() {
        add(9, 5, 0.1);
        assertEquals(9, pixel().count);
    }

    @Test
    void noneOfManyEqualImagesThatAreMoreThanThePixelTogetherIsTaken() {
        add(11, 5, 0.1);
        assertEquals(0, pixel().count);
    }

    @Test
    void brightLampsBeforeManyDimmerOnesAreTakenAlone() {
        add(11, 5, 0.1);
        add(2, 300, 0.05);
        PixelImages p = pixel();
        assertEquals(2, p.count);
        p.choose(0.1, 0.5);
        assertEquals(11, p.chosen.image.light);
        // Two of area 0.05 and equal radiance: so much area, wherever one of them is met.
        assertEquals(0.1, p.share, 1e-12);
    }

    /** A lamp that is about as bright as what is behind it is no better sampled apart. */
    @Test
    void lampsLittleBrighterThanThoseLeftOutAreLeftOutToo() {
        add(11, 5, 0.1);
        add(2, 9, 0.05);
        assertEquals(0, pixel().count);
    }

    @Test
    void fewImagesAreAllTaken() {
        add(4, 5, 0.6);
        assertEquals(4, pixel().count);
    }

    @Test
    void anImageIsChosenByItsAreaAndRadiance() {
        add(5, 1, 0.01);
        add(5, 2, 0.02);
        PixelImages p = pixel();
        int[] chosen = new int[10];
        for (int k = 0; k < 250; k++) {
            p.choose((k + 0.5) / 250, 0.5);
            chosen[p.chosen.image.light]++;
        }
        for (int k = 0; k < 10; k++) {
            assertEquals(k < 5 ? 10 : 40, chosen[k], "image " + k);
        }
    }

    @Test
    void theImagesOfALightAreFoundByIt() {
        add(6, 5, 0.1);
        PixelImages p = pixel();
        for (int light = 0; light < 6; light++) {
            int first = p.firstOf(light);
            assertSame(images.get(light), p.of(light, first).image);
            assertNull(p.of(light, first + 1));
        }
        assertNull(p.of(-1, p.firstOf(-1)));
        assertNull(p.of(6, p.firstOf(6)));
    }
}
